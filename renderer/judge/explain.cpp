// SPDX-License-Identifier: Apache-2.0
#include "judge/explain.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>

namespace umbrage {

using oracle::Corners;
using oracle::EyeRay;
using oracle::kNothing;
using oracle::Ray;

namespace {

glm::dvec3 normalOf(const Corners& t) {
    return glm::cross(t[1] - t[0], t[2] - t[0]);
}

/// Where the ray meets the triangle's plane, along the ray; not finite where it does not.
double distanceTo(const Corners& t, const Ray& ray) {
    const glm::dvec3 n = normalOf(t);
    return glm::dot(n, t[0] - ray.origin) / glm::dot(n, ray.direction);
}

/// The way from p to the light.
glm::dvec3 towards(const glm::dvec4& light, const glm::dvec3& p) {
    return glm::dvec3(light) - light.w * p;
}

struct Range {
    double low = HUGE_VAL, high = -HUGE_VAL;

    void add(double value, double slack) {
        low = std::min(low, value - slack);
        high = std::max(high, value + slack);
    }
    bool holdsZero() const { return low <= 0.0 && high >= 0.0; }
};

/// Whether a point may be inside of three edges, given the ranges of their functions.
bool mayBeInside(const std::array<Range, 3>& edges) {
    return std::ranges::all_of(edges, [](const Range& r) { return r.high >= 0.0; }) ||
           std::ranges::all_of(edges, [](const Range& r) { return r.low <= 0.0; });
}

/// The same for both directions.
std::size_t edgeHash(const glm::dvec3& a, const glm::dvec3& b) {
    const auto hash = [](const glm::dvec3& p) {
        std::size_t h = 0;
        for (int k = 0; k < 3; ++k) h = h * 0x9e3779b97f4a7c15u + std::hash<double>()(p[k]);
        return h ^ h >> 29;
    };
    return hash(a) + hash(b);
}

double largestOf(const glm::dvec3& v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

}  // namespace

JudgedLight::JudgedLight(const PlacedLight& placed)
    : place(oracle::placeOf(placed)),
      on(placed.light.intensity > 0.0f && largestOf(glm::dvec3(placed.light.color)) > 0.0),
      range(placed.light.type == LightType::Directional ? 0.0 : placed.light.rangeMetres),
      spot(placed.light.type == LightType::Spot),
      direction(placed.direction),
      cosOuterCone(std::cos(double(placed.light.outerConeAngle))) {}

bool JudgedLight::arrives(const glm::dvec3& p, double slack) const {
    if (place.w == 0.0) return true;
    const glm::dvec3 way = p - glm::dvec3(place);
    const double distance = glm::length(way);
    if (range > 0.0 && distance >= range * (1.0 + slack)) return false;
    return !spot || glm::dot(way, direction) > distance * (cosOuterCone - slack);
}

Exactly exactly(const oracle::Oracle& oracle, const JudgedLight& light, std::uint32_t seen, const Ray& ray) {
    if (seen == kNothing || !light.on || !oracle.turnedTo(light.place, seen, ray)) return {};
    if (!light.arrives(ray.origin + distanceTo(oracle[seen].corners, ray) * ray.direction)) return {};
    return {true, oracle.hiddenBy(light.place, seen, ray) == kNothing};
}

/// The points of a surface that a sample may show: four corners beside it, each nearer and farther.
struct Explainer::Patch {
    EyeRay ray;
    std::array<glm::dvec3, 8> points;
    glm::dvec3 centre{0.0};
    bool valid = true;  // false: the surface is seen edge-on, or cut by the near plane, within the tolerance
    double radius = 0.0;
    double rounding = 0.0;  // of positions there, metres
};

struct Explainer::Edges {
    std::once_flag made;
    std::vector<std::pair<std::size_t, std::uint32_t>> sorted;  // hash of the end points, 3 * triangle + edge
};

Explainer::Explainer(const oracle::Oracle& oracle, const oracle::EyeRays& rays, const Tolerance& tolerance,
                     double farthest)
    : oracle_(oracle), rays_(rays), tolerance_(tolerance), farthest_(farthest), edges_(std::make_shared<Edges>()) {}

bool Explainer::grazing(const JudgedLight& light, std::uint32_t seen, const Ray& ray) const {
    if (seen == kNothing) return false;
    const Corners& t = oracle_[seen].corners;
    const glm::dvec3 n = normalOf(t), way = towards(light.place, ray.origin + distanceTo(t, ray) * ray.direction);
    return !(std::abs(glm::dot(n, way)) > tolerance_.grazing * glm::length(n) * glm::length(way));
}

/// The surface the renderer claims to see may be what a sample within the tolerance shows: it is there, and not behind
/// what the oracle sees.
bool Explainer::plausible(const Sample& sample) const {
    if (sample.claimed == kNothing) return false;  // then some ray nearby sees nothing
    const Corners& t = oracle_[sample.claimed].corners;
    std::array<Range, 3> edges;
    double nearest = HUGE_VAL, hiding = 0.0;
    for (const double dx : {-1.0, 1.0}) {
        for (const double dy : {-1.0, 1.0}) {
            const double step = tolerance_.lateralPixels;
            const EyeRay ray = rays_.at(sample.x + dx * step, sample.y + dy * step);
            for (std::size_t k = 0; k < 3; ++k) {
                const glm::dvec3 a = t[k] - ray.origin, b = t[(k + 1) % 3] - ray.origin;
                const double rounding = tolerance_.position * std::max(largestOf(a), largestOf(b));
                const glm::dvec3 ad = glm::cross(a, ray.direction), bd = glm::cross(b, ray.direction);
                edges[k].add(glm::dot(ray.direction, glm::cross(a, b)), rounding * (glm::length(ad) + glm::length(bd)));
            }
            const double distance = distanceTo(t, ray);
            if (!(distance > 0.0)) return true;  // seen edge-on: it is a line there
            nearest = std::min(nearest, distance);
            if (sample.seen != kNothing) {
                const double other = distanceTo(oracle_[sample.seen].corners, ray);
                if (!(other > 0.0)) return true;
                hiding = std::max(hiding, other);
            }
        }
    }
    const double depth = tolerance_.depth * farthest_;
    return mayBeInside(edges) && (sample.seen == kNothing || nearest <= hiding + depth + tolerance_.position * hiding);
}

Explainer::Patch Explainer::patchOf(const Sample& sample, std::uint32_t seen) const {
    Patch patch;
    const Corners& t = oracle_[seen].corners;
    const EyeRay middle = rays_.at(sample.x, sample.y);
    const double e = distanceTo(t, middle);
    patch.ray = middle;
    patch.centre = middle.origin + e * middle.direction;
    // Two quanta of depth at the farthest point of the polygon that can be in view.
    double last = e;
    for (const glm::dvec3& p : t) last = std::max(last, glm::dot(p - middle.origin, rays_.forward()));
    const double depth = tolerance_.depth * std::min(last, std::max(e, farthest_));
    patch.rounding = tolerance_.position * std::max(largestOf(patch.centre - middle.origin), e);
    // The polygon's corners are snapped, so at one place of the picture it has any depth that it has beside it.
    std::array<EyeRay, 4> rays;
    Range depths;
    for (std::size_t i = 0; i < 4; ++i) {
        const double step = tolerance_.lateralPixels;
        rays[i] = rays_.at(sample.x + (i % 2 ? step : -step), sample.y + (i / 2 ? step : -step));
        const double distance = distanceTo(t, rays[i]);
        if (!(distance > 0.0 && distance < 2.0 * e)) patch.valid = false;
        depths.add(distance, depth);
    }
    // There all depths before it are the same, its own as well.
    if (depths.low <= middle.near && middle.near <= depths.high) patch.valid = false;
    for (std::size_t i = 0; i < 8; ++i) {
        patch.points[i] = rays[i / 2].origin + (i % 2 ? depths.high : depths.low) * rays[i / 2].direction;
        patch.radius = std::max(patch.radius, glm::length(patch.points[i] - patch.centre));
    }
    return patch;
}

bool Explainer::onRangeOrCone(const JudgedLight& light, const Patch& patch) const {
    constexpr double kSlack = 0x1p-20;  // the device computes both in floats
    bool some = light.arrives(patch.centre, kSlack), all = light.arrives(patch.centre, -kSlack);
    for (const glm::dvec3& p : patch.points) {
        some = some || light.arrives(p, kSlack);
        all = all && light.arrives(p, -kSlack);
    }
    return some && !all;
}

const std::vector<std::pair<std::size_t, std::uint32_t>>& Explainer::edges() const {
    std::call_once(edges_->made, [this] {
        for (std::uint32_t i = 0; i < oracle_.triangles().size(); ++i) {
            if (!oracle_[i].casts) continue;
            for (std::uint32_t k = 0; k < 3; ++k) {
                edges_->sorted.emplace_back(edgeHash(oracle_[i].corners[k], oracle_[i].corners[(k + 1) % 3]),
                                            3 * i + k);
            }
        }
        std::ranges::sort(edges_->sorted);
    });
    return edges_->sorted;
}

bool Explainer::mayBeSilhouette(const JudgedLight& light, std::uint32_t triangle, std::size_t edge) const {
    const Corners& t = oracle_[triangle].corners;
    const glm::dvec3 &a = t[edge], &b = t[(edge + 1) % 3];
    const auto& all = edges();
    int sum = 0;
    for (auto it = std::ranges::lower_bound(all, std::pair(edgeHash(a, b), 0u));
         it != all.end() && it->first == edgeHash(a, b); ++it) {
        const Corners& other = oracle_[it->second / 3].corners;
        const glm::dvec3 &c = other[it->second % 3], &d = other[(it->second % 3 + 1) % 3];
        const bool along = c == a && d == b, against = c == b && d == a;
        if (!along && !against) continue;  // another edge with the same hash
        const glm::dvec3 n = normalOf(other), way = towards(light.place, other[0]);
        const double side = glm::dot(n, way);
        if (!(std::abs(side) > tolerance_.grazing * glm::length(n) * glm::length(way))) return true;
        sum += (side > 0.0) == along ? 1 : -1;
    }
    return sum != 0;
}

/// Whether a triangle goes on with the receiver's surface: in its plane, or joined to it and seen from the same side.
/// What lies a little below a surface is hidden by the surface itself, which excuses nothing.
bool Explainer::continues(const Corners& t, const Corners& receiver, const Patch& patch) const {
    const glm::dvec3 normal = glm::normalize(normalOf(receiver));
    const bool coplanar = std::ranges::all_of(
        t, [&](const glm::dvec3& p) { return std::abs(glm::dot(normal, p - receiver[0])) <= patch.rounding; });
    const bool joined =
        std::ranges::any_of(t, [&](const glm::dvec3& p) { return std::ranges::find(receiver, p) != receiver.end(); });
    const glm::dvec3 direction = patch.ray.direction;
    return coplanar || (joined && glm::dot(normalOf(t), direction) * glm::dot(normal, direction) > 0.0);
}

/// Every beam touches an edge that the light lies on, at its very end, which does not count: the way is open there.
bool Explainer::endsOn(const JudgedLight& light, const glm::dvec3& a, const glm::dvec3& b) const {
    if (light.place.w == 0.0) return false;
    const glm::dvec3 l(light.place);
    const glm::dvec3 nearest = a + glm::clamp(glm::dot(l - a, b - a) / glm::dot(b - a, b - a), 0.0, 1.0) * (b - a);
    return !(glm::length(l - nearest) > tolerance_.position * largestOf(l - rays_.eye()));
}

/// Whether the beam from the patch to the light touches an edge of the shadow's outline, or the patch a caster's plane.
bool Explainer::nearSilhouette(const JudgedLight& light, std::uint32_t seen, const Patch& patch) const {
    const Corners& receiver = oracle_[seen].corners;
    const glm::dvec3 way = towards(light.place, patch.centre);
    const double length = glm::length(way);
    const glm::dvec3 unit = way / length;
    for (std::uint32_t i = 0; i < oracle_.triangles().size(); ++i) {
        const oracle::Triangle& caster = oracle_[i];
        if (!caster.casts) continue;
        const Corners& t = caster.corners;
        // The beam is no wider than the patch: far from its axis nothing touches it.
        const glm::dvec3 middle = (t[0] + t[1] + t[2]) / 3.0, from = middle - patch.centre;
        double size = 0.0;
        for (const glm::dvec3& p : t) size = std::max(size, glm::length(p - middle));
        const double rounding = std::max(patch.rounding, tolerance_.position * largestOf(t[0] - rays_.eye()));
        const double reach = size + patch.radius + 4.0 * rounding;
        const double along = glm::dot(from, unit);
        if (glm::length(from - along * unit) > reach || along < -reach) continue;
        if (light.place.w != 0.0 && along > length + reach) continue;

        std::array<Range, 3> edges;
        Range atPoint;
        const glm::dvec3 n = normalOf(t);
        for (const glm::dvec3& p : patch.points) {
            const glm::dvec3 r = towards(light.place, p);
            for (std::size_t k = 0; k < 3; ++k) {
                const glm::dvec3 a = t[k] - p, b = t[(k + 1) % 3] - p;
                const double slack = glm::length(glm::cross(a, r)) + glm::length(glm::cross(b, r)) +
                                     light.place.w * glm::length(glm::cross(a, b));
                edges[k].add(glm::dot(r, glm::cross(a, b)), rounding * slack);
            }
            atPoint.add(glm::dot(n, t[0] - p), rounding * glm::length(n));
        }
        if (!mayBeInside(edges)) continue;
        const double atLight =
            glm::dot(n, light.place.w != 0.0 ? glm::dvec3(light.place) - t[0] : glm::dvec3(light.place));
        if (atLight > 0.0 ? atPoint.high < 0.0 : atPoint.low > 0.0) continue;    // beside or behind the receiver
        if (atPoint.holdsZero() && !continues(t, receiver, patch)) return true;  // the caster passes through the patch
        for (std::size_t k = 0; k < 3; ++k) {
            if (edges[k].holdsZero() && !endsOn(light, t[k], t[(k + 1) % 3]) && mayBeSilhouette(light, i, k))
                return true;
        }
    }
    return false;
}

bool Explainer::onBoundary(const JudgedLight& light, const Sample& sample, std::uint32_t seen) const {
    if (seen == kNothing) return false;
    const Patch patch = patchOf(sample, seen);
    return !patch.valid || onRangeOrCone(light, patch) || nearSilhouette(light, seen, patch);
}

SampleVerdict Explainer::explain(const JudgedLight& light, const Sample& sample,
                                 const Answers& answersAsClaimed) const {
    if (grazing(light, sample.seen, rays_.at(sample.x, sample.y))) return SampleVerdict::Grazing;
    for (const double dx : {-1.0, 0.0, 1.0}) {
        for (const double dy : {-1.0, 0.0, 1.0}) {
            const double step = tolerance_.lateralPixels;
            const EyeRay ray = rays_.at(sample.x + dx * step, sample.y + dy * step);
            const std::uint32_t seen = oracle_.see(ray, sample.claimed);
            if (answersAsClaimed(seen, ray) || (seen != sample.seen && grazing(light, seen, ray))) {
                return seen != sample.seen ? SampleVerdict::Primary : SampleVerdict::Boundary;
            }
        }
    }
    if (sample.claimed != sample.seen && plausible(sample)) {
        const EyeRay ray = rays_.at(sample.x, sample.y);
        if (grazing(light, sample.claimed, ray) || answersAsClaimed(sample.claimed, ray) ||
            onBoundary(light, sample, sample.claimed)) {
            return SampleVerdict::Primary;
        }
    }
    return onBoundary(light, sample, sample.seen) ? SampleVerdict::Boundary : SampleVerdict::FalseLit;
}

SampleVerdict Explainer::explainMask(const JudgedLight& light, const Sample& sample, bool claim) const {
    const SampleVerdict verdict = explain(light, sample, [&](std::uint32_t seen, const EyeRay& ray) {
        return exactly(oracle_, light, seen, ray).reaches == claim;
    });
    return isHard(verdict) && !claim ? SampleVerdict::FalseDark : verdict;
}

bool Explainer::explainsCount(const JudgedLight& light, const Sample& sample,
                              const std::function<bool(std::uint32_t)>& claimed) const {
    return !isHard(explain(light, sample, [&](std::uint32_t seen, const EyeRay& ray) {
        return seen != kNothing && claimed(oracle_.volumesAround(light.place, seen, ray));
    }));
}

bool Explainer::changesNearby(const JudgedLight& light, const Sample& sample, bool exact) const {
    for (const double dx : {-1.0, 1.0}) {
        for (const double dy : {-1.0, 1.0}) {
            const double step = tolerance_.lateralPixels;
            const EyeRay ray = rays_.at(sample.x + dx * step, sample.y + dy * step);
            if (exactly(oracle_, light, oracle_.see(ray, sample.claimed), ray).reaches != exact) return true;
        }
    }
    return false;
}

}  // namespace umbrage
