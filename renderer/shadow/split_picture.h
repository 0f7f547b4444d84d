// SPDX-License-Identifier: Apache-2.0
// Split planes made visible, as in the figures of Laine 2005: each as far as its part's shadow reaches.
#pragma once

#include <span>
#include <vector>

#include "shadow/split_estimate.h"
#include "shadow/split_parts.h"

namespace umbrage {

struct SplitPicture {
    int width = 0, height = 0;
    std::vector<float> values;  // RGBA: colours added up, and their weights; rows from the top

    SplitPicture(int w, int h) : width(w), height(h), values(4 * std::size_t(w) * std::size_t(h)) {}

    /// @param distances  of what is seen, along the view axis; rows from the top
    void add(const LightParts& parts, const Homogeneous& light, const Eye& eye, const glm::vec3& color,
             std::span<const float> distances);
};

}  // namespace umbrage
