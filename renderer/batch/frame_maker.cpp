// SPDX-License-Identifier: Apache-2.0
#include "batch/frame_maker.h"

#include <algorithm>
#include <chrono>
#include <map>
#include <optional>
#include <vector>

#include "batch/frame_files.h"
#include "diagnostics/median.h"
#include "frame/settings.h"

namespace umbrage {

using Clock = std::chrono::steady_clock;

FrameMaker::FrameMaker(const Job& job, const Composition& composition, const Moment& first, const gpu::Context& context)
    : job_(job),
      composition_(composition),
      outputs_(neededOutputs(job)),
      renderer_(composition.scene, first, settingsOf(job, composition), context) {
    if (!comparesTechniques(job)) return;
    FrameSettings settings = settingsOf(job, composition);
    choose(techniqueAgainst(job), settings);
    against_ = std::make_unique<FrameRenderer>(composition.scene, first, settings, context);
}

PlacedMoment FrameMaker::at(int frame) const {
    return placedMoment(job_, composition_, frame);
}

WriteQueue::Item FrameMaker::make(int frame, Statistics& statistics) {
    WriteQueue::Item item{frame, nullptr, nullptr};
    std::optional<PlacedMoment> now, before;
    std::map<std::size_t, std::vector<double>> milliseconds;  // per counter, of each repeat
    for (int repeat = 0; repeat < job_.diagnostics.repeats; ++repeat) {
        const Clock::time_point start = Clock::now();
        now = at(frame);
        if (outputs_.wants("motion")) before = at(frame - 1);
        item.pixels = std::make_unique<FramePixels>(
            renderer_.render(now->moment, now->camera, outputs_, frame, statistics, before ? &*before : nullptr));
        const std::chrono::duration<double, std::milli> whole = Clock::now() - start;
        milliseconds[Counter("time.frame").index()].push_back(whole.count());
        for (const auto& [pass, time] : item.pixels->milliseconds) milliseconds[pass].push_back(time);
    }
    if (job_.diagnostics.profile) {
        for (const auto& [counter, values] : milliseconds) {
            statistics.record(frame, {}, Counter::at(counter), median(values));
        }
        statistics.record(frame, {}, "memory.peak", peakHostMemoryMebibytes());
    }
    if (against_) {
        FrameOutputs itsFill;
        itsFill.radiance = false;
        itsFill.overdraw = true;
        Statistics unused;
        item.against =
            std::make_unique<FramePixels>(against_->render(now->moment, now->camera, itsFill, frame, unused));
    }
    return item;
}

}  // namespace umbrage
