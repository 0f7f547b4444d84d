// SPDX-License-Identifier: Apache-2.0
// How high a count can get: an upper bound on the layers between a light and any point (T6). A stencil buffer counts
// modulo 256, so where the bound is higher, counts are made by additive blending into floats instead.
#pragma once

#include <cstdint>
#include <vector>

#include "gpu/objects.h"
#include "gpu/program.h"
#include "shadow/geometry.h"
#include "shadow/silhouette.h"

namespace umbrage {

class LayerBound {
public:
    explicit LayerBound(const Geometry& geometry);

    /// One bound a light of the group. The lights' buffer is bound at BIND_LIGHTS. Waits, unless there are so few
    /// triangles that their number is the bound.
    std::vector<std::uint32_t> find(const Geometry& geometry, const Silhouettes& silhouettes, const LightGroup& group,
                                    double sceneRadiusMetres);

private:
    std::uint32_t casting_ = 0;  // triangles
    gpu::Buffer cells_, bounds_;
    gpu::Program program_{"layers.comp"};
};

}  // namespace umbrage
