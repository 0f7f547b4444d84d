// SPDX-License-Identifier: Apache-2.0
// A judged frame as a picture for people: what is wrong in colour over the dimmed frame, the worst place enlarged
// beside it, and the figures below.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "image/canvas.h"
#include "judge/verdict.h"

namespace umbrage {

/// Told apart by the colour-blind, too (a test holds them to that); none is a grey. Not for SampleVerdict::Right.
Rgb8 colorOf(SampleVerdict verdict);

struct PixelRectangle {
    int x = 0, y = 0, width = 0, height = 0;
};

/// Where as many hard errors as possible are in sight, or mismatches of any kind where none is hard; what is found is
/// in the middle as far as the frame's borders let it. The frame's middle where nothing is wrong.
/// @param verdicts  width x height
/// @return of the wanted size, or the frame's where that is smaller
PixelRectangle worstPlace(std::span<const SampleVerdict> verdicts, int width, int height, int wantedWidth,
                          int wantedHeight);

/// Of all lights together; the enlarged part is of the light with the most errors.
/// @param displayRgb  the frame as displayed, planes.width x planes.height
RgbPicture drawErrors(const std::string& sequence, const FrameVerdict& verdict, const VerdictPlanes& planes,
                      std::span<const std::uint8_t> displayRgb);

}  // namespace umbrage
