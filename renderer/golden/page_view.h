// SPDX-License-Identifier: Apache-2.0
// How the page shows a picture of any channels.
#pragma once

#include <array>
#include <vector>

#include "golden/comparison_page.h"

namespace umbrage {

/// What becomes red, green and blue: (value - low) / (high - low), clamped, then encoded for a display where that is
/// due. Colour keeps its values; of other channels the finite ones fill the range from black to white.
struct PageView {
    std::array<int, 3> shown{};  // channels; thrice the same: grey
    int alpha = -1;              // channel; -1: none
    float low = 0.0f, high = 1.0f;
    bool isEncoded = false;  // by displayEncoded()
};

PageView viewOf(const PagePicture& picture);

/// Interleaved display values in [0, 1]; magenta where a shown value is no number.
std::vector<float> displayRgba(const PagePicture& picture, const PageView& view);

}  // namespace umbrage
