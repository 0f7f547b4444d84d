// SPDX-License-Identifier: Apache-2.0
#include "oracle/oracle.h"

#include <cmath>
#include <limits>

namespace umbrage::oracle {
namespace {

constexpr double kForever = std::numeric_limits<double>::infinity();

/// The ray from the (rounded) point to the light, as long as the way to it: for finding candidates only.
struct Way {
    Ray ray;
    double length;
};

Way wayTo(const glm::dvec4& light, const glm::dvec3& from) {
    if (light.w == 0.0) return {{from, glm::dvec3(light)}, kForever};
    return {{from, glm::dvec3(light) - from}, 1.0};
}

}  // namespace

EyeRays::EyeRays(const PlacedCamera& placed, int width, int height)
    : eye_(placed.worldFromCamera[3]),
      right_(placed.worldFromCamera[0]),
      up_(placed.worldFromCamera[1]),
      forward_(-placed.worldFromCamera[2]),
      pixelSize_(2.0 / width, 2.0 / height),
      perspective_(placed.camera.perspective),
      near_(placed.camera.znear),
      far_(placed.camera.zfar > 0.0 ? placed.camera.zfar : kForever) {
    const double halfHeight = perspective_ ? std::tan(0.5 * placed.camera.yfov) : placed.camera.ymag;
    halfExtent_ = {halfHeight * width / height, halfHeight};
}

EyeRay EyeRays::at(double x, double y) const {
    const double u = (x * pixelSize_.x - 1.0) * halfExtent_.x, v = (1.0 - y * pixelSize_.y) * halfExtent_.y;
    const glm::dvec3 aside = u * right_ + v * up_;
    EyeRay ray;
    ray.origin = perspective_ ? eye_ : eye_ + aside;
    ray.direction = perspective_ ? forward_ + aside : forward_;
    ray.near = near_;
    ray.far = far_;
    return ray;
}

glm::dvec4 placeOf(const PlacedLight& light) {
    return light.light.type == LightType::Directional ? glm::dvec4(-light.direction, 0.0)
                                                      : glm::dvec4(light.position, 1.0);
}

Oracle::Oracle(std::vector<Triangle> triangles) : triangles_(std::move(triangles)) {
    corners_.reserve(triangles_.size());
    for (const Triangle& triangle : triangles_) corners_.push_back(triangle.corners);
    candidates_ = std::make_unique<Candidates>(corners_);
}

std::uint32_t Oracle::see(const EyeRay& ray, std::uint32_t solid) const {
    std::uint32_t nearest = kNothing;
    double length = ray.far;
    Bounded best;  // distance of the nearest
    candidates_->along(ray, ray.far, [&](std::uint32_t i) {
        const Triangle& t = triangles_[i];
        if (!t.visible || (t.holed && i != solid)) return length;
        if (!meets(ray, t.corners)) return length;
        const int side = sideOfRay(t.corners, ray);
        if (side == 0 || (side < 0 && t.singleSided)) return length;
        const Bounded distance = distanceAlong(ray, t.corners);
        // Distances of places on the ray, in doubles where these decide.
        const auto order = [&](const Bounded& other, const auto& exactly) {
            const Bounded difference = distance - other;
            return difference.signKnown() ? difference.sign() : compareDepth(ray, t.corners, exactly);
        };
        if (order(ray.near, ray.near) < 0) return length;
        if (ray.far < kForever && order(ray.far, ray.far) > 0) return length;
        if (nearest != kNothing) {
            const int later = order(best, corners_[nearest]);
            if (later > 0 || (later == 0 && i > nearest)) return length;
        }
        nearest = i;
        best = distance;
        length = std::min(length, distance.value + distance.error);
        return length;
    });
    return nearest;
}

double Oracle::distanceTo(std::uint32_t seen, const Ray& ray) const {
    return distanceAlong(ray, corners_[seen]).value;
}

bool Oracle::turnedTo(const glm::dvec4& light, std::uint32_t seen, const Ray& ray) const {
    const Corners& t = triangles_[seen].corners;
    const int side = sideOfLight(t, light);
    return side != 0 && side == sideOfRay(t, ray);
}

template <class Visit>
void Oracle::towards(const glm::dvec4& light, std::uint32_t seen, const Ray& ray, const Visit& visit) const {
    const SurfacePoint point(ray, corners_[seen]);
    const Way way = wayTo(light, point.position(candidates_->tolerance()));
    candidates_->along(way.ray, way.length,
                       [&](std::uint32_t i) { return !triangles_[i].casts || visit(i, point) ? way.length : -1.0; });
}

std::uint32_t Oracle::hiddenBy(const glm::dvec4& light, std::uint32_t seen, const Ray& ray) const {
    std::uint32_t found = kNothing;
    towards(light, seen, ray, [&](std::uint32_t i, const SurfacePoint& point) {
        if (i != seen && point.hiddenBy(corners_[i], light)) found = i;
        return found == kNothing;
    });
    return found;
}

std::uint32_t Oracle::layersBefore(const glm::dvec4& light, std::uint32_t seen, const Ray& ray) const {
    std::uint32_t layers = 0;
    towards(light, seen, ray, [&](std::uint32_t i, const SurfacePoint& point) {
        layers += i != seen && point.hiddenBy(corners_[i], light);
        return true;
    });
    return layers;
}

std::uint32_t Oracle::volumesAround(const glm::dvec4& light, std::uint32_t seen, const Ray& ray) const {
    std::uint32_t volumes = 0;
    towards(light, seen, ray, [&](std::uint32_t i, const SurfacePoint& point) {
        volumes += (i != seen && point.hiddenBy(corners_[i], light)) || point.shadedSideOf(corners_[i], light);
        return true;
    });
    return volumes;
}

}  // namespace umbrage::oracle
