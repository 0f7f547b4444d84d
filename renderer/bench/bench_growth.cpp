// SPDX-License-Identifier: Apache-2.0
#include "bench/bench_growth.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bench/bench_race.h"
#include "diagnostics/median.h"

namespace umbrage {
namespace {

std::vector<BenchColumn> columns() {
    return {{"growth", "growth", "", -1},
            {"technique", "technique", "", -1},
            {"value", "value", "what the sequence was set to", -1},
            {"x", "x", "what is on the axis", 1},
            {"frame.ms", "frame ms", "a frame; median", 2},
            {"unshadowed.ms", "no shadows", "the same frames without shadows; median, ms", 2},
            {"shadows.ms", "shadows", "the difference, ms", 2}};
}

std::vector<BenchColumn> summaryColumns() {
    return {{"growth", "growth", "", -1},
            {"technique", "technique", "", -1},
            {"x.low", "from x", "least on the axis", 1},
            {"x.high", "to x", "greatest that the technique was asked for", 1},
            {"frame.times", "frame, times", "cost of the last frame for each of the first", 2},
            {"shadows.times", "shadows, times", "the same of what shadows cost", 2},
            {"frame.exponent", "frame ~ x^", "exponent over the upper half of x (of its logarithm)", 2},
            {"shadows.exponent", "shadows ~ x^", "the same of what shadows cost", 2}};
}

BenchCell cell(const std::optional<double>& number) {
    return number ? BenchCell(*number) : BenchCell();
}

/// Cost against x, of one technique.
using Curve = std::vector<std::pair<double, double>>;

struct Curves {
    std::string technique;
    Curve frames, shadows;
};

Curves& curvesOf(std::vector<Curves>& all, const std::string& technique) {
    const auto found = std::ranges::find(all, technique, &Curves::technique);
    return found != all.end() ? *found : all.emplace_back(Curves{technique, {}, {}});
}

/// The frame's own, or that of all its lights together.
double counted(const BenchScene& scene, const std::string& counter, const gpu::Context& context) {
    FrameSettings settings = settingsOf(scene.job, scene.composition);
    settings.count = "z-pass";
    const int frame = scene.frames.front();
    const PlacedMoment now = scene.at(frame);
    FrameOutputs outputs;
    outputs.radiance = false;
    outputs.figures = outputs.counts = outputs.overdraw = true;
    Statistics statistics;
    scene.renderer(settings, context)->render(now.moment, now.camera, outputs, frame, statistics);
    const auto index = std::size_t(std::ranges::find(kCounters, counter, &CounterInfo::name) - kCounters.begin());
    const FrameFigures figures = statistics.file({}).frames.at(frame);
    double sum = 0.0;
    for (const auto& [place, numbers] : figures) {
        const auto found = numbers.values.find(index);
        if (found == numbers.values.end() || !place.caster.empty() || !place.material.empty()) continue;
        if (place.light.empty()) return found->second;
        sum += found->second;
    }
    return sum;
}

/// One growth, value by value.
class Growing {
public:
    Growing(const Bench& bench, const BenchGrowth& growth, const gpu::Context& context, BenchTable& table)
        : bench_(bench), growth_(growth), context_(context), table_(table) {
        for (const BenchSequence& sequence : bench.sequences) {
            if (sequence.name == growth.sequence.value) sequence_ = sequence;
        }
        if (!bench_.techniques.empty()) return;
        bench_.techniques = {{techniqueOf(chosenFor(bench.jobOf(sequence_), context.info()))}};
    }

    /// @return whether anybody is left to be asked for the next value
    bool measure(const std::vector<double>& value, bool allowExternalFiles, BenchObserver& observer,
                 const std::atomic<bool>& interrupted) {
        BenchSequence sequence = sequence_;
        sequence.name = fmt::format("{} {}", growth_.name, BenchGrowth::text(value));
        sequence.set.push_back(growth_.assignment(value));
        const BenchScene scene(bench_, sequence, allowExternalFiles, context_.info());
        const BenchScenes scenes{&scene};
        Races races(bench_, scenes, {.passes = false, .offsets = {}, .shadowMaps = {}, .tracer = tracer_}, "growth",
                    context_, observer);
        std::vector<std::string> remarks;
        if (!races.run(remarks, interrupted)) return false;
        if (table_.remarks.size() < 2) table_.remarks.insert(table_.remarks.end(), remarks.begin(), remarks.end());
        const double x = growth_.by.empty() ? value.front() : counted(scene, growth_.by, context_);
        enter(races.all().front(), BenchGrowth::text(value), x);
        return !bench_.techniques.empty();
    }

