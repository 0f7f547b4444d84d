// SPDX-License-Identifier: Apache-2.0
// Brabec & Seidel 2003, section 4.2: the sweep over the edges as a pass over a texture of flags
// (edge_texels.frag.glsl).
#pragma once

#include "shadow/silhouette_device.h"

namespace umbrage {

/// Of a texture with that many texels at least, in rows of TEXEL_ROW.
/// @throws Error(Input) if the device draws into none as large
gpu::Texture::Size texelRows(std::uint32_t texelCount);

class EdgeTexels {
public:
    explicit EdgeTexels(gpu::Program::Defines defines) : program_("fullscreen.vert", "edge_texels.frag", defines) {}

    /// The pass, whose uniforms are for its owner to set.
    const gpu::Program& program() const { return program_; }
    void draw(const Geometry& geometry);

    void bind() const { flags_.bind(UNIT_EDGE_FLAGS); }
    /// Four words a placed edge, as the shader says. Waits.
    std::vector<gpu::uvec4> read() const;

private:
    gpu::Program program_;
    gpu::Texture flags_;
    gpu::Framebuffer framebuffer_;
    gpu::VertexArray noVertices_{"texels of edges"};
};

}  // namespace umbrage
