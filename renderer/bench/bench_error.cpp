// SPDX-License-Identifier: Apache-2.0
#include "bench/bench_error.h"

#include <fmt/format.h>

#include <algorithm>

#include "bench/bench_race.h"
#include "diagnostics/median.h"
#include "judge/judge.h"

namespace umbrage {
namespace {

/// Over frames and lights.
struct Wrong {
    std::uint64_t hard = 0, band = 0, litFacing = 0;

    double perMillion() const { return litFacing > 0 ? 1e6 * double(hard + band) / double(litFacing) : 0.0; }
};

/// Of each row. The exact answers are found once a frame; what the first row, a renderer, sees there decides about
/// holes of alpha masks.
std::vector<Wrong> judged(const Race& race, int subPixelBits, int threads, BenchObserver& observer) {
    const BenchScene& scene = race.rows.front().shadowed->scene();
    Judge judge(scene.composition.scene, scene.job.image.width, scene.job.image.height, toleranceOf(subPixelBits),
                threads);
    std::vector<Wrong> sums(race.rows.size());
    for (const int frame : scene.frames) {
        const PlacedMoment now = scene.at(frame);
        for (std::size_t r = 0; r < race.rows.size(); ++r) {
            Contender& contender = *race.rows[r].shadowed;
            const FramePixels pixels = contender.samples(frame);
            if (r == 0) judge.setFrame(now.moment, now.camera, *contender.renderer(), pixels);
            VerdictPlanes planes;
            for (const LightVerdict& light : judge.judge(pixels, contender.name(), planes).lights) {
                sums[r].hard += light.hard();
                sums[r].band += light.band();
                sums[r].litFacing += light.litFacing;
            }
        }
        observer.advanced(fmt::format("{} frame {}: judged", scene.sequence.name, frame));
    }
    return sums;
}

std::vector<BenchColumn> columns() {
    return {
        {"sequence", "sequence", "", -1},
        {"technique", "technique",
         "silhouettes:count, or a shadow map and its size, or the tracer and where its shadow rays begin", -1},
        {"shadows.ms", "shadows", "what a frame takes longer than without; difference of medians, ms", 2},
        {"frame.ms", "frame ms", "a frame; median", 2},
        {"wrong.million", "wrong ppm", "samples whose shadow is wrong, of each million that are turned to a light", 2},
        {"hard", "hard", "of them those that rounding does not explain, all frames and lights", 0},
        {"band", "band", "of them those that rounding explains", 0},
        {"lit", "turned to a light", "samples, all frames and lights", 0},
        {"front", "front", "yes: no other is as fast and as right, and better in one", -1}};
}

}  // namespace

std::vector<bool> onFront(const std::vector<std::pair<double, double>>& points) {
    std::vector<bool> front;
    for (const auto& point : points) {
        front.push_back(std::ranges::none_of(points, [&](const auto& other) {
            return other.first <= point.first && other.second <= point.second && other != point;
        }));
    }
    return front;
}

void measureError(const Bench& bench, const BenchScenes& scenes, const gpu::Context& context, int threads,
                  BenchObserver& observer, const std::atomic<bool>& interrupted, BenchResult& result) {
    BenchTable& table = result.tables.emplace_back(BenchTable{"error", "Run time against error", columns(), {}, {}});
    table.remarks.push_back(fmt::format(
        "{} rounds, frames by the wall's clock; samples judged by the exact answer at all frames.", bench.rounds));
    const Races::Wishes wishes{
        .passes = false, .offsets = bench.offsets, .shadowMaps = bench.shadowMaps, .tracer = true};
    Races races(bench, scenes, wishes, "times", context, observer);
    if (!races.run(table.remarks, interrupted)) return;
    std::size_t frames = 0;
    for (const BenchScene* scene : scenes) frames += scene->frames.size();
    observer.started(frames, "errors");
    for (const Race& race : races.all()) {
        if (interrupted) return;
        const std::vector<Wrong> wrong = judged(race, context.subPixelBits(), threads, observer);
        std::vector<std::pair<double, double>> points;
        for (std::size_t r = 0; r < race.rows.size(); ++r) {
            points.emplace_back(race.rows[r].shadowsMilliseconds(), wrong[r].perMillion());
        }
        const std::vector<bool> front = onFront(points);
        const std::string& sequence = race.rows.front().shadowed->scene().sequence.name;
        Plot plot{sequence + ": run time against error",
                  "shadows of a frame (ms)",
                  "wrong of a million samples that are turned to a light",
                  {},
                  PlotScale::Logarithmic};
        PlotSeries line{"Pareto front", {}};
        for (std::size_t r = 0; r < race.rows.size(); ++r) {
            const Contender& contender = *race.rows[r].shadowed;
            table.rows.push_back({sequence, contender.name(), points[r].first, median(contender.milliseconds()),
                                  points[r].second, double(wrong[r].hard), double(wrong[r].band),
                                  double(wrong[r].litFacing), front[r] ? "yes" : ""});
            plot.series.push_back({contender.name(), {points[r]}, true});
            if (front[r]) line.points.push_back(points[r]);
        }
        std::ranges::sort(line.points);
        plot.series.push_back(std::move(line));
        result.plots.emplace_back("error-" + sequence, std::move(plot));
    }
}

}  // namespace umbrage
