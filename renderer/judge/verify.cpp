// SPDX-License-Identifier: Apache-2.0
#include "judge/verify.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <memory>

#include "error.h"
#include "frame/settings.h"
#include "judge/judge.h"
#include "scene/compose.h"

namespace umbrage {
namespace {

/// One technique's renderer, with and without counts.
struct Contender {
    Technique technique;
    std::unique_ptr<FrameRenderer> renderer;
};

FrameSettings settingsFor(const Technique& technique, const Job& job, const Composition& composition, Fault fault) {
    FrameSettings settings = settingsOf(job, composition);
    settings.silhouette = technique.silhouette;
    settings.count = technique.count == "z-fail" ? CountTechnique::ZFail : CountTechnique::ZPass;
    settings.fault = fault;
    return settings;
}

}  // namespace

const std::vector<Technique>& allTechniques() {
    static const std::vector<Technique> all = {
        {"compute", "z-pass"}, {"compute", "z-fail"}, {"cpu", "z-pass"}, {"cpu", "z-fail"}};
    return all;
}

std::vector<Technique> parseTechniques(const std::string& text) {
    if (text == "all") return allTechniques();
    std::vector<Technique> parsed;
    std::vector<std::string> names;
    for (const Technique& technique : allTechniques()) names.push_back(technique.name());
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        const std::string name = text.substr(begin, end - begin);
        const auto found = std::find(names.begin(), names.end(), name);
        if (found == names.end()) {
            throw Error(ErrorKind::Usage, "--techniques", fmt::format("there is no technique \"{}\"", name),
                        fmt::format("all, or some of {}", fmt::join(names, ", ")));
        }
        parsed.push_back(allTechniques()[std::size_t(found - names.begin())]);
        begin = end + 1;
    }
    return parsed;
}

void verify(const Job& job, const gpu::Context& context, const DisplayTransform& display, const VerifyOptions& options,
            VerifyObserver& observer, const std::atomic<bool>& interrupted) {
    using Clock = std::chrono::steady_clock;
    GltfOptions gltf;
    gltf.allowExternalFiles = options.allowExternalFiles;
    const Composition composition = compose(job, gltf);
    for (const std::string& note : composition.scene.notes) observer.note(note);
    const FrameRange range = framesOf(job, composition);
    const std::vector<int>& frames = range.frames();
    const auto momentAt = [&](int frame) {
        return evaluate(composition.scene, composition.animations, double(frame) / job.time.framesPerSecond);
    };
    const Moment first = momentAt(frames.front());

    std::vector<Contender> contenders;
    std::size_t expected = 0;
    for (const Technique& technique : options.techniques) {
        const FrameSettings settings = settingsFor(technique, job, composition, options.fault);
        contenders.push_back({technique, std::make_unique<FrameRenderer>(composition.scene, first, settings, context)});
        const std::size_t every = contenders.size() == 1 ? 1 : std::size_t(std::max(1, options.othersEvery));
        expected += (frames.size() + every - 1) / every;
    }
    observer.started(expected);

    Judge judge(composition.scene, job.image.width, job.image.height, toleranceOf(context.subPixelBits()),
                options.threads);
    FrameOutputs outputs;
    outputs.samples = true;
    for (std::size_t f = 0; f < frames.size(); ++f) {
        const Moment moment = momentAt(frames[f]);
        const PlacedCamera camera = placeCamera(composition.scene, moment, composition.cameraNode);
        for (std::size_t c = 0; c < contenders.size(); ++c) {
            if (c > 0 && options.othersEvery > 1 && f % std::size_t(options.othersEvery) != 0) continue;
            if (interrupted) return;
            FrameRenderer& renderer = *contenders[c].renderer;
            Statistics unused;
            const Clock::time_point start = Clock::now();
            FramePixels pixels = renderer.render(moment, camera, outputs, frames[f], unused);
            const double milliseconds = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
            if (c == 0) judge.setFrame(moment, camera, renderer, pixels);
            // The first technique's G-buffer decided where alpha masks have holes; all of them draw the same one.
            const std::vector<float> exactRadiance = renderer.shadeAgain(judge.exact());
            if (options.counts) {
                FrameOutputs counting;
                counting.counts = true;
                const FramePixels counted = renderer.render(moment, camera, counting, frames[f], unused);
                for (std::size_t l = 0; l < pixels.lights.size(); ++l) {
                    pixels.lights[l].counts = counted.lights[l].counts;
                    pixels.lights[l].countsAreWide = counted.lights[l].countsAreWide;
                }
            }
            VerdictPlanes planes;
            FrameVerdict verdict = judge.judge(pixels, contenders[c].technique.name(), planes);
            verdict.frame = frames[f];
            verdict.technique = contenders[c].technique.name();
            verdict.radiance = compareRadiance(pixels.radiance, exactRadiance, display);
            verdict.renderMilliseconds = milliseconds;
            observer.judged(verdict, planes, pixels.radiance);
        }
    }
}

}  // namespace umbrage
