// SPDX-License-Identifier: Apache-2.0
#include "bench/bench_scene.h"

#include "bench/tracer.h"
#include "error.h"

namespace umbrage {
namespace {

GltfOptions gltfOptions(bool allowExternalFiles) {
    GltfOptions options;
    options.allowExternalFiles = allowExternalFiles;
    return options;
}

}  // namespace

BenchScene::BenchScene(const Bench& bench, const BenchSequence& from, bool allowExternalFiles,
                       const gpu::DeviceInfo& device)
    : sequence(from),
      job(chosenFor(bench.jobOf(from), device)),
      composition(compose(job, gltfOptions(allowExternalFiles))),
      frames(framesOf(job, composition).frames()) {
    if (!bench.tracerFor(from)) return;
    if (job.image.samples != 1) {
        throw Error(ErrorKind::Input, from.file.place.text(), "the tracer traces one sample a pixel",
                    "set: [image.samples=1]");
    }
    makeColorsConstant(composition.scene);
}

std::unique_ptr<FrameRenderer> BenchScene::renderer(const FrameSettings& settings, const gpu::Context& context) const {
    return std::make_unique<FrameRenderer>(composition.scene, at(frames.front()).moment, settings, context);
}

}  // namespace umbrage
