// SPDX-License-Identifier: Apache-2.0
#include "shading/lights_reach.h"

#include <algorithm>
#include <cmath>

namespace umbrage {

void addReach(std::vector<LightsReach>& all, std::size_t number, const glm::vec3& position, float inverseRange2) {
    const std::size_t i = number % kShadeLanes;
    if (i == 0) {
        LightsReach& next = all.emplace_back();
        std::ranges::fill(next.range2, -1.0f);
    }
    LightsReach& reach = all.back();
    reach.x[i] = position.x, reach.y[i] = position.y, reach.z[i] = position.z;
    // A little more than the range: what rounds beyond it adds nothing anyway.
    reach.range2[i] = inverseRange2 > 0.0f ? 1.001f / inverseRange2 : HUGE_VALF;
}

}  // namespace umbrage
