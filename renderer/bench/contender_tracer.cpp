// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

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
          traced_(scene.composition.scene) {
        goTo(scene.frames.front());
        setUpMilliseconds_ = watch_.milliseconds();
        const auto blends = [](const Material& m) { return m.alphaMode == AlphaMode::Blend; };
        if (std::ranges::any_of(scene.composition.scene.materials, blends)) {
            notes_.insert("blended surfaces are left out");
        }
    }

    /// Goes to a frame: afterwards its hierarchy is the frame's.
    void goTo(int frame) {
        const PlacedMoment now = scene_.at(frame);
        const Eye eye = makeEye(now.camera, scene_.job.image.width, scene_.job.image.height);
        geometry_.update(scene_.composition.scene, now.moment, eye);
        if (!traced_.place(now.moment, geometry_, eye)) return;
        if (!builds_.empty()) refits_.push_back(traced_.refit());
        builds_.push_back(traced_.build());
    }

    /// For the first contender that asks.
    std::set<std::string> takeNotes() { return std::exchange(notes_, {}); }
    double setUpMilliseconds() const { return setUpMilliseconds_; }
    const TracerScene& traced() const { return traced_; }
    const std::vector<double>& builds() const { return builds_; }
    const std::vector<double>& refits() const { return refits_; }

private:
    Stopwatch watch_;  // first: it times what follows
    const BenchScene& scene_;
    double setUpMilliseconds_ = 0.0;
    Geometry geometry_;
    TracerScene traced_;
    std::vector<double> builds_, refits_;
    std::set<std::string> notes_;
};

std::optional<double> medianOf(const std::vector<double>& values) {
    return values.empty() ? std::nullopt : std::optional(median(values));
}

class TracerContender : public Contender {
public:
    TracerContender(const BenchScene& scene, std::string name, std::shared_ptr<TracedSequence> traced,
                    const TracerSettings& settings)
        : Contender(scene, std::move(name)), sequence_(std::move(traced)), tracer_(sequence_->traced(), settings) {
        const Stopwatch watch;
        if (settings.shadows) notes_ = sequence_->takeNotes();
        frame(scene.frames.front());
        coldMilliseconds_ = sequence_->setUpMilliseconds() + watch.milliseconds();
    }

    void run(bool counted) override {
        for (const int number : scene_.frames) {
            const double whole = frame(number);
            if (counted) milliseconds_.push_back(whole);
        }
    }

    FramePixels samples(int frame) override {
        sequence_->goTo(frame);
        const PlacedMoment now = scene_.at(frame);
        return tracer_.traceSamples(now.moment, now.camera);
    }

    std::optional<double> buildMilliseconds() const override { return medianOf(sequence_->builds()); }
    std::optional<double> refitMilliseconds() const override { return medianOf(sequence_->refits()); }

private:
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

std::vector<std::unique_ptr<Contender>> makeTracers(const BenchScene& scene, const std::vector<double>& offsets) {
    const auto traced = std::make_shared<TracedSequence>(scene);
    TracerSettings settings = tracerSettings(settingsOf(scene.job, scene.composition));
    std::vector<std::unique_ptr<Contender>> made;
    const auto enter = [&](std::string name) {
        made.push_back(std::make_unique<TracerContender>(scene, std::move(name), traced, settings));
    };
    settings.shadows = false;
    enter("tracer without shadows");
    settings.shadows = true;
    if (offsets.empty()) enter("tracer");
    for (const double offset : offsets) {
        settings.offset = float(offset);
        enter(fmt::format("tracer {:g}", offset));
    }
    return made;
}

}  // namespace umbrage
