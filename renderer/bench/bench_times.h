// SPDX-License-Identifier: Apache-2.0
// How long frames and their passes take, by each technique and without shadows.
#pragma once

#include "bench/bench_run.h"
#include "bench/bench_scene.h"

namespace umbrage {

/// Each contender's first frame and first round are apart: set-up and warm-up. Then all frames of all contenders,
/// `rounds` times, in turn; every other round the other way round.
BenchTable measureTimes(const Bench& bench, const BenchScenes& scenes, const gpu::Context& context,
                        BenchObserver& observer, const std::atomic<bool>& interrupted);

}  // namespace umbrage
