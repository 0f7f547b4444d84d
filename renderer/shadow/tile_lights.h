// SPDX-License-Identifier: Apache-2.0
// From silhouettes to what the tile counter takes. It needs no caps but of triangles that are missing from the depth
// buffer where they are the nearest (T1), and finds those itself, one by one; and because sides and the eye's constant
// are decided by the same determinants, it knows no hazards (T4).
#pragma once

#include <span>
#include <vector>

#include "shadow/counts.h"
#include "tiles/tile_counter.h"

namespace umbrage {

/// A sample of every pixel, and the eye.
struct TileScene {
    const Geometry& geometry;
    const Silhouettes& silhouettes;
    const LightGroup& group;
    const TileEye& eye;
};

class TileLights {
public:
    /// After a sweep over a group of lights: reads back what the device has found.
    void begin(const Geometry& geometry, const Silhouettes& silhouettes, const LightGroup& group);

    /// Per placed triangle: its plane in view space; bits of lights that its front and its back face.
    std::span<const glm::vec4> planes() const { return planes_; }
    std::span<const glm::uvec2> facing() const { return facing_; }

    /// Finds the casting triangles that may be nearer than what is seen: culled, with holes, or before the near plane.
    /// @param seen  at the eye's sample
    void findExposed(const TileScene& scene, const SeenTiles& seen, TileCounter& counter);

    /// @param plans  of light `l` of the group; their sides
    TileLight light(std::span<const CountPlan> plans, const TileScene& scene, std::uint32_t l) const;

private:
    struct Exposed {
        std::vector<std::uint32_t> triangles;  // placed
        std::vector<TilePolygon> caps;         // of them, as if the light were in front
    };
    std::span<const std::uint32_t> entriesOf(const TileScene& scene, std::uint32_t l, std::uint32_t list,
                                             std::vector<std::uint32_t>& read) const;

    std::vector<glm::vec4> planes_;
    std::vector<glm::uvec2> facing_;
    Exposed exposed_;
};

}  // namespace umbrage
