// SPDX-License-Identifier: Apache-2.0
#include "shading/gbuffer.h"

#include <array>

#include "gpu/state.h"

namespace umbrage {

GBuffer::GBuffer(int width, int height, int samples) {
    const gpu::Texture::Size size{width, height, 0, samples};
    triangle = gpu::Texture("G-buffer triangle", GL_R32UI, size);
    baseColor = gpu::Texture("G-buffer base colour", GL_RGBA16, size);
    normal = gpu::Texture("G-buffer normal", GL_RG16, size);
    properties = gpu::Texture("G-buffer properties", GL_RGBA8, size);
    emissive = gpu::Texture("G-buffer emissive", GL_RGBA16F, size);
    depthStencil = gpu::Texture("depth and stencil", GL_DEPTH32F_STENCIL8, size);
    const std::array<gpu::Framebuffer::Attachment, 5> colors{
        {{&triangle}, {&baseColor}, {&normal}, {&properties}, {&emissive}}};
    framebuffer = gpu::Framebuffer("G-buffer", colors, &depthStencil);
    depthOnly = gpu::Framebuffer("depth", {}, &depthStencil);
}

std::vector<glm::vec2> GBuffer::samplePositions() const {
    if (samples() == 1) return {glm::vec2(0.5f)};
    std::vector<glm::vec2> positions(static_cast<std::size_t>(samples()));
    framebuffer.bind();
    for (std::size_t s = 0; s < positions.size(); ++s)
        glGetMultisamplefv(GL_SAMPLE_POSITION, GLuint(s), &positions[s].x);
    return positions;
}

void GBuffer::begin(float emptyDepth) const {
    framebuffer.bind();
    gpu::RasterState state;
    state.depthWrite = true;
    gpu::apply(state);
    glStencilMask(0xff);
    glClearBufferfi(GL_DEPTH_STENCIL, 0, emptyDepth, 0);
}

void GBuffer::readColor(int attachment, GLenum format, GLenum type, std::size_t bytes, void* pixels) const {
    glNamedFramebufferReadBuffer(framebuffer.name(), GL_COLOR_ATTACHMENT0 + GLenum(attachment));
    gpu::readPixels(framebuffer.name(), width(), height(), format, type, bytes, pixels);
}

void GBuffer::bindTextures() const {
    const gpu::Texture* textures[] = {&triangle, &baseColor, &normal, &properties, &emissive, &depthStencil};
    for (GLuint unit = 0; unit < std::size(textures); ++unit) textures[unit]->bind(unit);
}

}  // namespace umbrage
