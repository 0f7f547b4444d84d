// SPDX-License-Identifier: Apache-2.0
#include "shading/resolve.h"

#include <fmt/format.h>

#include "gpu/state.h"

namespace umbrage {
namespace {

gpu::Program programFor(const char* fragment, int samples, const char* data = "DATA 0") {
    return gpu::Program("fullscreen.vert", fragment, {fmt::format("SAMPLES {}", samples), data});
}

}  // namespace

Resolve::Resolve(const GBuffer& gbuffer)
    : width_(gbuffer.width()),
      height_(gbuffer.height()),
      shade_(programFor("resolve.frag", gbuffer.samples())),
      geometryData_(programFor("data.frag", gbuffer.samples())),
      shadowData_(programFor("data.frag", gbuffer.samples(), "DATA 1")),
      sampleData_(programFor("sample.frag", gbuffer.samples())) {
    radiance_ = gpu::Texture("radiance", GL_RGBA32F, gbuffer.depthStencil.size());
    const gpu::Framebuffer::Attachment color{&radiance_};
    target_ = gpu::Framebuffer("radiance", std::span(&color, 1), nullptr);
    targetWithDepth_ = gpu::Framebuffer("radiance and depth", std::span(&color, 1), &gbuffer.depthStencil);
    if (gbuffer.samples() > 1) {
        averaged_ = gpu::Texture("averaged radiance", GL_RGBA32F, {width_, height_});
        const gpu::Framebuffer::Attachment average{&averaged_};
        averagedTarget_ = gpu::Framebuffer("averaged radiance", std::span(&average, 1), nullptr);
    }
}

void Resolve::drawFullScreen(const gpu::Program& program, const gpu::Framebuffer& target, const GBuffer& gbuffer,
                             const Masks& masks, const Silhouettes& silhouettes) {
    target.bind();
    gpu::RasterState state;
    state.color = gpu::ColorOp::Replace;
    gpu::apply(state);
    gbuffer.bindTextures();
    masks.texture().bind(6);
    silhouettes.bind();
    program.uniform(1, silhouettes.facingStride);
    program.use();
    noVertices_.bind();
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

void Resolve::shade(const GBuffer& gbuffer, const Masks& masks, const Silhouettes& silhouettes) {
    drawFullScreen(shade_, target_, gbuffer, masks, silhouettes);
    targetWithDepth_.bind();
}

std::vector<float> Resolve::read(const gpu::Framebuffer& from) const {
    const gpu::Framebuffer* source = &from;
    if (averaged_.name()) {
        glBlitNamedFramebuffer(from.name(), averagedTarget_.name(), 0, 0, width_, height_, 0, 0, width_, height_,
                               GL_COLOR_BUFFER_BIT, GL_NEAREST);
        source = &averagedTarget_;
    }
    std::vector<float> pixels(4 * std::size_t(width_) * std::size_t(height_));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, source->name());
    glReadPixels(0, 0, width_, height_, GL_RGBA, GL_FLOAT, pixels.data());
    return pixels;
}

std::vector<float> Resolve::readRadiance() {
    return read(target_);
}

std::vector<float> Resolve::readNormalAndDepth(const GBuffer& gbuffer, const Masks& masks,
                                               const Silhouettes& silhouettes, const glm::mat3& worldFromView) {
    glProgramUniformMatrix3fv(geometryData_.name(), 3, 1, GL_FALSE, &worldFromView[0][0]);
    drawFullScreen(geometryData_, target_, gbuffer, masks, silhouettes);
    return read(target_);
}

std::vector<float> Resolve::readShadows(const GBuffer& gbuffer, const Masks& masks, const Silhouettes& silhouettes,
                                        std::uint32_t firstLight) {
    shadowData_.uniform(2, firstLight);
    drawFullScreen(shadowData_, target_, gbuffer, masks, silhouettes);
    return read(target_);
}

std::vector<gpu::uvec2> Resolve::readSample(const GBuffer& gbuffer, const Masks& masks, const Silhouettes& silhouettes,
                                            int sample, const glm::vec2& position, std::uint32_t group) {
    if (!sample_.name()) {
        sample_ = gpu::Texture("one sample", GL_RG32UI, {width_, height_});
        const gpu::Framebuffer::Attachment color{&sample_};
        sampleTarget_ = gpu::Framebuffer("one sample", std::span(&color, 1), nullptr);
    }
    sampleData_.uniform(2, group);
    if (gbuffer.samples() > 1) sampleData_.uniform(4, GLint(sample));
    glProgramUniform2f(sampleData_.name(), 5, position.x, position.y);
    drawFullScreen(sampleData_, sampleTarget_, gbuffer, masks, silhouettes);
    std::vector<gpu::uvec2> pixels(std::size_t(width_) * std::size_t(height_));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, sampleTarget_.name());
    glReadPixels(0, 0, width_, height_, GL_RG_INTEGER, GL_UNSIGNED_INT, pixels.data());
    return pixels;
}

}  // namespace umbrage
