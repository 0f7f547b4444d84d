// SPDX-License-Identifier: Apache-2.0
#include "bench/bench_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <thread>

#include "bench/bench_antialiasing.h"
#include "bench/bench_error.h"
#include "bench/bench_growth.h"
#include "bench/bench_pictures.h"
#include "bench/bench_scene.h"
#include "bench/bench_tiles.h"
#include "bench/bench_times.h"
#include "error.h"

namespace umbrage {
namespace {

using SceneByName = std::map<std::string, std::unique_ptr<BenchScene>>;

BenchScenes measured(const Bench& bench, const SceneByName& scenes, const char* measurement) {
    BenchScenes wanted;
    for (const BenchSequence& sequence : bench.sequences) {
        const std::vector<std::string>& measure = bench.measureOf(sequence);
        if (std::ranges::find(measure, measurement) != measure.end()) {
            wanted.push_back(scenes.at(sequence.name).get());
        }
    }
    return wanted;
}

/// @throws Error(Input) where panels do not fit side by side
void checkSizes(const BenchPicture& picture, const SceneByName& scenes) {
    const auto sizeOf = [&](const BenchPicture::Panel& panel) {
        const Job::ImageSettings& image = scenes.at(panel.sequence.value)->job.image;
        return std::pair(image.width, image.height);
    };
    for (const BenchPicture::Panel& panel : picture.panels) {
        if (sizeOf(panel) == sizeOf(picture.panels.front())) continue;
        throw Error(ErrorKind::Input, panel.sequence.place.text(), "this panel has another size than the first",
                    "give the bench a size: [WIDTH, HEIGHT]");
    }
}

/// Pictures and curves.
void draw(const Bench& bench, const SceneByName& scenes, const gpu::Context& context, int threads,
          BenchObserver& observer, const std::atomic<bool>& interrupted, BenchResult& result) {
    if (bench.pictures.empty() && bench.curves.empty()) return;
    observer.started(bench.pictures.size() + bench.curves.size(), "pictures");
    std::map<std::string, std::unique_ptr<TileBench>> benches;
    const auto benchOf = [&](const std::string& name) -> TileBench& {
        std::unique_ptr<TileBench>& made = benches[name];
        if (!made) made = std::make_unique<TileBench>(*scenes.at(name), context, threads);
        return *made;
    };
    for (const BenchPicture& picture : bench.pictures) {
        if (interrupted) return;
        checkSizes(picture, scenes);
        std::vector<ProcessedPanel> panels;
        for (const BenchPicture::Panel& panel : picture.panels) {
            panels.push_back(
                processedPanel(benchOf(panel.sequence.value), panel.method, panel.frame.value_or(picture.frame)));
        }
        const Job& job = scenes.at(picture.panels.front().sequence.value)->job;
        const auto display =
            codec().displayTransform({job.color.config, job.color.display, job.color.view, job.color.exposureStops});
        result.pictures.emplace_back(picture.name, drawProcessed(panels, *display));
        observer.advanced(fmt::format("picture {}", picture.name));
    }
    for (const BenchCurve& curve : bench.curves) {
        if (interrupted) return;
        result.plots.emplace_back(curve.name, updateCurve(benchOf(curve.sequence.value), curve));
        observer.advanced(fmt::format("curve {}", curve.name));
    }
}

}  // namespace

BenchResult runBench(const Bench& bench, const gpu::Context& context, bool allowExternalFiles, BenchObserver& observer,
                     const std::atomic<bool>& interrupted) {
    const int threads = std::max(1, int(std::thread::hardware_concurrency()));
    SceneByName scenes;
    for (const BenchSequence& sequence : bench.sequences) {
        std::unique_ptr<BenchScene>& scene = scenes[sequence.name];
        scene = std::make_unique<BenchScene>(bench, sequence, allowExternalFiles, context.info());
        for (const std::string& note : scene->composition.scene.notes) observer.note(sequence.name + ": " + note);
    }
    BenchResult result;
    if (const BenchScenes of = measured(bench, scenes, "times"); !of.empty()) {
        result.tables.push_back(measureTimes(bench, of, context, observer, interrupted));
    }
    if (const BenchScenes of = measured(bench, scenes, "error"); !of.empty()) {
        measureError(bench, of, context, threads, observer, interrupted, result);
    }
    if (const BenchScenes of = measured(bench, scenes, "antialiasing"); !of.empty()) {
        measureAntialiasing(bench, of, context, observer, interrupted, result);
    }
    if (const BenchScenes of = measured(bench, scenes, "tiles"); !of.empty()) {
        measureTiles(of, context, threads, observer, interrupted, result);
    }
    measureGrowth(bench, allowExternalFiles, context, observer, interrupted, result);
    draw(bench, scenes, context, threads, observer, interrupted, result);
    return result;
}

}  // namespace umbrage
