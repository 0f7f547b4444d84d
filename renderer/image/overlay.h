// SPDX-License-Identifier: Apache-2.0
// Count planes as pictures for people: false colour on a fixed scale, with a legend that says what is seen. Not for
// machines: the numbers themselves are in the EXR.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "image/canvas.h"

namespace umbrage {

struct OverlayStyle {
    std::string title;          // drawn in capitals; what does not fit ends in ...
    float scaleMaximum = 8.0f;  // the count at the bright end, > 0: the same for all frames, so that they compare
};

/// Counts from 0 (nothing drawn) to scaleMaximum go from dark violet over teal to yellow; lightness grows evenly, so
/// the order is also seen by the colour-blind and in print. Above the scale: white stripes; below zero: red stripes.
/// The legend is in the lower left corner; pictures too small for it have none.
///
/// @param counts  width x height values, rows from the top; NaN: no data, drawn as 0
/// @param beautyRgb  width x height display RGB, shown dimmed and grey below the counts; empty: black
/// @return width x height
RgbPicture drawOverlay(int width, int height, std::span<const float> counts, std::span<const std::uint8_t> beautyRgb,
                       const OverlayStyle& style);

}  // namespace umbrage
