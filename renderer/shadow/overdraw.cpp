// SPDX-License-Identifier: Apache-2.0
#include "shadow/overdraw.h"

namespace umbrage {
namespace {

/// All fragments into one target, those that change counts into the other.
VolumeTotals drawTwice(const gpu::Framebuffer& all, const gpu::Framebuffer& counting, std::span<const CountPlan> plans,
                       VolumeRenderer& renderer, const Geometry& geometry, const Silhouettes& silhouettes,
                       const LightGroup& group, std::uint32_t l) {
    using Into = VolumeRenderer::Into;
    const gpu::SampleQuery fragments("volume fragments"), updates("count updates");
    const auto draw = [&](const gpu::Framebuffer& target, const gpu::SampleQuery& query, Into into) {
        target.bind();
        query.begin();
        for (const CountPlan& plan : plans) {
            for (const VolumePart& part : plan.parts) renderer.draw(part, into, geometry, silhouettes, group, l);
        }
        query.end();
    };
    draw(all, fragments, Into::Fragments);
    draw(counting, updates, Into::Updates);
    return {fragments.result(), updates.result()};
}

}  // namespace

Overdraw::Overdraw(const gpu::Texture& depthStencil) {
    const gpu::Texture::Size size = depthStencil.size();
    for (Plane* plane : {&fragments_, &updates_}) {
        plane->counts = gpu::Texture("overdraw", GL_R32F, size);
        const gpu::Framebuffer::Attachment color{&plane->counts};
        plane->target = gpu::Framebuffer("overdraw", std::span(&color, 1), &depthStencil);
        if (size.samples > 1) {
            plane->averaged = gpu::Texture("averaged overdraw", GL_R32F, {size.width, size.height});
            const gpu::Framebuffer::Attachment average{&plane->averaged};
            plane->averagedTarget = gpu::Framebuffer("averaged overdraw", std::span(&average, 1), nullptr);
        }
    }
}

void Overdraw::clear() {
    gpu::RasterState state;
    state.color = gpu::ColorOp::Replace;
    gpu::apply(state);
    const float zero[4] = {};
    for (const Plane* plane : {&fragments_, &updates_})
        glClearNamedFramebufferfv(plane->target.name(), GL_COLOR, 0, zero);
}

VolumeTotals Overdraw::add(std::span<const CountPlan> plans, VolumeRenderer& renderer, const Geometry& geometry,
                           const Silhouettes& silhouettes, const LightGroup& group, std::uint32_t l) {
    return drawTwice(fragments_.target, updates_.target, plans, renderer, geometry, silhouettes, group, l);
}

std::vector<float> Overdraw::Plane::read() const {
    const int width = counts.size().width, height = counts.size().height;
    const gpu::Framebuffer* source = &target;
    if (averaged.name()) {
        glBlitNamedFramebuffer(target.name(), averagedTarget.name(), 0, 0, width, height, 0, 0, width, height,
                               GL_COLOR_BUFFER_BIT, GL_NEAREST);
        source = &averagedTarget;
    }
    std::vector<float> values(std::size_t(width) * std::size_t(height));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, source->name());
    glReadPixels(0, 0, width, height, GL_RED, GL_FLOAT, values.data());
    return values;
}

std::vector<float> Overdraw::readFragments() const {
    return fragments_.read();
}

std::vector<float> Overdraw::readUpdates() const {
    return updates_.read();
}

VolumeTotals countVolumeSamples(const gpu::Framebuffer& depthOnly, std::span<const CountPlan> plans,
                                VolumeRenderer& renderer, const Geometry& geometry, const Silhouettes& silhouettes,
                                const LightGroup& group, std::uint32_t l) {
    return drawTwice(depthOnly, depthOnly, plans, renderer, geometry, silhouettes, group, l);
}

}  // namespace umbrage
