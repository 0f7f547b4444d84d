// SPDX-License-Identifier: Apache-2.0
#include "shadow/masks.h"

#include <algorithm>
#include <cstdlib>

namespace umbrage {

Masks::Masks(const gpu::Texture& depthStencil, std::uint32_t lightCount) : depthStencil_(depthStencil) {
    gpu::Texture::Size size = depthStencil.size();
    size.layers = int(std::max(1u, (lightCount + LIGHTS_PER_GROUP - 1) / LIGHTS_PER_GROUP));
    texture_ = gpu::Texture("shadow masks", GL_R32UI, size);
    for (int layer = 0; layer < size.layers; ++layer) {
        const gpu::Framebuffer::Attachment color{&texture_, layer};
        framebuffers_.emplace_back("shadow mask", std::span(&color, 1), &depthStencil);
    }
    stencilOnly_ = gpu::Framebuffer("shadow counts", {}, &depthStencil);
    if (size.samples > 1) {
        oneSample_ = gpu::Texture("one sample of counts", GL_DEPTH32F_STENCIL8, {size.width, size.height});
        oneSampleTarget_ = gpu::Framebuffer("one sample of counts", {}, &oneSample_);
        oneWideSample_ = gpu::Texture("one sample of wide counts", GL_R32F, {size.width, size.height});
        const gpu::Framebuffer::Attachment color{&oneWideSample_};
        oneWideSampleTarget_ = gpu::Framebuffer("one sample of wide counts", std::span(&color, 1), nullptr);
    }
}

void Masks::clear() {
    depthIsCopied_ = false;
    gpu::RasterState state;
    state.color = gpu::ColorOp::Replace;
    gpu::apply(state);
    const GLuint zero[4] = {0, 0, 0, 0};
    for (const gpu::Framebuffer& framebuffer : framebuffers_) {
        framebuffer.bind();
        glClearBufferuiv(GL_COLOR, 0, zero);
    }
}

void Masks::count(const CountPlan& plan, VolumeRenderer& renderer, const Geometry& geometry,
                  const Silhouettes& silhouettes, const LightGroup& group, std::uint32_t l) {
    if (plan.wide && !plan.allDark) {
        countByBlending(plan, renderer, geometry, silhouettes, group, l);
    } else {
        if (!plan.allDark) drawIntoStencil(plan, renderer, geometry, silhouettes, group, l);
        gpu::Stencil stencil;
        stencil.enabled = !plan.allDark;
        stencil.function = GL_NOTEQUAL;
        stencil.reference = plan.litValue & 0xff;
        mark(markProgram_, stencil, group, l);
    }
}

void Masks::drawIntoStencil(const CountPlan& plan, VolumeRenderer& renderer, const Geometry& geometry,
                            const Silhouettes& silhouettes, const LightGroup& group, std::uint32_t l) {
    stencilOnly_.bind();
    glStencilMask(0xff);
    const GLint zero = 0;
    glClearBufferiv(GL_STENCIL, 0, &zero);
    for (const VolumePart& part : plan.parts) {
        renderer.draw(part, VolumeRenderer::Into::Stencil, geometry, silhouettes, group, l);
    }
}

bool Masks::parityTells(const CountPlan& plan, VolumeRenderer& renderer, const Geometry& geometry,
                        const Silhouettes& silhouettes, const LightGroup& group, std::uint32_t l) {
    if (plan.allDark) return true;
    if (plan.fullIsWide) return false;  // more than is counted here
    CountPlan full = plan;
    for (VolumePart& part : full.parts) part.inverts = false;
    drawIntoStencil(full, renderer, geometry, silhouettes, group, l);
    gpu::Stencil stencil;
    stencil.enabled = true;
    stencil.function = GL_EQUAL;
    stencil.reference = plan.fullLitValue & 0xff;
    const std::uint64_t lit = samplesWith(stencil);
    stencil.compared = 1;
    return samplesWith(stencil) == lit;
}

std::uint64_t Masks::samplesWith(const gpu::Stencil& stencil) {
    gpu::RasterState state;
    state.stencil = stencil;
    gpu::apply(state);
    const gpu::SampleQuery query("samples of a count");
    query.begin();
    everywhere_.use();
    noVertices_.bind();
    ++gpu::activity().draws;
    glDrawArrays(GL_TRIANGLES, 0, 3);
    query.end();
    return query.result();
}

void Masks::countByBlending(const CountPlan& plan, VolumeRenderer& renderer, const Geometry& geometry,
                            const Silhouettes& silhouettes, const LightGroup& group, std::uint32_t l) {
    if (!wideCounts_.name()) {
        const gpu::Texture::Size size = depthStencil_.size();
        wideCounts_ = gpu::Texture("wide counts", GL_R32F, size);
        const gpu::Framebuffer::Attachment color{&wideCounts_};
        wideTarget_ = gpu::Framebuffer("wide counts", std::span(&color, 1), &depthStencil_);
        markWideProgram_ = gpu::Program("fullscreen.vert", "mask.frag", {"COUNTS " + std::to_string(size.samples)});
    }
    wideTarget_.bind();
    gpu::RasterState state;
    state.color = gpu::ColorOp::Replace;
    gpu::apply(state);
    const float zero[4] = {};
    glClearBufferfv(GL_COLOR, 0, zero);
    if (plan.byParts) {
        silhouettes.bind();
        start(plan.starts);
    }
    for (const VolumePart& part : plan.parts) {
        renderer.draw(part, VolumeRenderer::Into::Counter, geometry, silhouettes, group, l);
    }
    wideCounts_.bind(0);
    markWideProgram_.uniform(1, float(plan.litValue));
    mark(markWideProgram_, {}, group, l);
}

/// Once a frame.
void Masks::copyDepth() {
    const gpu::Texture::Size size = depthStencil_.size();
    if (!seenDepth_.name()) {
        seenDepth_ = gpu::Texture("depth of what is seen", GL_DEPTH32F_STENCIL8, size);
        seenDepthTarget_ = gpu::Framebuffer("depth of what is seen", {}, &seenDepth_);
        startProgram_ =
            gpu::Program("fullscreen.vert", "split_start.frag", {"SAMPLES " + std::to_string(size.samples)});
    }
    if (!std::exchange(depthIsCopied_, true)) {
        glBlitNamedFramebuffer(stencilOnly_.name(), seenDepthTarget_.name(), 0, 0, size.width, size.height, 0, 0,
                               size.width, size.height, GL_DEPTH_BUFFER_BIT, GL_NEAREST);
    }
    seenDepth_.bind(0);
}

/// Adds what parts of the casters start from.
void Masks::start(std::span<const std::uint32_t> parts) {
    copyDepth();
    gpu::RasterState state;
    state.color = gpu::ColorOp::Add;
    gpu::apply(state);
    startProgram_.use();
    noVertices_.bind();
    for (const std::uint32_t part : parts) {
        startProgram_.uniform(0, part);
        ++gpu::activity().draws;
        glDrawArrays(GL_TRIANGLES, 0, 3);
    }
}

void Masks::mark(const gpu::Program& program, const gpu::Stencil& stencil, const LightGroup& group, std::uint32_t l) {
    framebuffers_[group.first / LIGHTS_PER_GROUP].bind();
    gpu::RasterState state;
    state.color = gpu::ColorOp::OrBits;
    state.stencil = stencil;
    gpu::apply(state);
    program.uniform(0, 1u << l);
    program.use();
    noVertices_.bind();
    ++gpu::activity().draws;
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

void Masks::set(std::uint32_t group, std::span<const std::uint32_t> bits) {
    const gpu::Texture::Size size = texture_.size();
    if (size.samples == 1) {
        gpu::activity().uploadedBytes += bits.size_bytes();
        glTextureSubImage3D(texture_.name(), 0, 0, 0, GLint(group), size.width, size.height, 1, GL_RED_INTEGER,
                            GL_UNSIGNED_INT, bits.data());
        return;
    }
    if (!given_.sizeBytes()) {
        givenProgram_ = gpu::Program("fullscreen.vert", "given_mask.frag", {"SAMPLES " + std::to_string(size.samples)});
    }
    given_.reserve("given masks", bits.size_bytes());
    given_.write(bits);
    given_.bindStorage(BIND_QUADS);
    framebuffers_[group].bind();
    gpu::RasterState state;
    state.color = gpu::ColorOp::Replace;
    gpu::apply(state);
    glProgramUniform2ui(givenProgram_.name(), 0, GLuint(size.width), GLuint(size.height));
    givenProgram_.use();
    noVertices_.bind();
    ++gpu::activity().draws;
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

void Masks::read(std::uint32_t group, std::span<std::uint32_t> bits) const {
    const gpu::Texture::Size size = texture_.size();
    const std::size_t bytes = std::size_t(size.width) * std::size_t(size.height) * sizeof(std::uint32_t);
    gpu::readPixels(framebuffers_[group].name(), size.width, size.height, GL_RED_INTEGER, GL_UNSIGNED_INT, bytes,
                    bits.data());
}

const gpu::Framebuffer& Masks::singleSampled(bool wide) const {
    const gpu::Framebuffer& counted = wide ? wideTarget_ : stencilOnly_;
    if (!oneSample_.name()) return counted;
    if (!wide) {
        const GLint width = texture_.size().width, height = texture_.size().height;
        glBlitNamedFramebuffer(counted.name(), oneSampleTarget_.name(), 0, 0, width, height, 0, 0, width, height,
                               GL_STENCIL_BUFFER_BIT, GL_NEAREST);
        return oneSampleTarget_;
    }
    oneWideSampleTarget_.bind();
    gpu::RasterState state;
    state.color = gpu::ColorOp::Replace;
    gpu::apply(state);
    wideCounts_.bind(0);
    firstSampleProgram_.use();
    noVertices_.bind();
    ++gpu::activity().draws;
    glDrawArrays(GL_TRIANGLES, 0, 3);
    return oneWideSampleTarget_;
}

std::vector<std::uint32_t> Masks::readCounts(const CountPlan& plan) const {
    const int width = texture_.size().width, height = texture_.size().height;
    const bool wide = plan.wide && !plan.allDark;
    const GLuint from = singleSampled(wide).name();
    std::vector<std::uint32_t> counts(std::size_t(width) * std::size_t(height));
    if (wide) {
        std::vector<float> values(counts.size());
        gpu::readPixels(from, width, height, GL_RED, GL_FLOAT, 4 * values.size(), values.data());
        for (std::size_t i = 0; i < counts.size(); ++i)
            counts[i] = std::uint32_t(std::abs(int(values[i]) - plan.litValue));
    } else {
        std::vector<std::uint8_t> values(counts.size());
        gpu::readPixels(from, width, height, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, values.size(), values.data());
        for (std::size_t i = 0; i < counts.size(); ++i) {
            const auto count = std::uint8_t(values[i] - plan.litValue);
            counts[i] = count <= plan.layerBound ? count : 256u - count;
        }
    }
    return counts;
}

}  // namespace umbrage
