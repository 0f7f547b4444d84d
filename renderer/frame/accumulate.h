// SPDX-License-Identifier: Apache-2.0
// Antialiasing by accumulation (Haeberli & Akeley, The Accumulation Buffer, SIGGRAPH 1990): a frame is the mean of
// whole pictures, each of them exact, whose samples lie at other places in their pixels.
#pragma once

#include "frame/frame.h"

namespace umbrage {

/// Where picture `index` of `count` is taken: the first two dimensions of Sobol's sequence (Sobol 1967; a (0,
/// 2)-sequence in base 2), moved to the middles of its strata, with the one that is nearest to the middle of the pixel
/// first. So a power of two of pictures has one in each of as many columns and rows, which for borders along an axis
/// the R2 sequence has not; and a single picture is taken in the middle.
/// @param samples  a pixel already has; they share the pixel, and each is moved within its share alone
/// @return PlacedCamera::shiftPixels: from -1/2 to 1/2 over the root of `samples`
glm::dvec2 accumulationShift(int index, int count, int samples);

/// Renders a frame as often as FrameSettings::accumulation says and takes means in
/// double, in the order of the pictures: of the radiance, the shadows and the AOVs light, ambient and emissive. All
/// else is the first picture's, but for milliseconds, which add up, and notes.
/// @param before  as FrameRenderer::render()
FramePixels renderAccumulated(FrameRenderer& renderer, const PlacedMoment& now, const FrameOutputs& outputs, int frame,
                              Statistics& statistics, const PlacedMoment* before = nullptr);

}  // namespace umbrage
