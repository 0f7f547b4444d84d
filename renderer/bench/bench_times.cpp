// SPDX-License-Identifier: Apache-2.0
#include "bench/bench_times.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <set>

#include "diagnostics/counters.h"
#include "diagnostics/median.h"
#include "report/statistics_compare.h"
#include "shading/lights.h"

namespace umbrage {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::array<Counter, 6> kPasses = {"time.position", "time.gbuffer", "time.silhouettes",
                                            "time.counts",   "time.resolve", "time.readback"};

double since(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// One way to render one sequence.
class Contender {
public:
    /// @param technique  null: without shadows
    Contender(const BenchScene& scene, const Technique* technique, const gpu::Context& context)
        : scene_(scene), technique_(technique ? technique->name() : "without shadows") {
        FrameSettings settings = settingsOf(scene.job, scene.composition);
        settings.shadows = technique != nullptr;
        settings.profile = false;
        if (technique) choose(*technique, settings);
        const Clock::time_point start = Clock::now();
        plain_ = scene.renderer(settings, context);
        render(*plain_, scene.frames.front());
        coldMilliseconds_ = since(start);
        if (!technique) return;
        settings.profile = true;  // passes are waited for, so the frame's own time is measured without
        profiled_ = scene.renderer(settings, context);
    }

    /// Why lights were not counted as its technique does, each once; empties itself.
    std::set<std::string> takeNotes() { return std::exchange(notes_, {}); }

    void run(bool counted) {
        for (const int frame : scene_.frames) {
            const Clock::time_point start = Clock::now();
            render(*plain_, frame);
            const double whole = since(start);
            if (counted) milliseconds_.push_back(whole);
            if (!profiled_) continue;
            for (const auto& [pass, time] : render(*profiled_, frame).milliseconds) {
                if (counted) passes_[pass].push_back(time);
            }
        }
    }

    const BenchScene& scene() const { return scene_; }
    const std::string& technique() const { return technique_; }
    const std::vector<double>& milliseconds() const { return milliseconds_; }
    double coldMilliseconds() const { return coldMilliseconds_; }
    std::optional<double> pass(Counter counter) const {
        const auto found = passes_.find(counter.index());
        return found == passes_.end() ? std::nullopt : std::optional(median(found->second));
    }
    /// Edges looked at, for all lights that are on in the first frame.
    double edges() const {
        const Moment moment = scene_.at(scene_.frames.front()).moment;
        const auto lights = std::ranges::count_if(moment.lights, [](const auto& l) { return isOn(l.light); });
        double edges = 0.0;
        for (const gpu::InstanceData& instance : plain_->geometry().instances()) edges += instance.edgeCount;
        return edges * double(lights);
    }

private:
    FramePixels render(FrameRenderer& renderer, int frame) {
        Statistics unused;
        const PlacedMoment now = scene_.at(frame);
        FramePixels pixels = renderer.render(now.moment, now.camera, {}, frame, unused);
        notes_.insert(pixels.notes.begin(), pixels.notes.end());
        return pixels;
    }

    const BenchScene& scene_;
    std::string technique_;
    std::unique_ptr<FrameRenderer> plain_, profiled_;
    double coldMilliseconds_ = 0.0;
    std::vector<double> milliseconds_;
    std::map<std::size_t, std::vector<double>> passes_;
    std::set<std::string> notes_;
};

std::vector<BenchColumn> columns() {
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
    return made;
}

std::vector<BenchCell> rowOf(const Contender& contender, const Contender& unshadowed) {
    const double frame = median(contender.milliseconds()), bare = median(unshadowed.milliseconds());
    const auto interval = medianInterval(contender.milliseconds());
    std::vector<BenchCell> row{contender.scene().sequence.name, contender.technique(), frame};
    row.push_back(interval ? BenchCell(interval->first) : BenchCell());
    row.push_back(interval ? BenchCell(interval->second) : BenchCell());
    row.insert(row.end(), {bare, frame - bare});
    for (const Counter pass : kPasses) {
        const std::optional<double> time = contender.pass(pass);
        row.push_back(time ? BenchCell(*time) : BenchCell());
    }
    const std::optional<double> silhouettes = contender.pass("time.silhouettes");
    row.push_back(silhouettes && *silhouettes > 0.0 ? BenchCell(1e-3 * contender.edges() / *silhouettes) : BenchCell());
    row.insert(row.end(), {1000.0 / frame, contender.coldMilliseconds()});
    return row;
}

}  // namespace

BenchTable measureTimes(const Bench& bench, const BenchScenes& scenes, const gpu::Context& context,
                        BenchObserver& observer, const std::atomic<bool>& interrupted) {
    const char* clock = context.info().software ? "the wall's clock between two finishes (a software device)"
                                                : "the device's timer queries";
    BenchTable table{"times", "Times", columns(), {}, {}};
    table.remarks.push_back(fmt::format("{} rounds; passes by {}, frames by the wall's clock.", bench.rounds, clock));
    // Of each sequence the unshadowed one comes first.
    std::vector<std::unique_ptr<Contender>> contenders;
    std::vector<std::pair<const Contender*, const Contender*>> rows;
    const std::size_t count = scenes.size() * (1 + std::max<std::size_t>(1, bench.techniques.size()));
    observer.started(count * std::size_t(bench.rounds + 2), "times");
    for (const BenchScene* each : scenes) {
        const BenchScene& scene = *each;
        std::vector<Technique> techniques = bench.techniques;
        if (techniques.empty()) techniques = {techniqueOf(scene.job)};
        const auto enter = [&](const Technique* technique) {
            contenders.push_back(std::make_unique<Contender>(scene, technique, context));
            observer.advanced(fmt::format("{} {}: set up", scene.sequence.name, contenders.back()->technique()));
            return contenders.back().get();
        };
        const Contender* bare = enter(nullptr);
        for (const Technique& technique : techniques) {
            if (interrupted) return table;
            rows.emplace_back(enter(&technique), bare);
        }
    }
    for (int round = 0; round <= bench.rounds; ++round) {
        for (const auto& contender : contenders) {
            if (interrupted) return table;
            contender->run(round > 0);
            const std::string who = contender->scene().sequence.name + " " + contender->technique();
            if (round == 0) {
                for (const std::string& note : contender->takeNotes()) {
                    table.remarks.push_back(fmt::format("{}: {}.", who, note));
                }
            }
            observer.advanced(fmt::format("{}: round {}", who, round));
        }
        std::reverse(contenders.begin(), contenders.end());
    }
    for (const auto& [contender, bare] : rows) table.rows.push_back(rowOf(*contender, *bare));
    return table;
}

}  // namespace umbrage
