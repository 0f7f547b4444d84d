// SPDX-License-Identifier: Apache-2.0
#include "shadow/fill.h"

#include <algorithm>

namespace umbrage {

namespace {

/// What is counted; a plan that is all dark was decided without drawing.
void drawAll(std::span<const CountPlan> plans, VolumeRenderer::Into into, VolumeRenderer& renderer,
             const Geometry& geometry, const Silhouettes& silhouettes, const LightGroup& group, std::uint32_t l) {
    for (const CountPlan& plan : plans) {
        if (plan.allDark) continue;
        for (const VolumePart& part : plan.parts) renderer.draw(part, into, geometry, silhouettes, group, l);
    }
}

}  // namespace

FillMeter::FillMeter(const gpu::Texture& depthStencil)
    : depthStencil_(depthStencil),
      fragments_("volume fragments", GL_R32F, depthStencil.size(), nullptr),
      updates_("count updates", GL_R32F, depthStencil.size(), nullptr) {
    const gpu::Framebuffer::Attachment colors[] = {{&fragments_.texture()}, {&updates_.texture()}};
    both_ = gpu::Framebuffer("volume fragments and count updates", colors, nullptr);
}

VolumeFill FillMeter::measure(std::span<const CountPlan> plans, bool casters, VolumeRenderer& renderer,
                              const Geometry& geometry, const Silhouettes& silhouettes, const LightGroup& group,
                              std::uint32_t l) {
    VolumeFill fill;
    casters_.reserve("fill of casters", geometry.instanceCount() * sizeof(gpu::CasterFill));
    casters_.clearToZero();
    fragments_.clear();
    updates_.clear();
    both_.bind();
    casters_.bindStorage(BIND_FILL);
    depthStencil_.bind(0);
    const gpu::SampleQuery query("volume fragments");
    query.begin();
    const auto into = casters ? VolumeRenderer::Into::Tally : VolumeRenderer::Into::Fill;
    drawAll(plans, into, renderer, geometry, silhouettes, group, l);
    query.end();
    fill.queried = query.result();
    fill.fragments = fragments_.readMean(1);
    fill.updates = updates_.readMean(1);
    if (casters && geometry.instanceCount() > 0) {
        fill.casters.resize(geometry.instanceCount());
        casters_.read(0, fill.casters.size() * sizeof(gpu::CasterFill), fill.casters.data());
    }
    return fill;
}

void FillMeter::attribute(std::span<const std::vector<CountPlan>> plans, std::span<const std::uint32_t> casters,
                          VolumeRenderer& renderer, const Geometry& geometry, const Silhouettes& silhouettes,
                          const LightGroup& group, CasterPlanes& planes) {
    if (attributed_.empty()) {
        std::vector<gpu::Framebuffer::Attachment> colors;
        attributed_.reserve(ATTRIBUTED / 4);
        for (int i = 0; i < ATTRIBUTED / 4; ++i) {
            attributed_.emplace_back("fill of four casters", GL_RGBA32F, depthStencil_.size(), nullptr);
            colors.push_back({&attributed_.back().texture()});
        }
        allAttributed_ = gpu::Framebuffer("fill of casters", colors, nullptr);
    }
    std::vector<std::uint32_t> ranks(geometry.instanceCount(), ATTRIBUTED);
    for (std::size_t rank = 0; rank < casters.size(); ++rank) ranks[casters[rank]] = std::uint32_t(rank);
    ranks_.reserve("ranks of casters", ranks.size() * sizeof(std::uint32_t));
    ranks_.write(std::span<const std::uint32_t>(ranks));
    for (const gpu::ScreenTarget& four : attributed_) four.clear();
    allAttributed_.bind();
    ranks_.bindStorage(BIND_FILL);
    for (std::uint32_t l = 0; l < plans.size(); ++l) {
        drawAll(plans[l], VolumeRenderer::Into::Casters, renderer, geometry, silhouettes, group, l);
    }
    for (std::size_t first = 0; first < casters.size(); first += 4) {
        const std::vector<float> four = attributed_[first / 4].readMean(4);
        for (std::size_t rank = first; rank < std::min(first + 4, casters.size()); ++rank) {
            std::vector<float>& plane = planes[casters[rank]];
            plane.resize(four.size() / 4);
            for (std::size_t i = 0; i < plane.size(); ++i) plane[i] += four[4 * i + rank - first];
        }
    }
}

}  // namespace umbrage
