// SPDX-License-Identifier: Apache-2.0
// A sequence of a bench, loaded.
#pragma once

#include <memory>

#include "bench/bench_file.h"
#include "frame/frame.h"
#include "frame/settings.h"
#include "scene/compose.h"

namespace umbrage {

struct BenchScene {
    /// @throws Error
    BenchScene(const Bench& bench, const BenchSequence& from, bool allowExternalFiles, const gpu::DeviceInfo& device);

    PlacedMoment at(int frame) const { return placedMoment(job, composition, frame); }
    /// Ready for its first frame.
    std::unique_ptr<FrameRenderer> renderer(const FrameSettings& settings, const gpu::Context& context) const;

    const BenchSequence& sequence;
    Job job;  // with what is best on the device where it leaves the technique open
    Composition composition;
    std::vector<int> frames;
};

/// Those a measurement is about.
using BenchScenes = std::vector<const BenchScene*>;

}  // namespace umbrage
