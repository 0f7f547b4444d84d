// SPDX-License-Identifier: Apache-2.0
#include "frame/volume_diagnostics.h"

#include <algorithm>
#include <optional>

#include "gpu/activity.h"
#include "image/palette.h"

namespace umbrage {
namespace {

constexpr std::size_t kTopCasters = 10;
static_assert(kTopCasters <= ATTRIBUTED);

/// Instances with the most fragments, most first; those without any are left out.
std::vector<std::uint32_t> topOf(const std::vector<double>& fragments) {
    std::vector<std::uint32_t> order;
    for (std::uint32_t i = 0; i < fragments.size(); ++i) {
        if (fragments[i] > 0.0) order.push_back(i);
    }
    std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return fragments[a] > fragments[b]; });
    order.resize(std::min(order.size(), kTopCasters));
    return order;
}

bool measuresFill(const FrameOutputs& outputs) {
    return outputs.overdraw || outputs.figures || outputs.topCasters || outputs.wants("cost");
}

}  // namespace

glm::vec3 colorOfLight(std::size_t place) {
    const Rgb8 color = categoryColor(place);
    return {float(color[0]) / 255.0f, float(color[1]) / 255.0f, float(color[2]) / 255.0f};
}

bool VolumeDiagnostics::wanted(const FrameOutputs& outputs) {
    return outputs.hulls || measuresFill(outputs);
}

void VolumeDiagnostics::begin(const FrameOutputs& outputs, FramePixels& pixels) {
    outputs_ = &outputs;
    pixels_ = &pixels;
    const std::size_t pixelCount = std::size_t(gbuffer_.width()) * std::size_t(gbuffer_.height());
    if (outputs.overdraw) pixels.overdrawFragments = pixels.overdrawUpdates = std::vector<float>(pixelCount);
    fragmentsOfCasters_.assign(geometry_.instanceCount(), 0.0);
    fragmentsInGroup_ = fragmentsOfCasters_;
    casterPlanes_.clear();
    plans_.clear();
    if (!outputs.hulls) return;
    if (!hulls_) hulls_ = std::make_unique<VolumeHulls>(gbuffer_.depthStencil);
    hulls_->clear();
}

void VolumeDiagnostics::light(std::vector<CountPlan> plans, const LightGroup& group, std::uint32_t l, std::size_t place,
                              bool halve, LightPlanes& planes, FrameRecorder& recorder) {
    const gpu::Uncounted uncounted;
    if (measuresFill(*outputs_)) measure(plans, group, l, halve, planes, recorder);
    if (outputs_->hulls) {
        const glm::vec3 color = colorOfLight(place);
        hulls_->draw(plans, color, volumes_, geometry_, silhouettes_, group, l);
    }
    if (outputs_->topCasters) plans_.push_back(std::move(plans));
}

void VolumeDiagnostics::measure(std::span<const CountPlan> plans, const LightGroup& group, std::uint32_t l, bool halve,
                                LightPlanes& planes, FrameRecorder& recorder) {
    if (!meter_) meter_ = std::make_unique<FillMeter>(gbuffer_.depthStencil);
    const bool casters = outputs_->figures || outputs_->topCasters;
    VolumeFill fill = meter_->measure(plans, casters, volumes_, geometry_, silhouettes_, group, l);
    for (std::size_t i = 0; outputs_->overdraw && i < fill.fragments.size(); ++i) {
        pixels_->overdrawFragments[i] += fill.fragments[i];
        pixels_->overdrawUpdates[i] += fill.updates[i];
    }
    if (outputs_->figures) {
        std::optional<int> startLayers = 0;
        for (const CountPlan& plan : plans) {
            const bool known = startLayers && !plan.allDark && plan.starts.empty();
            startLayers = known ? std::optional(*startLayers + plan.eyeLayers) : std::nullopt;
        }
        recorder.light(planes.id, l, silhouettes_, halve, fill, startLayers, planes.counts);
    }
    for (std::size_t i = 0; outputs_->topCasters && i < fill.casters.size(); ++i) {
        FillSums sums;
        sums.add(fill.casters[i], false, false);
        fragmentsInGroup_[i] += sums.fragments();
    }
    if (outputs_->wants("cost")) planes.aovs["cost"].values = std::move(fill.fragments);
}

void VolumeDiagnostics::endGroup(const LightGroup& group) {
    if (plans_.empty()) return;
    const gpu::Uncounted uncounted;
    const std::vector<std::uint32_t> top = topOf(fragmentsInGroup_);
    meter_->attribute(plans_, top, volumes_, geometry_, silhouettes_, group, casterPlanes_);
    for (std::size_t i = 0; i < fragmentsInGroup_.size(); ++i) {
        fragmentsOfCasters_[i] += std::exchange(fragmentsInGroup_[i], 0.0);
    }
    plans_.clear();
}

void VolumeDiagnostics::finish(const Scene& scene, const Moment& moment) {
    if (outputs_->hulls) pixels_->hulls = hulls_->read();
    if (!outputs_->topCasters) return;
    for (const std::uint32_t i : topOf(fragmentsOfCasters_)) {
        const std::string& path = scene.nodes[std::size_t(moment.instances[i].node)].path;
        pixels_->topCasters.push_back({path, fragmentsOfCasters_[i], std::move(casterPlanes_[i])});
    }
}

}  // namespace umbrage
