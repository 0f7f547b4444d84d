// SPDX-License-Identifier: Apache-2.0
// How a frame's cost grows with one value of a sequence: by each technique and by the tracer.
#pragma once

#include "bench/bench_run.h"

namespace umbrage {

/// Adds two tables (costs, and how they grow) and two plots for each growth of the bench; nothing where it has none.
void measureGrowth(const Bench& bench, bool allowExternalFiles, const gpu::Context& context, BenchObserver& observer,
                   const std::atomic<bool>& interrupted, BenchResult& result);

/// The exponent e of cost ~ x^e, by least squares of the logarithms over the upper half (of the logarithm) of x: what
/// holds for large ones, where fixed costs no longer count. None for fewer than two such points.
/// @param points  (x, cost); those not above zero are left out
std::optional<double> growthExponent(const std::vector<std::pair<double, double>>& points);

}  // namespace umbrage
