// SPDX-License-Identifier: Apache-2.0
// Pictures for people of what a frame's diagnostics found.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "frame/frame.h"
#include "image/canvas.h"
#include "job/job.h"

namespace umbrage {

/// One frame's.
struct OverlayInput {
    int width = 0, height = 0, frame = 0;
    const FramePixels& pixels;
    std::string technique;                 // silhouette:count
    const FramePixels* against = nullptr;  // the same frame by another technique
    std::string againstTechnique{};
    std::vector<std::uint8_t> beautyRgb{};  // display values; empty: it was not shaded
    bool burnIn = false;
};

/// Adds what the overlays need. @param overlays  names of job/names.h
void addNeeds(std::span<const std::string> overlays, FrameOutputs& outputs);

/// @param overlay  a name of job/names.h
RgbPicture overlayPicture(std::string_view overlay, const OverlayInput& input);

}  // namespace umbrage
