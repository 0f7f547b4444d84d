// SPDX-License-Identifier: Apache-2.0
// Silhouette techniques on a scene of the size of Brabec and Seidel's Figure 4 (a), with 1, 3 and 12 lights.
//  - Sweep: finding silhouettes, from the lights to what is drawn; techniques that find them while they draw have only
//    part of their work here.
//  - Frame: whole frames to pixels on the host, which is what compares all techniques.
#include <benchmark/benchmark.h>

#include <filesystem>

#include "frame/frame.h"
#include "gpu/context.h"
#include "job/names.h"
#include "scene/compose.h"
#include "shadow/bounds.h"
#include "shadow/silhouette.h"

namespace umbrage {
namespace {

constexpr int kSize = 512;  // theirs

const gpu::Context& context() {
    static const gpu::Context instance;
    return instance;
}

/// configs/figures/brabec-seidel-lights.yaml, with the first of its lights.
struct Bench {
    explicit Bench(std::size_t lights)
        : composition(compose(
              readJob(std::filesystem::path(UMBRAGE_SOURCE_DIR) / "configs/figures/brabec-seidel-lights.yaml"))),
          moment(evaluate(composition.scene, composition.animations, 0.0)),
          camera(placeCamera(composition.scene, moment, composition.cameraNode)) {
        moment.lights.resize(lights);
    }

    Composition composition;
    Moment moment;
    PlacedCamera camera;
};

void sweep(benchmark::State& state, const std::string& name) {
    context();
    const Bench bench(std::size_t(state.range(0)));
    const Eye eye = makeEye(bench.camera, kSize, kSize);
    Geometry geometry(bench.composition.scene, bench.moment);
    geometry.update(bench.composition.scene, bench.moment, eye);
    std::vector<ShadowLight> lights;
    for (const PlacedLight& light : bench.moment.lights) lights.emplace_back(light.position, 1.0);
    Silhouettes silhouettes;
    placeLights(geometry, lights, silhouettes);
    silhouettes.hostCasters.resize(geometry.instanceCount());
    silhouettes.casters.reserve("casters", geometry.instanceCount() * sizeof(gpu::CasterState));
    const auto technique = makeSilhouetteTechnique(name);
    const LightGroup group{0, std::uint32_t(lights.size())};
    std::size_t edges = 0;
    for (const gpu::InstanceData& instance : geometry.instances()) edges += instance.edgeCount;
    for (auto _ : state) findSilhouettes(*technique, geometry, group, 0, {}, silhouettes);
    state.counters["edges"] = double(edges);
    state.counters["edges/s"] = benchmark::Counter(double(edges), benchmark::Counter::kIsIterationInvariantRate);
    state.counters["edges*lights/s"] =
        benchmark::Counter(double(edges * lights.size()), benchmark::Counter::kIsIterationInvariantRate);
}

void frame(benchmark::State& state, const std::string& name) {
    const Bench bench(std::size_t(state.range(0)));
    FrameSettings settings;
    settings.width = settings.height = kSize;
    settings.silhouette = name;
    FrameRenderer renderer(bench.composition.scene, bench.moment, settings, context());
    FrameOutputs outputs;
    outputs.radiance = true;
    Statistics statistics;
    const auto render = [&] {
        benchmark::DoNotOptimize(renderer.render(bench.moment, bench.camera, outputs, 1, statistics));
    };
    render();
    for (auto _ : state) render();
    state.counters["frames/s"] = benchmark::Counter(1.0, benchmark::Counter::kIsIterationInvariantRate);
}

}  // namespace
}  // namespace umbrage

int main(int argc, char** argv) {
    for (const umbrage::NameAndMeaning& technique : umbrage::kSilhouettes) {
        const std::string name(technique.name);
        for (const bool whole : {false, true}) {
            benchmark::RegisterBenchmark(
                (whole ? "Frame/" + name : "Sweep/" + name).c_str(),
                [=](benchmark::State& state) { whole ? umbrage::frame(state, name) : umbrage::sweep(state, name); })
                ->ArgName("lights")
                ->Arg(1)
                ->Arg(3)
                ->Arg(12)
                ->Unit(benchmark::kMillisecond)
                ->MeasureProcessCPUTime()  // of all threads of a software device
                ->UseRealTime();
        }
    }
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
}
