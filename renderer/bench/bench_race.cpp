// SPDX-License-Identifier: Apache-2.0
#include "bench/bench_race.h"

#include <fmt/format.h>
#include <tbb/task_arena.h>

#include <algorithm>

#include "diagnostics/median.h"

namespace umbrage {

double Race::Pair::shadowsMilliseconds() const {
    return median(shadowed->milliseconds()) - median(bare->milliseconds());
}

Races::Races(const Bench& bench, const BenchScenes& scenes, const Wishes& wishes, const char* what,
             const gpu::Context& context, BenchObserver& observer)
    : bench_(bench), scenes_(scenes), wishes_(wishes), what_(what), context_(context), observer_(observer) {}

Contender* Races::enter(std::unique_ptr<Contender> contender) {
    contenders_.push_back(std::move(contender));
    Contender* entered = contenders_.back().get();
    observer_.advanced(fmt::format("{} {}: set up", entered->scene().sequence.name, entered->name()));
    return entered;
}

bool Races::traces(const BenchScene& scene) const {
    return wishes_.tracer && bench_.tracerFor(scene.sequence);
}

bool Races::setUp(const BenchScene& scene, const std::atomic<bool>& interrupted) {
    std::vector<BenchTechnique> techniques = bench_.techniques;
    if (techniques.empty()) techniques = {{techniqueOf(scene.job)}};
    Race& race = races_.emplace_back();
    const Contender* bare = enter(makeRenderer(scene, nullptr, wishes_.passes, context_));
    for (const BenchTechnique& technique : techniques) {
        if (interrupted) return false;
        race.rows.push_back({enter(makeRenderer(scene, &technique, wishes_.passes, context_)), bare});
    }
    for (const int size : wishes_.shadowMaps) {
        for (const bool biased : {true, false}) {
            if (interrupted) return false;
            race.rows.push_back({enter(makeShadowMapped(scene, {size, biased}, context_)), bare});
        }
    }
    if (!traces(scene)) return true;
    const std::size_t first = race.rows.size();
    const Contender* bareTracer = nullptr;
    for (std::unique_ptr<Contender>& tracer : makeTracers(scene, wishes_.offsets)) {
        Contender* entered = enter(std::move(tracer));
        if (bareTracer) race.rows.push_back({entered, bareTracer});
        if (!bareTracer) bareTracer = entered;
    }
    race.tracer = race.rows[first];
    return true;
}

bool Races::run(std::vector<std::string>& remarks, const std::atomic<bool>& interrupted) {
    std::size_t count = 0;
    const auto traced = [&](const BenchScene* scene) { return traces(*scene); };
    for (const BenchScene* scene : scenes_) {
        count += 1 + std::max<std::size_t>(1, bench_.techniques.size()) + 2 * wishes_.shadowMaps.size();
        if (traced(scene)) count += 1 + std::max<std::size_t>(1, wishes_.offsets.size());
    }
    if (std::ranges::any_of(scenes_, traced)) {
        remarks.push_back(fmt::format(
            "The tracer has {} threads; placing its triangles and making its hierarchy are no part of its frames.",
            tbb::this_task_arena::max_concurrency()));
    }
    observer_.started(count * std::size_t(bench_.rounds + 2), what_);
    for (const BenchScene* scene : scenes_) {
        if (!setUp(*scene, interrupted)) return false;
    }
    for (int round = 0; round <= bench_.rounds; ++round) {
        for (const auto& contender : contenders_) {
            if (interrupted) return false;
            contender->run(round > 0);
            const std::string who = contender->scene().sequence.name + " " + contender->name();
            if (round == 0) {
                for (const std::string& note : contender->takeNotes()) {
                    remarks.push_back(fmt::format("{}: {}.", who, note));
                }
            }
            observer_.advanced(fmt::format("{}: round {}", who, round));
        }
        std::reverse(contenders_.begin(), contenders_.end());
    }
    return true;
}

}  // namespace umbrage
