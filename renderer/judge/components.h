// SPDX-License-Identifier: Apache-2.0
// Streaks: wrong pixels that hang together.
#pragma once

#include <cstdint>
#include <vector>

namespace umbrage {

struct Component {
    std::uint64_t pixels = 0;
    int extent = 0;  // the larger side of its bounding box
};

/// The largest set of marked pixels connected through their 8 neighbours.
Component largestComponent(const std::vector<bool>& marked, int width, int height);

}  // namespace umbrage
