// SPDX-License-Identifier: Apache-2.0
#include "shadow/bounds.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace umbrage {

BoxCorners cornersOf(const Geometry::Bounds& box) {
    BoxCorners corners;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        corners[i] = {i & 1 ? box.high.x : box.low.x, i & 2 ? box.high.y : box.low.y, i & 4 ? box.high.z : box.low.z};
    }
    return corners;
}

std::vector<bool> nearerThanNearPlane(const Geometry& geometry, std::span<const Geometry::Bounds> modelBounds,
                                      const Eye& eye) {
    std::vector<bool> nearer(modelBounds.size());
    for (std::size_t i = 0; i < modelBounds.size(); ++i) {
        const glm::dmat4 viewFromModel = eye.viewFromWorld * geometry.worldFromModel(i);
        const auto& [low, high] = modelBounds[i];
        double nearest = viewFromModel[3][2];  // the largest z in view space: minus the least distance
        for (int k = 0; k < 3; ++k) nearest += std::max(viewFromModel[k][2] * low[k], viewFromModel[k][2] * high[k]);
        nearer[i] = -nearest <= eye.znear * (1.0 + 1e-6);
    }
    return nearer;
}

std::vector<Geometry::Bounds> worldBounds(const Geometry& geometry, std::span<const Geometry::Bounds> modelBounds) {
    std::vector<Geometry::Bounds> boxes(modelBounds.begin(), modelBounds.end());
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        const glm::dmat4& m = geometry.worldFromModel(i);
        const glm::dvec3 half = 0.5 * (modelBounds[i].high - modelBounds[i].low);
        const glm::dvec3 center(m * glm::dvec4(0.5 * (modelBounds[i].high + modelBounds[i].low), 1.0));
        glm::dvec3 extent(0.0);
        for (int k = 0; k < 3; ++k) extent += glm::abs(glm::dvec3(m[k])) * half[k];
        boxes[i] = {center - extent, center + extent};
    }
    return boxes;
}

Geometry::Bounds boxOf(const LightReach& reach) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    Geometry::Bounds box{glm::dvec3(-kInfinity), glm::dvec3(kInfinity)};
    if (reach.light.w == 0.0) return box;
    const double farthest = reach.rangeMetres > 0.0 ? reach.rangeMetres : kInfinity;
    /// From the light along a direction that is `cosine` away from the axis.
    const auto along = [&](double cosine) {
        const double fromCone = std::max(std::acos(std::clamp(cosine, -1.0, 1.0)) - reach.coneAngle, 0.0);
        return fromCone < 0.5 * std::numbers::pi ? farthest * std::cos(fromCone) : 0.0;
    };
    for (int k = 0; k < 3; ++k) {
        box.low[k] = reach.light[k] - along(-reach.axis[k]);
        box.high[k] = reach.light[k] + along(reach.axis[k]);
    }
    return box;
}

bool outOfReach(const Geometry::Bounds& worldBox, const LightReach& reach) {
    if (reach.light.w == 0.0) return false;
    const glm::dvec3 light(reach.light), nearest = glm::clamp(light, worldBox.low, worldBox.high);
    // Margins beyond what floats can confuse.
    if (reach.rangeMetres > 0.0 && glm::distance(nearest, light) > reach.rangeMetres * (1.0 + 1e-5)) return true;
    const glm::dvec3 towards = 0.5 * (worldBox.low + worldBox.high) - light;
    const double distance = glm::length(towards), radius = 0.5 * glm::distance(worldBox.low, worldBox.high);
    if (distance <= radius) return false;
    const double fromAxis = std::acos(std::clamp(glm::dot(towards, reach.axis) / distance, -1.0, 1.0));
    return fromAxis - std::asin(radius / distance) > reach.coneAngle + 1e-4;
}

bool mayReach(const StartRectangle& rectangle, std::span<const glm::dvec3> corners, const glm::dvec4& lightInView) {
    constexpr double kMargin = 1.0 + 1.0 / 32.0;  // more than the rasteriser's snapping
    const double distance = rectangle.distance;
    const glm::dvec2 half = (kMargin + glm::abs(rectangle.eye.shift)) * rectangle.eye.rayScale *
                            (rectangle.eye.perspective ? distance : 1.0);
    const glm::dvec3 light(lightInView);
    /// All corners on the negative side of a plane through `point`, beyond what rounding may confuse.
    const auto separates = [&](const glm::dvec3& normal, const glm::dvec3& point) {
        return std::all_of(corners.begin(), corners.end(), [&](const glm::dvec3& corner) {
            return glm::dot(normal, corner - point) < -1e-6 * glm::length(normal) * glm::distance(corner, point);
        });
    };
    // The light is on one side of the rectangle's plane; so is all that stands between them, and nearer than the light.
    const glm::dvec3 center(0.0, 0.0, -distance);
    const double side = -lightInView.z - distance * lightInView.w;
    const glm::dvec3 towardsLight(0.0, 0.0, side > 0.0 ? -1.0 : 1.0);
    if (side != 0.0 && separates(towardsLight, center)) return false;
    if (lightInView.w != 0.0 && separates(-towardsLight, light)) return false;
    for (int i = 0; i < 4; ++i) {
        const auto cornerOf = [&](int k) {
            const bool right = k == 1 || k == 2, top = k >= 2;
            return glm::dvec3(right ? half.x : -half.x, top ? half.y : -half.y, -distance);
        };
        const glm::dvec3 here = cornerOf(i);
        glm::dvec3 inward = glm::cross(cornerOf((i + 1) % 4) - here, light - lightInView.w * here);
        const double inside = glm::dot(inward, center - here);
        if (inside < 0.0) inward = -inward;
        if (inside != 0.0 && separates(inward, here)) return false;
    }
    return true;
}

double radiusOf(std::span<const Geometry::Bounds> boxes) {
    if (boxes.empty()) return 0.0;
    glm::dvec3 low = boxes[0].low, high = boxes[0].high;
    for (const Geometry::Bounds& box : boxes) {
        low = glm::min(low, box.low);
        high = glm::max(high, box.high);
    }
    return 0.5 * glm::length(high - low);
}

}  // namespace umbrage
