// SPDX-License-Identifier: Apache-2.0
// One bit per light and sample: 1 where the light's shadow falls. All lights share one depth-stencil buffer (T8).
#pragma once

#include "gpu/objects.h"
#include "shadow/counts.h"

namespace umbrage {

class Masks {
public:
    /// @param depthStencil  D32F_S8, holds the depth of what is seen
    Masks(const gpu::Texture& depthStencil, std::uint32_t lightCount);

    /// Counts light `l` of the group by a plan and sets its bits.
    void count(const CountPlan& plan, VolumeRenderer& renderer, const Geometry& geometry,
               const Silhouettes& silhouettes, const LightGroup& group, std::uint32_t l);

    /// Whether a plan that keeps only parity says the truth: counts in full, and looks for counts that are even but not
    /// zero. Waits.
    bool parityTells(const CountPlan& plan, VolumeRenderer& renderer, const Geometry& geometry,
                     const Silhouettes& silhouettes, const LightGroup& group, std::uint32_t l);

    /// Layer g: bits of lights 32 g to 32 g + 31.
    const gpu::Texture& texture() const { return texture_; }
    void clear();

    /// Sets all bits of a group to those given: sample after sample, rows from the top of each.
    void set(std::uint32_t group, std::span<const std::uint32_t> bits);

    /// The bits of a group, rows from the top, of a picture with one sample a pixel. Waits.
    void read(std::uint32_t group, std::span<std::uint32_t> bits) const;

    /// What the last count() counted, rows from the top; one sample of each pixel. Waits.
    /// @param plan  what was given to count()
    /// @return layers over each sample; where rounding on a shadow's border makes a negative count, its magnitude, so
    /// that
    ///         everything dark has a count
    std::vector<std::uint32_t> readCounts(const CountPlan& plan) const;

private:
    void drawIntoStencil(const CountPlan& plan, VolumeRenderer& renderer, const Geometry& geometry,
                         const Silhouettes& silhouettes, const LightGroup& group, std::uint32_t l);
    void countByBlending(const CountPlan& plan, VolumeRenderer& renderer, const Geometry& geometry,
                         const Silhouettes& silhouettes, const LightGroup& group, std::uint32_t l);
    void copyDepth();
    void start(std::span<const std::uint32_t> parts);
    const gpu::Framebuffer& singleSampled(bool wide) const;
    std::uint64_t samplesWith(const gpu::Stencil& stencil);
    void mark(const gpu::Program& program, const gpu::Stencil& stencil, const LightGroup& group, std::uint32_t l);

    const gpu::Texture& depthStencil_;
    gpu::Texture texture_;
    std::vector<gpu::Framebuffer> framebuffers_;  // one a layer
    gpu::Framebuffer stencilOnly_;
    gpu::Texture oneSample_, oneWideSample_;  // for readCounts() of multisampled counts
    gpu::Framebuffer oneSampleTarget_, oneWideSampleTarget_;
    gpu::Program firstSampleProgram_{"fullscreen.vert", "first_sample.frag"};
    gpu::Program markProgram_{"fullscreen.vert", "mask.frag"};
    gpu::Program everywhere_{"fullscreen.vert"};
    gpu::Texture wideCounts_;  // R32F; these on first use
    gpu::Framebuffer wideTarget_;
    gpu::Program markWideProgram_;
    gpu::Texture seenDepth_;  // what shaders read while the depth buffer is attached; the same
    gpu::Framebuffer seenDepthTarget_;
    bool depthIsCopied_ = false;
    gpu::Program startProgram_;
    gpu::Program givenProgram_;
    gpu::Buffer given_;
    gpu::VertexArray noVertices_{"full screen"};
};

}  // namespace umbrage
