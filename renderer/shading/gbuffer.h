// SPDX-License-Identifier: Apache-2.0
// The G-buffer: what is seen at every sample, before any light.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "gpu/objects.h"

namespace umbrage {

struct GBuffer {
    GBuffer(int width, int height, int samples);

    gpu::Texture triangle;      // R32UI: placed triangle or NO_TRIANGLE
    gpu::Texture baseColor;     // RGBA16: linear
    gpu::Texture normal;        // RG16: octahedral, view space, of the shading normal
    gpu::Texture properties;    // RGBA8: metallic, roughness, occlusion, lit
    gpu::Texture emissive;      // RGBA16F
    gpu::Texture depthStencil;  // D32F_S8: reversed depth
    gpu::Framebuffer framebuffer;
    gpu::Framebuffer depthOnly;

    int width() const { return depthStencil.size().width; }
    int height() const { return depthStencil.size().height; }
    int samples() const { return depthStencil.size().samples; }

    /// Where the samples of a pixel lie in it, from its upper left corner.
    std::vector<glm::vec2> samplePositions() const;

    /// Binds the framebuffer and clears what needs it: depth and stencil. Other values are read only where depth is.
    /// @param emptyDepth  nothing farther is seen
    void begin(float emptyDepth) const;
    /// Of one sample a pixel, rows from the top. Waits. @param attachment  0 to 4, in the order above
    void readColor(int attachment, GLenum format, GLenum type, std::size_t bytes, void* pixels) const;
    /// For gbuffer.glsl: units 0 to 5.
    void bindTextures() const;
};

}  // namespace umbrage
