// SPDX-License-Identifier: Apache-2.0
#include "shading/resolve.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "gpu/state.h"

namespace umbrage {
namespace {

std::string samplesOf(const GBuffer& gbuffer) {
    return fmt::format("SAMPLES {}", gbuffer.samples());
}

std::string capitals(std::string_view name) {
    std::string text(name);
    std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return char(std::toupper(c)); });
    return text;
}

}  // namespace

Resolve::Resolve(const GBuffer& gbuffer)
    : target_("radiance", GL_RGBA32F, gbuffer.depthStencil.size(), nullptr),
      shade_("fullscreen.vert", "resolve.frag", {samplesOf(gbuffer)}),
      sampleData_("fullscreen.vert", "sample.frag", {samplesOf(gbuffer)}),
      seen_("fullscreen.vert", "seen_tiles.frag", {samplesOf(gbuffer)}) {
    const gpu::Framebuffer::Attachment color{&target_.texture()};
    targetWithDepth_ = gpu::Framebuffer("radiance and depth", std::span(&color, 1), &gbuffer.depthStencil);
    firstSample_ = gbuffer.samplePositions().front();
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
    ++gpu::activity().draws;
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

void Resolve::shade(const GBuffer& gbuffer, const Masks& masks, const Silhouettes& silhouettes) {
    drawFullScreen(shade_, target_.framebuffer(), gbuffer, masks, silhouettes);
    targetWithDepth_.bind();
}

std::vector<float> Resolve::readRadiance() {
    return target_.readMean(4);
}

std::vector<float> Resolve::readData(const Data& data, const GBuffer& gbuffer, const Masks& masks,
                                     const Silhouettes& silhouettes, const glm::mat4& worldFromView) {
    auto program = data_.find(data.name);
    if (program == data_.end()) {
        const char* sampling = data.firstSample ? "FIRST_SAMPLE 1" : "EVERY_SAMPLE 1";
        program =
            data_
                .emplace(data.name,
                         gpu::Program("fullscreen.vert", "data.frag",
                                      {samplesOf(gbuffer), sampling, fmt::format("AOV_{} 1", capitals(data.name))}))
                .first;
    }
    program->second.uniform(2, data.firstLight);
    if (data.firstSample) glProgramUniform2fv(program->second.name(), 5, 1, &firstSample_.x);
    glProgramUniformMatrix4fv(program->second.name(), 3, 1, GL_FALSE, &worldFromView[0][0]);
    drawFullScreen(program->second, target_.framebuffer(), gbuffer, masks, silhouettes);
    return target_.readMean(data.components);
}

void Resolve::drawSample(const gpu::Program& program, const GBuffer& gbuffer, const Masks& masks,
                         const Silhouettes& silhouettes, int sample, const glm::vec2& position) {
    if (!sample_) sample_ = gpu::ScreenTarget("one sample", GL_RG32UI, {gbuffer.width(), gbuffer.height()}, nullptr);
    if (gbuffer.samples() > 1) program.uniform(4, GLint(sample));
    if (&program != &seen_) glProgramUniform2f(program.name(), 5, position.x, position.y);
    drawFullScreen(program, sample_.framebuffer(), gbuffer, masks, silhouettes);
}

std::vector<gpu::uvec2> Resolve::readSample(const GBuffer& gbuffer, const Masks& masks, const Silhouettes& silhouettes,
                                            int sample, const glm::vec2& position, std::uint32_t group) {
    const int width = gbuffer.width(), height = gbuffer.height();
    sampleData_.uniform(2, group);
    drawSample(sampleData_, gbuffer, masks, silhouettes, sample, position);
    std::vector<gpu::uvec2> pixels(std::size_t(width) * std::size_t(height));
    gpu::readPixels(sample_.framebuffer().name(), width, height, GL_RG_INTEGER, GL_UNSIGNED_INT,
                    pixels.size() * sizeof(gpu::uvec2), pixels.data());
    return pixels;
}

void Resolve::readSeen(const GBuffer& gbuffer, const Masks& masks, const Silhouettes& silhouettes, int sample,
                       const glm::vec2& position, SeenSample& seen) {
    const int width = gbuffer.width(), height = gbuffer.height();
    const std::size_t pixels = std::size_t(width) * std::size_t(height), bytes = 4 * pixels;
    seen.triangles.resize(pixels);
    seen.depths.resize(pixels);
    if (gbuffer.samples() == 1) {
        const GLuint from = gbuffer.framebuffer.name();
        gpu::readPixels(from, width, height, GL_RED_INTEGER, GL_UNSIGNED_INT, bytes, seen.triangles.data());
        gpu::readPixels(from, width, height, GL_DEPTH_COMPONENT, GL_FLOAT, bytes, seen.depths.data());
        return;
    }
    drawSample(seen_, gbuffer, masks, silhouettes, sample, position);
    const GLuint from = sample_.framebuffer().name();
    gpu::readPixels(from, width, height, GL_RED_INTEGER, GL_UNSIGNED_INT, bytes, seen.triangles.data());
    gpu::readPixels(from, width, height, GL_GREEN_INTEGER, GL_UNSIGNED_INT, bytes, seen.depths.data());
}

}  // namespace umbrage
