// SPDX-License-Identifier: Apache-2.0
// From lists of side quads and stored facing bits to what the tile counter takes.
#pragma once

#include <span>
#include <vector>

#include "shadow/counts.h"
#include "tiles/tile_counter.h"

namespace umbrage {

class TileLights {
public:
    /// Whether the tile counter can count a plan: from the eye, with caps at most at their own depth.
    static bool takes(const CountPlan& plan);

    /// After a sweep over a group of lights.
    void begin(const Geometry& geometry, const Silhouettes& silhouettes, const LightGroup& group);

    /// @param plans  of light `l` of the group, that takes() says it can
    /// @param eye  of the frame, at one sample of its pixels
    TileLight light(std::span<const CountPlan> plans, const Geometry& geometry, const Silhouettes& silhouettes,
                    const LightGroup& group, std::uint32_t l, const TileEye& eye) const;

    /// Per placed triangle: its plane in view space; bits of lights that its front and its back face.
    const std::vector<glm::vec4>& planes() const { return planes_; }
    const std::vector<glm::uvec2>& facing() const { return facing_; }

private:
    std::vector<float> positions_;
    std::vector<glm::vec4> planes_;
    std::vector<glm::uvec2> facing_;
};

}  // namespace umbrage
