// SPDX-License-Identifier: Apache-2.0
// Antialiasing by accumulation (Haeberli & Akeley, The Accumulation Buffer, SIGGRAPH 1990): a frame is the mean of
// whole pictures, each of them exact, whose samples lie at other places in their pixels.
#pragma once

#include "frame/frame.h"

namespace umbrage {

/// Where picture `index` of an accumulated frame is taken: the R2 sequence (M. Roberts, The Unreasonable Effectiveness
/// of Quasirandom Sequences, 2018), which begins in the middle of the pixel: the first picture is that of a frame that
/// is not accumulated.
/// @param samples  a pixel already has; they share the pixel, and each is moved within its share alone
/// @return PlacedCamera::shiftPixels: from -1/2 to 1/2 over the root of `samples`
glm::dvec2 accumulationShift(int index, int samples);

/// Renders a frame as often as FrameSettings::accumulation says, at the shifts from `first` on, and takes means in
/// double, in the order of the pictures: of the radiance, the shadows and the AOVs light, ambient and emissive. All
/// else is the first picture's, but for milliseconds, which add up, and notes.
/// @param before  as FrameRenderer::render()
/// @param first  0, but for a reference that shares no places with others
FramePixels renderAccumulated(FrameRenderer& renderer, const PlacedMoment& now, const FrameOutputs& outputs, int frame,
                              Statistics& statistics, const PlacedMoment* before = nullptr, int first = 0);

}  // namespace umbrage
