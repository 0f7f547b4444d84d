// SPDX-License-Identifier: Apache-2.0
// How lines of plots and pages are told apart: by the colours of image/palette.h, which come again with dashes.
#pragma once

#include <array>
#include <cstddef>

#include "image/palette.h"

namespace umbrage {

/// Lengths drawn and left out, in pixels; 0: all drawn.
inline constexpr std::array<double, 3> kLineDashes{0.0, 8.0, 3.0};

inline double lineDash(std::size_t series) {
    return kLineDashes[series / kCategoryColors.size() % kLineDashes.size()];
}

}  // namespace umbrage
