// SPDX-License-Identifier: Apache-2.0
// What antialiasing costs and brings: several samples a pixel, and the mean of several pictures (frame/accumulate.h),
// against a converged frame.
#pragma once

#include "bench/bench_run.h"
#include "bench/bench_scene.h"

namespace umbrage {

/// Adds a table and a plot for each sequence.
void measureAntialiasing(const Bench& bench, const BenchScenes& scenes, const gpu::Context& context,
                         BenchObserver& observer, const std::atomic<bool>& interrupted, BenchResult& result);

}  // namespace umbrage
