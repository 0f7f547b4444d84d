// SPDX-License-Identifier: Apache-2.0
#include "shadow/bounds.h"

#include <algorithm>

namespace umbrage {

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

bool outOfReach(const Geometry::Bounds& worldBox, const glm::dvec3& lightPosition, double rangeMetres) {
    if (rangeMetres <= 0.0) return false;
    const glm::dvec3 nearest = glm::clamp(lightPosition, worldBox.low, worldBox.high);
    return glm::distance(nearest, lightPosition) > rangeMetres * (1.0 + 1e-5);  // beyond what floats can confuse
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
