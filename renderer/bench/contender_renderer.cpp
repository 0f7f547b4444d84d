// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "bench/bench_contender.h"
#include "bench/stopwatch.h"
#include "diagnostics/median.h"
#include "shading/lights.h"

namespace umbrage {
namespace {

class RendererContender : public Contender {
public:
    RendererContender(const BenchScene& scene, std::string name, FrameSettings settings, bool passes,
                      const gpu::Context& context)
        : Contender(scene, std::move(name)) {
        settings.profile = false;
        const Stopwatch watch;
        plain_ = scene.renderer(settings, context);
        render(*plain_, scene.frames.front(), {});
        coldMilliseconds_ = watch.milliseconds();
        if (!passes) return;
        settings.profile = true;  // passes are waited for, so the frame's own time is measured without
        profiled_ = scene.renderer(settings, context);
    }

    void run(bool counted) override {
        for (const int frame : scene_.frames) {
            const Stopwatch watch;
            render(*plain_, frame, {});
            const double whole = watch.milliseconds();
            if (counted) milliseconds_.push_back(whole);
            if (!profiled_) continue;
            for (const auto& [pass, time] : render(*profiled_, frame, {}).milliseconds) {
                if (counted) passes_[pass].push_back(time);
            }
        }
    }

    FramePixels samples(int frame) override {
        FrameOutputs outputs;
        outputs.samples = true;
        return render(*plain_, frame, outputs);
    }
    const FrameRenderer* renderer() const override { return plain_.get(); }

    std::optional<double> pass(Counter counter) const override {
        const auto found = passes_.find(counter.index());
        return found == passes_.end() ? std::nullopt : std::optional(median(found->second));
    }

    /// For all lights that are on in the first frame.
    std::optional<double> edges() const override {
        const Moment moment = scene_.at(scene_.frames.front()).moment;
        const auto lights = std::ranges::count_if(moment.lights, [](const auto& l) { return isOn(l.light); });
        double edges = 0.0;
        for (const gpu::InstanceData& instance : plain_->geometry().instances()) edges += instance.edgeCount;
        return edges * double(lights);
    }

private:
    FramePixels render(FrameRenderer& renderer, int frame, const FrameOutputs& outputs) {
        Statistics unused;
        const PlacedMoment now = scene_.at(frame);
        FramePixels pixels = renderer.render(now.moment, now.camera, outputs, frame, unused);
        notes_.insert(pixels.notes.begin(), pixels.notes.end());
        return pixels;
    }

    std::unique_ptr<FrameRenderer> plain_, profiled_;
    std::map<std::size_t, std::vector<double>> passes_;
};

}  // namespace

std::unique_ptr<Contender> makeRenderer(const BenchScene& scene, const BenchTechnique* technique, bool passes,
                                        const gpu::Context& context) {
    FrameSettings settings = settingsOf(technique ? technique->of(scene.job) : scene.job, scene.composition);
    settings.shadows = technique != nullptr;
    return std::make_unique<RendererContender>(scene, technique ? technique->name() : "without shadows", settings,
                                               technique && passes, context);
}

std::unique_ptr<Contender> makeShadowMapped(const BenchScene& scene, const ShadowMapSettings& settings,
                                            const gpu::Context& context) {
    FrameSettings frame = settingsOf(scene.job, scene.composition);
    frame.shadows = false;
    frame.maskMaker = makeShadowMaps(settings);
    return std::make_unique<RendererContender>(
        scene, fmt::format("shadow map {}{}", settings.size, settings.biased ? " biased" : ""), frame, false, context);
}

}  // namespace umbrage
