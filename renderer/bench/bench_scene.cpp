// SPDX-License-Identifier: Apache-2.0
#include "bench/bench_scene.h"

namespace umbrage {
namespace {

GltfOptions gltfOptions(bool allowExternalFiles) {
    GltfOptions options;
    options.allowExternalFiles = allowExternalFiles;
    return options;
}

}  // namespace

BenchScene::BenchScene(const Bench& bench, const BenchSequence& from, bool allowExternalFiles)
    : sequence(from),
      job(bench.jobOf(from)),
      composition(compose(job, gltfOptions(allowExternalFiles))),
      frames(framesOf(job, composition).frames()) {}

std::unique_ptr<FrameRenderer> BenchScene::renderer(const FrameSettings& settings, const gpu::Context& context) const {
    return std::make_unique<FrameRenderer>(composition.scene, at(frames.front()).moment, settings, context);
}

}  // namespace umbrage
