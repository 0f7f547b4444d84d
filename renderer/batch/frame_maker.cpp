// SPDX-License-Identifier: Apache-2.0
#include "batch/frame_maker.h"

#include <algorithm>
#include <chrono>
#include <map>
#include <utility>
#include <vector>

#include "batch/frame_files.h"
#include "diagnostics/median.h"
#include "frame/accumulate.h"
#include "frame/settings.h"

namespace umbrage {

namespace {

using Clock = std::chrono::steady_clock;

double millisecondsSince(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

}  // namespace

FrameMaker::FrameMaker(const Job& job, const Composition& composition, const Moment& first, const gpu::Context& context,
                       bool figures)
    : job_(job),
      composition_(composition),
      outputs_(neededOutputs(job)),
      renderer_(composition.scene, first, settingsOf(job, composition), context) {
    outputs_.figures = outputs_.figures || figures;
    const auto another = [&](const FrameSettings& settings) {
        return std::make_unique<FrameRenderer>(composition.scene, first, settings, context);
    };
    if (comparesTechniques(job)) {
        FrameSettings settings = settingsOf(job, composition);
        choose(techniqueAgainst(job), settings);
        against_ = another(settings);
    }
    if (anyNeeds(job.statistics.budgets, BudgetNeeds::Ratio)) {
        FrameSettings settings = settingsOf(job, composition);
        settings.profile = false;  // passes that are waited for take longer
        shadowed_ = another(settings);
        settings.shadows = false;
        unshadowed_ = another(settings);
    }
}

FrameMaker::Placed FrameMaker::place(int frame) const {
    const Clock::time_point start = Clock::now();
    Placed placed{placedMoment(job_, composition_, frame), std::nullopt};
    if (outputs_.wants("motion")) placed.before = placedMoment(job_, composition_, frame - 1);
    placed.milliseconds = millisecondsSince(start);
    return placed;
}

double FrameMaker::pictureMilliseconds(FrameRenderer& renderer, const PlacedMoment& now, int frame) const {
    Statistics unused;
    const Clock::time_point start = Clock::now();
    renderAccumulated(renderer, now, {}, frame, unused);
    return millisecondsSince(start);
}

void FrameMaker::measureRatio(const PlacedMoment& now, int frame, Statistics& statistics) {
    if (!std::exchange(ratioIsWarm_, true)) {  // a renderer's first frame sets things up
        for (FrameRenderer* renderer : {shadowed_.get(), unshadowed_.get()}) pictureMilliseconds(*renderer, now, frame);
    }
    std::vector<double> with, without;
    for (int repeat = 0; repeat < job_.diagnostics.repeats; ++repeat) {
        with.push_back(pictureMilliseconds(*shadowed_, now, frame));
        without.push_back(pictureMilliseconds(*unshadowed_, now, frame));
    }
    statistics.record(frame, {}, "time.picture", median(with));
    statistics.record(frame, {}, "time.unshadowed", median(without));
    statistics.record(frame, {}, "time.frame.ratio", median(with) / median(without));
}

WriteQueue::Item FrameMaker::make(int frame, const Placed& placed, Statistics& statistics) {
    const auto& [moment, camera] = placed.now;
    WriteQueue::Item item{frame, nullptr, nullptr, std::nullopt};
    std::map<std::size_t, std::vector<double>> milliseconds;  // per counter, of each repeat
    for (int repeat = 0; repeat < job_.diagnostics.repeats; ++repeat) {
        const Clock::time_point start = Clock::now();
        item.pixels = std::make_unique<FramePixels>(renderAccumulated(
            renderer_, placed.now, outputs_, frame, statistics, placed.before ? &*placed.before : nullptr));
        milliseconds[Counter("time.frame").index()].push_back(placed.milliseconds + millisecondsSince(start));
        for (const auto& [pass, time] : item.pixels->milliseconds) milliseconds[pass].push_back(time);
    }
    if (job_.diagnostics.profile) {
        for (const auto& [counter, values] : milliseconds) {
            statistics.record(frame, {}, Counter::at(counter), median(values));
        }
    }
    if (shadowed_) measureRatio(placed.now, frame, statistics);
    if (against_) {
        FrameOutputs itsFill;
        itsFill.radiance = false;
        itsFill.overdraw = true;
        Statistics unused;
        item.against = std::make_unique<FramePixels>(against_->render(moment, camera, itsFill, frame, unused));
    }
    return item;
}

}  // namespace umbrage
