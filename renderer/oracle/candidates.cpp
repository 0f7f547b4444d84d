// SPDX-License-Identifier: Apache-2.0
#include "oracle/candidates.h"

#include <embree3/rtcore.h>

#include <cmath>
#include <glm/gtx/component_wise.hpp>
#include <limits>

#include "error.h"

namespace umbrage::oracle {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

// Boxes live in a cube of half size 1; rays begin within kReach of its centre. What rounds there, in each coordinate:
// the given origin by kTolerance, its float by 2^-23, the direction's by 2^-25 of at most 8. Together less than half of
// what boxes are grown by; traversal itself is conservative.
constexpr double kGrowth = 0x1p-18, kTolerance = 0x1p-21, kReach = 4.0;

// In half sizes of the cube: from there on doubles are too coarse to bring rays into it.
constexpr double kFar = 0x1p26;

}  // namespace

struct Candidates::Impl {
    struct Traversal {
        RTCIntersectContext context;  // first: Embree hands back a pointer to it
        Call call;
        void* what;
        double unitsPerLength, start;  // from distance along the ray in the cube to units of its direction
    };

    std::span<const Corners> corners;
    glm::dvec3 centre{0.0};
    double scale = 1.0;
    RTCDevice device = nullptr;
    RTCScene scene = nullptr;

    ~Impl() {
        if (scene) rtcReleaseScene(scene);
        if (device) rtcReleaseDevice(device);
    }

    void fit();
    void build();
    static void bounds(const RTCBoundsFunctionArguments* arguments);
    static void intersect(const RTCIntersectFunctionNArguments* arguments);
};

/// A power of two, so that nothing is rounded that matters, takes everything into the cube.
void Candidates::Impl::fit() {
    glm::dvec3 low(std::numeric_limits<double>::max()), high(-low);
    for (const Corners& t : corners) {
        for (const glm::dvec3& p : t) {
            low = glm::min(low, p);
            high = glm::max(high, p);
        }
    }
    if (corners.empty()) return;
    centre = 0.5 * low + 0.5 * high;
    const glm::dvec3 half = 0.5 * high - 0.5 * low;
    const double most = std::max({half.x, half.y, half.z});
    if (most > 0.0) scale = std::ldexp(1.0, std::min(-std::ilogb(most) - 1, 1023));
}

void Candidates::Impl::bounds(const RTCBoundsFunctionArguments* arguments) {
    const Impl& self = *static_cast<const Impl*>(arguments->geometryUserPtr);
    glm::dvec3 low(kReach), high(-kReach);
    for (const glm::dvec3& p : self.corners[arguments->primID]) {
        const glm::dvec3 q = (p - self.centre) * self.scale;
        low = glm::min(low, q);
        high = glm::max(high, q);
    }
    const glm::vec3 a(low - kGrowth), b(high + kGrowth);
    *arguments->bounds_o = {a.x, a.y, a.z, 0.0f, b.x, b.y, b.z, 0.0f};
}

void Candidates::Impl::intersect(const RTCIntersectFunctionNArguments* arguments) {
    if (!arguments->valid[0]) return;
    Traversal& traversal = *reinterpret_cast<Traversal*>(arguments->context);
    const double left = traversal.call(traversal.what, arguments->primID);
    RTCRay& ray = reinterpret_cast<RTCRayHit*>(arguments->rayhit)->ray;
    // The farther end is rounded outward, as boxes are.
    const double end = (left - traversal.start) / traversal.unitsPerLength;
    ray.tfar = left < 0.0 ? -kInfinity : std::min(ray.tfar, float(end * (1.0 + kGrowth) + kGrowth));
}

void Candidates::Impl::build() {
    device = rtcNewDevice("threads=0");
    if (!device) throw Error(ErrorKind::Device, "", "Embree cannot be started", "the oracle needs libembree3");
    scene = rtcNewScene(device);
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
    const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(geometry, unsigned(corners.size()));
    rtcSetGeometryUserData(geometry, this);
    rtcSetGeometryBoundsFunction(
        geometry, [](const RTCBoundsFunctionArguments* a) { bounds(a); }, nullptr);
    rtcSetGeometryIntersectFunction(geometry, intersect);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene);
    if (rtcGetDeviceError(device) != RTC_ERROR_NONE) {
        throw Error(ErrorKind::Device, "", "Embree cannot build its hierarchy", "the scene may need too much memory");
    }
}

Candidates::Candidates(std::span<const Corners> corners) : impl_(std::make_unique<Impl>()) {
    impl_->corners = corners;
    impl_->fit();
    impl_->build();
}

Candidates::~Candidates() = default;

double Candidates::tolerance() const {
    return kTolerance / impl_->scale;
}

void Candidates::visitAll(Call call, void* what) const {
    for (std::uint32_t i = 0; i < impl_->corners.size(); ++i) {
        if (call(what, i) < 0.0) return;
    }
}

void Candidates::traverse(const Ray& ray, double length, Call call, void* what) const {
    const double size = glm::length(ray.direction);
    const double farthest = glm::compMax(glm::max(glm::abs(ray.origin), glm::abs(impl_->centre)));
    const bool fits = size > 1e-100 && size < 1e100 && farthest * impl_->scale < kFar;
    if (!fits) return visitAll(call, what);
    const glm::dvec3 direction = ray.direction / size;
    glm::dvec3 origin = (ray.origin - impl_->centre) * impl_->scale;
    const double unitsPerLength = 1.0 / (size * impl_->scale);
    // A far origin would cost the bits that matter: begin near the cube, in double.
    double skipped = 0.0;
    if (glm::length(origin) > kReach) skipped = std::max(0.0, -glm::dot(origin, direction) - 0.5 * kReach);
    origin += skipped * direction;
    const double start = skipped * unitsPerLength;
    if (length < start) return;

    Impl::Traversal traversal{{}, call, what, unitsPerLength, start};
    rtcInitIntersectContext(&traversal.context);
    RTCRayHit hit{};
    hit.ray.org_x = float(origin.x);
    hit.ray.org_y = float(origin.y);
    hit.ray.org_z = float(origin.z);
    hit.ray.dir_x = float(direction.x);
    hit.ray.dir_y = float(direction.y);
    hit.ray.dir_z = float(direction.z);
    hit.ray.tnear = 0.0f;
    hit.ray.tfar = float((length - start) / unitsPerLength * (1.0 + kGrowth) + kGrowth);
    hit.ray.mask = ~0u;
    hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(impl_->scene, &traversal.context, &hit);
}

}  // namespace umbrage::oracle
