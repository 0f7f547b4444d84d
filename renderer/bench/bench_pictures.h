// SPDX-License-Identifier: Apache-2.0
// What the tile counter found, to look at: how often each pixel is processed (Laine 2005, figures 1, 3, 4 and 5) and
// what a pixel costs against the depth it sees (his figure 2).
#pragma once

#include <map>

#include "bench/bench_tiles.h"

namespace umbrage {

/// Of one sequence and method at a frame.
struct ProcessedPanel {
    std::string title;  // with how many pixels are processed
    int width = 0, height = 0;
    std::vector<float> processed;  // how often, at each pixel
    std::vector<float> radiance;   // of the picture below, RGBA
};

/// The panels on one scale, left to right and down, each new picture in front of those of its own.
RgbPicture drawProcessed(const std::vector<ProcessedPanel>& panels, const DisplayTransform& display);

/// @param method  of kTileMethods
ProcessedPanel processedPanel(TileBench& bench, std::string_view method, int frame);

/// @throws Error(Input) where no light is on
Plot updateCurve(TileBench& bench, const BenchCurve& curve);

}  // namespace umbrage
