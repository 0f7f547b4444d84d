// SPDX-License-Identifier: Apache-2.0
// From G-buffer and masks to radiance, and to the data AOVs.
#pragma once

#include <span>
#include <vector>

#include "gpu/program.h"
#include "shading/gbuffer.h"
#include "shadow/masks.h"
#include "shadow/silhouette.h"

namespace umbrage {

class Resolve {
public:
    explicit Resolve(const GBuffer& gbuffer);

    /// Lights everything in one pass over the image and leaves the target bound, with the scene's depth, for blended
    /// surfaces to be drawn over it.
    void shade(const GBuffer& gbuffer, const Masks& masks, const Silhouettes& silhouettes);

    /// Rows from the top, linear Rec.709 RGBA; samples averaged. Waits for the device.
    std::vector<float> readRadiance();

    /// World-space shading normal and distance along the view axis (background: 0 and infinity), of the first sample.
    std::vector<float> readNormalAndDepth(const GBuffer& gbuffer, const Masks& masks, const Silhouettes& silhouettes,
                                          const glm::mat3& worldFromView);

    /// The shadow masks of lights first to first + 3, one in each channel (docs/rules.md, G7).
    std::vector<float> readShadows(const GBuffer& gbuffer, const Masks& masks, const Silhouettes& silhouettes,
                                   std::uint32_t firstLight);

    /// Of one sample of every pixel: the placed triangle that is seen (NO_TRIANGLE: none), and bits of the group's
    /// lights that reach it (docs/rules.md, G7).
    /// @param position  of the sample in its pixel
    std::vector<gpu::uvec2> readSample(const GBuffer& gbuffer, const Masks& masks, const Silhouettes& silhouettes,
                                       int sample, const glm::vec2& position, std::uint32_t group);

private:
    void drawFullScreen(const gpu::Program& program, const gpu::Framebuffer& target, const GBuffer& gbuffer,
                        const Masks& masks, const Silhouettes& silhouettes);
    std::vector<float> read(const gpu::Framebuffer& from) const;

    int width_, height_;
    gpu::Texture radiance_, averaged_;  // averaged_: only with several samples
    gpu::Framebuffer target_, targetWithDepth_, averagedTarget_;
    gpu::Texture sample_;  // these two on first use
    gpu::Framebuffer sampleTarget_;
    gpu::Program shade_, geometryData_, shadowData_, sampleData_;
    gpu::VertexArray noVertices_{"full screen"};
};

}  // namespace umbrage
