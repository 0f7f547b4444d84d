// SPDX-License-Identifier: Apache-2.0
#include "bench/bench_times.h"

#include <fmt/format.h>

#include <algorithm>

#include "bench/bench_race.h"
#include "diagnostics/median.h"
#include "report/statistics_compare.h"

namespace umbrage {
namespace {

constexpr std::array<Counter, 6> kPasses = {"time.position", "time.gbuffer", "time.silhouettes",
                                            "time.counts",   "time.resolve", "time.readback"};

/// @param tracer  with those that need it
std::vector<BenchColumn> columns(bool tracer) {
    std::vector<BenchColumn> made = {
        {"sequence", "sequence", "", -1},
        {"technique", "technique", "silhouettes:count", -1},
        {"frame.ms", "frame ms", "a frame evaluated, rendered and read back; median", 2},
        {"frame.low.ms", "from", "least median that the times allow (sign test, 95 %), ms", 2},
        {"frame.high.ms", "to", "greatest such median, ms", 2},
        {"unshadowed.ms", "no shadows", "the same frames without shadows; median, ms", 2},
        {"shadows.ms", "shadows", "the difference, ms", 2},
    };
    for (const Counter pass : kPasses) {
        const std::string name(pass.info().name);
        made.push_back(
            {name + ".ms", name.substr(name.find('.') + 1), std::string(pass.info().doc) + "; median, ms", 2});
    }
    made.push_back(
        {"edges.million.second", "Medges/s", "millions of edges looked at in a second of the pass silhouettes", 2});
    made.push_back({"frames.second", "frames/s", "by the median frame", 1});
    made.push_back({"cold.ms", "cold ms", "set-up and the first frame", 0});
    if (!tracer) return made;
    made.insert(
        made.end(),
        {{"bvh.build.ms", "BVH build", "the tracer's hierarchy made anew, no part of its frame; median, ms", 2},
         {"bvh.refit.ms", "BVH refit", "the same of one made for the first frame and fitted to this one; ms", 2},
         {"shadows.ratio", "shadows/tracer's", "this row's shadows for each of the tracer's", 2},
         {"frame.ratio", "frame/tracer's", "this row's frame for each of the tracer's, hierarchy not counted", 2}});
    return made;
}

BenchCell cell(const std::optional<double>& number) {
    return number ? BenchCell(*number) : BenchCell();
}

BenchCell ratio(double value, double to) {
    return to > 0.0 ? BenchCell(value / to) : BenchCell();
}

/// @param columnCount  beyond the last number that there is, cells are empty
std::vector<BenchCell> rowOf(const Race& race, const Race::Pair& pair, std::size_t columnCount) {
    const Contender& contender = *pair.shadowed;
    const double frame = median(contender.milliseconds());
    const auto interval = medianInterval(contender.milliseconds());
    std::vector<BenchCell> row{contender.scene().sequence.name, contender.name(), frame};
    row.push_back(interval ? BenchCell(interval->first) : BenchCell());
    row.push_back(interval ? BenchCell(interval->second) : BenchCell());
    row.insert(row.end(), {median(pair.bare->milliseconds()), pair.shadowsMilliseconds()});
    for (const Counter pass : kPasses) row.push_back(cell(contender.pass(pass)));
    const std::optional<double> silhouettes = contender.pass("time.silhouettes"), edges = contender.edges();
    row.push_back(edges && silhouettes ? ratio(1e-3 * *edges, *silhouettes) : BenchCell());
    row.insert(row.end(), {1000.0 / frame, contender.coldMilliseconds()});
    row.insert(row.end(), {cell(contender.buildMilliseconds()), cell(contender.refitMilliseconds())});
    if (race.tracer) {
        row.push_back(ratio(pair.shadowsMilliseconds(), race.tracer->shadowsMilliseconds()));
        row.push_back(ratio(frame, median(race.tracer->shadowed->milliseconds())));
    }
    row.resize(columnCount);
    return row;
}

}  // namespace

BenchTable measureTimes(const Bench& bench, const BenchScenes& scenes, const gpu::Context& context,
                        BenchObserver& observer, const std::atomic<bool>& interrupted) {
    const char* clock = context.info().software ? "the wall's clock between two finishes (a software device)"
                                                : "the device's timer queries";
    const auto traced = [&](const BenchScene* scene) { return bench.tracerFor(scene->sequence); };
    BenchTable table{"times", "Times", columns(std::ranges::any_of(scenes, traced)), {}, {}};
    table.remarks.push_back(fmt::format("{} rounds; passes by {}, frames by the wall's clock.", bench.rounds, clock));
    const Races::Wishes wishes{.passes = true, .offsets = {}, .shadowMaps = {}, .tracer = true};
    Races races(bench, scenes, wishes, "times", context, observer);
    if (!races.run(table.remarks, interrupted)) return table;
    for (const Race& race : races.all()) {
        for (const Race::Pair& pair : race.rows) table.rows.push_back(rowOf(race, pair, table.columns.size()));
    }
    return table;
}

}  // namespace umbrage