    void summarise(BenchTable& summary) const {
        for (const Curves& of : curves_) {
            const auto times = [](const Curve& curve) {
                return curve.size() > 1 && std::min(curve.front().second, curve.back().second) > 0.0
                           ? BenchCell(curve.back().second / curve.front().second)
                           : BenchCell();
            };
            const auto exponent = [&](const Curve& curve) {
                return growth_.isLinear ? BenchCell() : cell(growthExponent(curve));
            };
            summary.rows.push_back({growth_.name, of.technique, of.frames.front().first, of.frames.back().first,
                                    times(of.frames), times(of.shadows), exponent(of.frames), exponent(of.shadows)});
        }
    }

    void plot(BenchResult& result) const {
        const std::string label = growth_.label.empty() ? growth_.name : growth_.label;
        const PlotScale scale = growth_.isLinear ? PlotScale::Linear : PlotScale::Logarithmic;
        Plot frames{fmt::format("Frames: {}", label), label, "ms", {}, scale};
        Plot shadows{fmt::format("Shadows of a frame: {}", label), label, "ms", {}, scale};
        for (const Curves& of : curves_) {
            frames.series.push_back({of.technique, of.frames});
            if (!of.shadows.empty()) shadows.series.push_back({of.technique, of.shadows});
        }
        result.plots.emplace_back("growth-" + growth_.name, std::move(frames));
        result.plots.emplace_back("growth-" + growth_.name + "-shadows", std::move(shadows));
    }

private:
    void enter(const Race& race, const std::string& value, double x) {
        for (const Race::Pair& pair : race.rows) {
            const std::string& name = pair.shadowed->name();
            const double frame = median(pair.shadowed->milliseconds()), shadows = pair.shadowsMilliseconds();
            table_.rows.push_back({growth_.name, name, value, x, frame, median(pair.bare->milliseconds()), shadows});
            Curves& curves = curvesOf(curves_, name);
            curves.frames.emplace_back(x, frame);
            curves.shadows.emplace_back(x, shadows);
            if (frame > 1e3 * growth_.patienceSeconds) leaveOut(name, value, frame);
        }
        enterBare(*race.rows.front().bare, value, x);
        if (race.tracer) enterBare(*race.tracer->bare, value, x);
    }

    void enterBare(const Contender& bare, const std::string& value, double x) {
        const std::string& name = bare.name();
        const double frame = median(bare.milliseconds());
        table_.rows.push_back({growth_.name, name, value, x, frame, frame, BenchCell()});
        curvesOf(curves_, name).frames.emplace_back(x, frame);
    }

    void leaveOut(const std::string& name, const std::string& value, double frameMilliseconds) {
        if (value != BenchGrowth::text(growth_.values.back())) {
            table_.remarks.push_back(fmt::format("{}: {} took {:.1f} s a frame at {} and was not asked for more.",
                                                 growth_.name, name, 1e-3 * frameMilliseconds, value));
        }
        const auto it = [&](const BenchTechnique& technique) { return technique.name() == name; };
        if (std::erase_if(bench_.techniques, it) == 0) tracer_ = false;
    }

    Bench bench_;  // with those techniques that are still asked
    const BenchGrowth& growth_;
    const gpu::Context& context_;
    BenchTable& table_;
    BenchSequence sequence_;
    bool tracer_ = true;
    std::vector<Curves> curves_;
};

}  // namespace

std::optional<double> growthExponent(const std::vector<std::pair<double, double>>& points) {
    std::vector<std::pair<double, double>> logs;
    for (const auto& [x, cost] : points) {
        if (x > 0.0 && cost > 0.0) logs.emplace_back(std::log(x), std::log(cost));
    }
    if (logs.empty()) return std::nullopt;
    const auto [least, most] = std::ranges::minmax_element(logs);
    const double middle = 0.5 * (least->first + most->first);
    std::erase_if(logs, [&](const auto& point) { return point.first < middle; });
    double x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
    for (const auto& point : logs) x += point.first / double(logs.size()), y += point.second / double(logs.size());
    for (const auto& point : logs) {
        xx += (point.first - x) * (point.first - x);
        xy += (point.first - x) * (point.second - y);
    }
    return xx > 0.0 ? std::optional(xy / xx) : std::nullopt;
}

void measureGrowth(const Bench& bench, bool allowExternalFiles, const gpu::Context& context, BenchObserver& observer,
                   const std::atomic<bool>& interrupted, BenchResult& result) {
    if (bench.growth.empty()) return;
    BenchTable costs{"growth", "Growth", columns(), {}, {}},
        summary{"exponents", "How it grows", summaryColumns(), {}, {}};
    costs.remarks.push_back(fmt::format("{} rounds, frames by the wall's clock.", bench.rounds));
    for (const BenchGrowth& growth : bench.growth) {
        Growing growing(bench, growth, context, costs);
        for (const std::vector<double>& value : growth.values) {
            if (!growing.measure(value, allowExternalFiles, observer, interrupted)) break;
        }
        growing.summarise(summary);
        growing.plot(result);
        if (interrupted) break;
    }
    result.tables.push_back(std::move(costs));
    result.tables.push_back(std::move(summary));
}

}  // namespace umbrage
