// SPDX-License-Identifier: Apache-2.0
#include "shadow/layers.h"

#include <algorithm>

namespace umbrage {

LayerBound::LayerBound(const Geometry& geometry)
    : cells_("layer cells", LIGHTS_PER_GROUP * LAYER_CELLS * sizeof(std::uint32_t)),
      bounds_("layer bounds", LIGHTS_PER_GROUP * sizeof(std::uint32_t)) {
    for (std::uint32_t i = 0; i < geometry.instanceCount(); ++i) {
        const std::vector<bool>& casts = geometry.topologies()[geometry.meshOf(i)].casts;
        casting_ += std::uint32_t(std::count(casts.begin(), casts.end(), true));
    }
}

std::vector<std::uint32_t> LayerBound::find(const Geometry& geometry, const Silhouettes& silhouettes,
                                            const LightGroup& group, double sceneRadiusMetres) {
    if (casting_ <= 255) return std::vector<std::uint32_t>(group.count, casting_);
    cells_.clearToZero();
    bounds_.clearToZero();
    geometry.bind();
    silhouettes.casters.bindStorage(BIND_CASTERS);
    cells_.bindStorage(BIND_LAYER_CELLS);
    bounds_.bindStorage(BIND_LAYER_BOUNDS);
    program_.uniform(0, geometry.triangleChunkCount());
    program_.uniform(1, group.count);
    program_.uniform(2, group.first);
    program_.uniform(3, float(std::max(sceneRadiusMetres, 1e-6) * 2.0 / LAYER_GRID));
    program_.dispatchGroups(geometry.triangleChunkCount());
    std::vector<std::uint32_t> bounds(group.count);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    bounds_.read(0, bounds.size() * sizeof(std::uint32_t), bounds.data());
    return bounds;
}

}  // namespace umbrage
