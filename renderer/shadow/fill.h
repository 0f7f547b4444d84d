// SPDX-License-Identifier: Apache-2.0
// What shadow volumes fill: how often they touch each pixel and change its count, and whose volumes do. Drawn again,
// only when somebody asked.
#pragma once

#include <map>
#include <span>
#include <vector>

#include "gpu/screen_target.h"
#include "shadow/counts.h"

namespace umbrage {

/// Of one light.
struct VolumeFill {
    std::vector<float> fragments, updates;  // a pixel, rows from the top; with several samples their mean
    std::vector<gpu::CasterFill> casters;   // per instance, samples; empty unless asked for
    std::uint64_t queried = 0;              // all of them by GL_SAMPLES_PASSED (T16)
};

/// Fragments of one caster's volumes, of all lights, at every pixel.
using CasterPlanes = std::map<std::uint32_t, std::vector<float>>;  // by instance

class FillMeter {
public:
    /// @param depthStencil  holds the depth of what is seen
    explicit FillMeter(const gpu::Texture& depthStencil);

    /// Waits.
    /// @param casters  whose volumes did it, too: twice as slow, as every fragment adds to a number of its caster
    VolumeFill measure(std::span<const CountPlan> plans, bool casters, VolumeRenderer& renderer,
                       const Geometry& geometry, const Silhouettes& silhouettes, const LightGroup& group,
                       std::uint32_t l);

    /// Adds to the planes of some casters what their volumes fill, of all lights of a group. Waits.
    /// @param plans  of each light
    /// @param casters  at most ATTRIBUTED
    void attribute(std::span<const std::vector<CountPlan>> plans, std::span<const std::uint32_t> casters,
                   VolumeRenderer& renderer, const Geometry& geometry, const Silhouettes& silhouettes,
                   const LightGroup& group, CasterPlanes& planes);

private:
    const gpu::Texture& depthStencil_;
    gpu::ScreenTarget fragments_, updates_;
    gpu::Framebuffer both_;
    gpu::Buffer casters_, ranks_;
    std::vector<gpu::ScreenTarget> attributed_;  // four casters each; these two on first use
    gpu::Framebuffer allAttributed_;
};

}  // namespace umbrage
