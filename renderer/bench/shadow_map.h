// SPDX-License-Identifier: Apache-2.0
// Shadow maps, a competitor of shadow volumes (Williams, Casting Curved Shadows on Curved Surfaces, SIGGRAPH 1978): as
// good as one comparison with one texel can be.
//
// Depth is a reversed float, so that what maps miss is resolution, not precision. A directional light has an
// orthographic map fitted around what is seen of the scene; a spot light one as wide as its cone; a point light, and
// a spot of more than kWidestSpot, the six faces of a cube. Casters that a face does not see or the light's range does
// not hold are left out. All triangles are drawn: leaving out those that face the light would hide a bias behind closed
// casters, but sheets would cast nothing. Every map is drawn anew in every frame.
#pragma once

#include <memory>

#include "frame/mask_maker.h"

namespace umbrage {

struct ShadowMapSettings {
    int size = 1024;  // texels along a side of each face
    /// Pushes the map's surfaces away from the light by three times their slope over one texel's width and by sixteen
    /// quanta of the depth buffer. A sample lies at most half a texel from a texel's middle along both axes, so once
    /// the slope would do for one plane; of 1/2, 1, 1.5, 2, 3, 4 and 8 times, three has the fewest wrong samples over
    /// knights, tree and noise-spheres (1024 texels; bench measure `error`).
    bool biased = true;
};

std::shared_ptr<MaskMaker> makeShadowMaps(const ShadowMapSettings& settings);

}  // namespace umbrage
