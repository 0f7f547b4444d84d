// SPDX-License-Identifier: Apache-2.0
// Run time against error: what shadows cost by each technique, by shadow maps of several sizes and by the tracer's rays
// with several offsets, and how many samples come out wrong.
#pragma once

#include "bench/bench_run.h"
#include "bench/bench_scene.h"

namespace umbrage {

/// Adds a table and a plot for each sequence.
void measureError(const Bench& bench, const BenchScenes& scenes, const gpu::Context& context, int threads,
                  BenchObserver& observer, const std::atomic<bool>& interrupted, BenchResult& result);

/// Which of some (cost, error) no other is as good as in both and better in one.
std::vector<bool> onFront(const std::vector<std::pair<double, double>>& points);

}  // namespace umbrage
