// SPDX-License-Identifier: Apache-2.0
// A frame's casters and depths as the tile counter wants them.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "bench/tile_polygons.h"
#include "frame/frame.h"
#include "job/job.h"
#include "judge/truth.h"

namespace umbrage {

enum class Weights {
    Least,     // closed surfaces that run the same way round everywhere count only where they face the light
    TwoSided,  // every triangle counts
};

/// Instances at and below a node that a glob matches are one caster; without globs every instance is one. What no glob
/// matches is seen, but casts nothing.
/// @throws Error(Input) at a glob's place if it matches nothing
std::vector<TileCaster> tileCasters(const Scene& scene, const Moment& moment, const Geometry& geometry,
                                    const Truth& truth, const Eye& eye, std::span<const Located<std::string>> globs,
                                    Weights weights);

/// What each pixel sees, 1/metre along the view axis; 0 where nothing is seen, or 1/zfar. The device snaps corners to
/// its grid, so that on outlines it may have missed a caster that lies at a pixel's very centre; there it is put back,
/// else its light cap would be before what is seen.
/// @param pixels  rendered with FrameOutputs::geometry
std::vector<double> inverseDepthsOf(const FramePixels& pixels, std::span<const TileCaster> casters, const Eye& eye,
                                    const TileView& view);

}  // namespace umbrage
