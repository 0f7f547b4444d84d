// SPDX-License-Identifier: Apache-2.0
// What a depth-bounds test can know of a caster's volume (Laine 2005, section 7): the depths of its bounding box and of
// that box's own shadow volume, as far as they lie in the picture.
#pragma once

#include "bench/tile_polygons.h"

namespace umbrage {

/// Inverse distances along the view axis; none where least > most.
struct DepthBounds {
    double least = 1.0, most = 0.0;

    bool holds(double inverseDepth) const { return inverseDepth >= least && inverseDepth <= most; }
    bool meets(double low, double high) const { return high >= least && low <= most; }
};

/// Of all triangles, in the world.
std::array<glm::dvec3, 2> boxOf(const TileCaster& caster);

DepthBounds depthBoundsOf(const TileCaster& caster, const glm::dvec4& light, const TileView& view);

}  // namespace umbrage
