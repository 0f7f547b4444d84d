// SPDX-License-Identifier: Apache-2.0
// Which lights may reach a box: asked of sixteen at a time.
#pragma once

#include <glm/glm.hpp>
#include <vector>

namespace umbrage {

inline constexpr int kShadeLanes = 16;

/// One array a value, in whatever space the boxes are in.
struct LightsReach {
    float x[kShadeLanes], y[kShadeLanes], z[kShadeLanes];
    float range2[kShadeLanes];  // infinite where there is no range; below 0 beyond the last light
};

/// Appends a light, the `number`th. @param inverseRange2  1/range^2; 0: unlimited, as directional ones are
void addReach(std::vector<LightsReach>& all, std::size_t number, const glm::vec3& position, float inverseRange2);

}  // namespace umbrage
