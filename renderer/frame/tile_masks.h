// SPDX-License-Identifier: Apache-2.0
// Masks of the lights that the tile counter counts: what is seen is read back, and bits go up again.
#pragma once

#include <optional>
#include <vector>

#include "gpu/sample_ties.h"
#include "shading/resolve.h"
#include "shadow/tile_lights.h"

namespace umbrage {

class TileMasks {
public:
    struct Target {
        const GBuffer& gbuffer;
        Masks& masks;
        Resolve& resolve;
        const Eye& eye;
        std::span<const gpu::LightData> lights;  // of the group
        bool eyeConstant;                        // as CountSettings
        bool skipOutOfReach;                     // pixels that a light cannot light
        SeenSample& seen;                        // read already, if there is one sample a pixel
    };
    /// Counts a group of lights and writes its masks.
    /// @param plans  per light
    /// @param everyPixel  for readCounts(): also those that the lights cannot light
    void count(std::span<const std::vector<CountPlan>> plans, const Geometry& geometry, const Silhouettes& silhouettes,
               const LightGroup& group, const Target& target, bool everyPixel);

    /// Layers over the first sample of each pixel, of light `l` of the group that was counted last, for
    /// every pixel; rows from the top.
    std::vector<std::uint32_t> readCounts(std::uint32_t l);

private:
    void see(const Silhouettes& silhouettes, const LightGroup& group, const Target& target, const TileEye& eye,
             int sample);

    std::optional<gpu::SampleTies> ties_;  // on first use
    TileLights lights_;
    TileCounter counter_;
    // Kept from frame to frame: fresh memory costs more than what is done with it.
    std::vector<std::uint32_t> dark_;
    std::optional<SeenTiles> seen_;  // these two of the first sample
    std::vector<TileLight> counted_;
};

}  // namespace umbrage
