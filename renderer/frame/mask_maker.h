// SPDX-License-Identifier: Apache-2.0
// Another way to make masks than shadow volumes: what the bench compares them with.
#pragma once

#include <span>
#include <vector>

#include "scene/moment.h"
#include "shading/gbuffer.h"
#include "shading/surfaces.h"
#include "shadow/bounds.h"
#include "shadow/masks.h"

namespace umbrage {

/// A frame with its G-buffer drawn and its triangles' planes and facing bits found.
struct MaskTask {
    const Geometry& geometry;
    const Surfaces& surfaces;
    const GBuffer& gbuffer;
    const Masks& masks;  // all clear: to be drawn into
    const Silhouettes& silhouettes;
    const Eye& eye;
    std::span<const PlacedLight* const> lights;  // that are on, in the order of the masks' bits
    std::span<const Geometry::Bounds> boxes;     // per instance, in the world
    const std::vector<bool>& unseen;             // per instance: its box is out of view
};

class MaskMaker {
public:
    virtual ~MaskMaker() = default;
    virtual void make(const MaskTask& task) = 0;
};

}  // namespace umbrage
