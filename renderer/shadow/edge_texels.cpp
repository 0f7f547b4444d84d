// SPDX-License-Identifier: Apache-2.0
#include "shadow/edge_texels.h"

#include <fmt/format.h>

#include "error.h"
#include "gpu/state.h"

namespace umbrage {

gpu::Texture::Size texelRows(std::uint32_t texelCount) {
    const int rows = int((texelCount + TEXEL_ROW - 1) / TEXEL_ROW);
    GLint largest[2] = {};
    glGetIntegerv(GL_MAX_VIEWPORT_DIMS, largest);
    if (rows > largest[1] / int(VIEWPORT_SCALE)) {
        throw Error(ErrorKind::Input, "shadow.silhouette",
                    fmt::format("{} vertices or edges are more than a texture holds here", texelCount),
                    "choose compute, which has no such limit");
    }
    return {int(TEXEL_ROW), rows};
}

void EdgeTexels::draw(const Geometry& geometry) {
    if (geometry.placedEdgeCount() == 0) return;
    if (!flags_.name()) {
        flags_ = gpu::Texture("flags of edges", GL_RGBA32UI, texelRows(geometry.placedEdgeCount()));
        const gpu::Framebuffer::Attachment color{&flags_};
        framebuffer_ = gpu::Framebuffer("flags of edges", std::span(&color, 1), nullptr);
    }
    framebuffer_.bind();
    gpu::RasterState state;
    state.color = gpu::ColorOp::Replace;
    gpu::apply(state);
    program_.use();
    noVertices_.bind();
    ++gpu::activity().draws;
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

std::vector<gpu::uvec4> EdgeTexels::read() const {
    const gpu::Texture::Size& size = flags_.size();
    std::vector<gpu::uvec4> flags(std::size_t(size.width) * std::size_t(size.height));
    if (flags.empty()) return flags;
    gpu::readPixels(framebuffer_.name(), size.width, size.height, GL_RGBA_INTEGER, GL_UNSIGNED_INT,
                    flags.size() * sizeof(gpu::uvec4), flags.data());
    return flags;
}

}  // namespace umbrage
