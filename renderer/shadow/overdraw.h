// SPDX-License-Identifier: Apache-2.0
// How often shadow volumes touch each pixel: drawn again with additive blending, only when somebody asked.
#pragma once

#include <cstdint>
#include <vector>

#include "gpu/objects.h"
#include "shadow/counts.h"

namespace umbrage {

/// Samples, exactly, by GL_SAMPLES_PASSED (T16).
struct VolumeTotals {
    std::uint64_t fragments = 0, updates = 0;
};

class Overdraw {
public:
    explicit Overdraw(const gpu::Texture& depthStencil);

    void clear();
    /// Adds the fragments of a light's volumes (before the depth test) and those that change its counts.
    VolumeTotals add(std::span<const CountPlan> plans, VolumeRenderer& renderer, const Geometry& geometry,
                     const Silhouettes& silhouettes, const LightGroup& group, std::uint32_t l);

    /// Fragments a pixel, rows from the top; with several samples their mean. Waits.
    std::vector<float> readFragments() const;
    std::vector<float> readUpdates() const;

private:
    struct Plane {
        gpu::Texture counts, averaged;
        gpu::Framebuffer target, averagedTarget;
        std::vector<float> read() const;
    } fragments_, updates_;
};

/// The totals alone, when nobody wants them per pixel.
VolumeTotals countVolumeSamples(const gpu::Framebuffer& depthOnly, std::span<const CountPlan> plans,
                                VolumeRenderer& renderer, const Geometry& geometry, const Silhouettes& silhouettes,
                                const LightGroup& group, std::uint32_t l);

}  // namespace umbrage
