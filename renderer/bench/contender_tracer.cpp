// SPDX-License-Identifier: Apache-2.0
#include "bench/bench_contender.h"
#include "bench/stopwatch.h"
#include "bench/tracer.h"
#include "diagnostics/median.h"

namespace umbrage {
namespace {

/// A sequence as the tracer traces it. Placing its triangles is no part of a frame's time.
class TracedSequence {
public:
    explicit TracedSequence(const BenchScene& scene)
        : scene_(scene),
          geometry_(scene.composition.scene, scene.at(scene.frames.front()).moment),
          traced_(scene.composition.scene) {}

    /// Goes to a frame: afterwards its hierarchy is the frame's.
    void goTo(int frame) {
        const PlacedMoment now = scene_.at(frame);
        const Eye eye = makeEye(now.camera, scene_.job.image.width, scene_.job.image.height);
        geometry_.update(scene_.composition.scene, now.moment, eye);
        if (!traced_.place(now.moment, geometry_, eye)) return;
        if (!builds_.empty()) refits_.push_back(traced_.refit());
        builds_.push_back(traced_.build());
    }

    const TracerScene& traced() const { return traced_; }
    const std::vector<double>& builds() const { return builds_; }
    const std::vector<double>& refits() const { return refits_; }

private:
    const BenchScene& scene_;
    Geometry geometry_;
    TracerScene traced_;
    std::vector<double> builds_, refits_;
};

std::optional<double> medianOf(const std::vector<double>& values) {
    return values.empty() ? std::nullopt : std::optional(median(values));
}

class TracerContender : public Contender {
public:
    TracerContender(const BenchScene& scene, std::shared_ptr<TracedSequence> traced, bool shadows)
        : Contender(scene, shadows ? "tracer" : "tracer without shadows"),
          sequence_(std::move(traced)),
          tracer_(sequence_->traced(), settingsFor(scene, shadows)) {
        const auto blends = [](const Material& m) { return m.alphaMode == AlphaMode::Blend; };
        if (shadows && std::ranges::any_of(scene.composition.scene.materials, blends)) {
            notes_.insert("blended surfaces are left out");
        }
        frame(scene.frames.front());
    }

    void run(bool counted) override {
        for (const int number : scene_.frames) {
            const double whole = frame(number);
            if (counted) milliseconds_.push_back(whole);
        }
    }

    /// With what it took until then.
    void setCold(double milliseconds) { coldMilliseconds_ = milliseconds; }

    std::optional<double> buildMilliseconds() const override { return medianOf(sequence_->builds()); }
    std::optional<double> refitMilliseconds() const override { return medianOf(sequence_->refits()); }

private:
    static TracerSettings settingsFor(const BenchScene& scene, bool shadows) {
        TracerSettings settings = tracerSettings(settingsOf(scene.job, scene.composition));
        settings.shadows = shadows;
        return settings;
    }

    /// Like the renderer's, its time begins with the moment's evaluation.
    double frame(int number) {
        sequence_->goTo(number);
        const Stopwatch watch;
        const PlacedMoment now = scene_.at(number);
        tracer_.trace(now.moment, now.camera);
        return watch.milliseconds();
    }

    std::shared_ptr<TracedSequence> sequence_;
    Tracer tracer_;
};

}  // namespace

std::array<std::unique_ptr<Contender>, 2> makeTracers(const BenchScene& scene) {
    const Stopwatch watch;
    const auto traced = std::make_shared<TracedSequence>(scene);
    auto tracer = std::make_unique<TracerContender>(scene, traced, true);
    tracer->setCold(watch.milliseconds());
    return {std::move(tracer), std::make_unique<TracerContender>(scene, traced, false)};
}

}  // namespace umbrage
