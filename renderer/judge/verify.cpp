// SPDX-License-Identifier: Apache-2.0
#include "judge/verify.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <memory>

#include "error.h"
#include "job/names.h"
#include "judge/judge.h"
#include "judge/random_scene.h"
#include "scene/compose.h"

namespace umbrage {
namespace {

/// Renders moments of one scene by several techniques and judges them.
class Verifier {
public:
    Verifier(const Scene& scene, const Moment& first, const FrameSettings& settings, const gpu::Context& context,
             const DisplayTransform& display, const VerifyOptions& options)
        : display_(display),
          options_(options),
          judge_(scene, settings.width, settings.height, toleranceOf(context.subPixelBits()), options.threads) {
        for (const Technique& technique : options.techniques) {
            FrameSettings own = settings;
            choose(technique, own);
            own.fault = options.fault;
            contenders_.push_back({technique.name(), std::make_unique<FrameRenderer>(scene, first, own, context)});
        }
    }

    void judgeFrame(int frame, const Moment& moment, const PlacedCamera& camera, bool onlyFirst,
                    VerifyObserver& observer) {
        for (const Contender& contender : contenders_) {
            const bool first = &contender == &contenders_.front();
            if (!first && onlyFirst) return;
            judgeOne(contender, first, frame, moment, camera, observer);
        }
    }

private:
    struct Contender {
        std::string name;
        std::unique_ptr<FrameRenderer> renderer;
    };

    void judgeOne(const Contender& contender, bool first, int frame, const Moment& moment, const PlacedCamera& camera,
                  VerifyObserver& observer) {
        using Clock = std::chrono::steady_clock;
        FrameRenderer& renderer = *contender.renderer;
        FrameOutputs outputs, counting;
        outputs.samples = counting.counts = true;
        Statistics unused;
        const Clock::time_point start = Clock::now();
        FramePixels pixels = renderer.render(moment, camera, outputs, frame, unused);
        for (const std::string& note : pixels.notes) observer.note(note);
        const double milliseconds = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
        if (first || pixels.seen.triangles != seen_) {  // techniques draw the same surfaces, unless a fault is planted
            judge_.setFrame(moment, camera, renderer, pixels);
            exactRadiance_ = renderer.shadeAgain(judge_.exact());
            seen_ = pixels.seen.triangles;
        }
        if (options_.counts) {
            FramePixels counted = renderer.render(moment, camera, counting, frame, unused);
            for (std::size_t l = 0; l < pixels.lights.size(); ++l) {
                pixels.lights[l].counts = std::move(counted.lights[l].counts);
                pixels.lights[l].countsAreWide = counted.lights[l].countsAreWide;
            }
        }
        VerdictPlanes planes;
        FrameVerdict verdict = judge_.judge(pixels, contender.name, planes);
        verdict.frame = frame;
        verdict.technique = contender.name;
        verdict.radiance = compareRadiance(pixels.radiance, exactRadiance_, display_);
        verdict.renderMilliseconds = milliseconds;
        observer.judged(verdict, planes, pixels.radiance);
    }

    const DisplayTransform& display_;
    const VerifyOptions& options_;
    Judge judge_;
    std::vector<Contender> contenders_;
    std::vector<std::uint32_t> seen_;   // what the frame's exact answers are about
    std::vector<float> exactRadiance_;  // the frame shaded with them
};

}  // namespace

std::vector<Technique> parseTechniques(const std::string& text) {
    if (text == "all") return allTechniques();
    std::vector<Technique> parsed;
    const std::vector<std::string> names = techniqueNames();
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        const std::string name = text.substr(begin, end - begin);
        if (std::find(names.begin(), names.end(), name) == names.end()) {
            throw Error(ErrorKind::Usage, "--techniques", fmt::format("there is no technique \"{}\"", name),
                        fmt::format("all, or some of {}", fmt::join(names, ", ")));
        }
        parsed.push_back(Technique::named(name));
        begin = end + 1;
    }
    return parsed;
}

void verify(const Job& job, const gpu::Context& context, const DisplayTransform& display, const VerifyOptions& options,
            VerifyObserver& observer, const std::atomic<bool>& interrupted) {
    GltfOptions gltf;
    gltf.allowExternalFiles = options.allowExternalFiles;
    const Composition composition = compose(job, gltf);
    for (const std::string& note : composition.scene.notes) observer.note(note);
    const FrameRange range = framesOf(job, composition);
    const std::vector<int>& frames = range.frames();
    const auto momentAt = [&](int frame) {
        return evaluate(composition.scene, composition.animations, frameSeconds(job, frame));
    };
    Verifier verifier(composition.scene, momentAt(frames.front()), settingsOf(job, composition), context, display,
                      options);
    const auto every = std::size_t(std::max(1, options.othersEvery));
    observer.started(frames.size() + (options.techniques.size() - 1) * ((frames.size() + every - 1) / every));
    for (std::size_t f = 0; f < frames.size() && !interrupted; ++f) {
        const Moment moment = momentAt(frames[f]);
        const PlacedCamera camera = placeCamera(composition.scene, moment, composition.cameraNode);
        verifier.judgeFrame(frames[f], moment, camera, f % every != 0, observer);
    }
}

void verifyRandom(std::uint64_t seed, int count, const gpu::Context& context, const DisplayTransform& display,
                  const VerifyOptions& options, VerifyObserver& observer, const std::atomic<bool>& interrupted) {
    observer.started(std::size_t(count) * options.techniques.size());
    for (int i = 0; i < count && !interrupted; ++i) {
        const RandomScene made = randomScene(seed + std::uint64_t(i));
        const Moment moment = evaluate(made.scene, {}, 0.0);
        FrameSettings settings;
        settings.width = made.width;
        settings.height = made.height;
        Verifier(made.scene, moment, settings, context, display, options)
            .judgeFrame(i + 1, moment, made.camera, false, observer);
    }
}

}  // namespace umbrage
