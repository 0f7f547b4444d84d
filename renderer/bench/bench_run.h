// SPDX-License-Identifier: Apache-2.0
// Runs a bench: everything is rendered in this one process, what is compared in turn, so that a machine that slows down
// slows down all of it.
#pragma once

#include <atomic>
#include <string>
#include <utility>
#include <vector>

#include "bench/bench_file.h"
#include "bench/bench_table.h"
#include "gpu/context.h"
#include "image/canvas.h"
#include "image/image.h"
#include "report/plot.h"

namespace umbrage {

class BenchObserver {
public:
    virtual ~BenchObserver() = default;
    virtual void note(const std::string& text) = 0;
    virtual void started(std::size_t stepCount, const std::string& what) = 0;
    virtual void advanced(const std::string& step) = 0;
};

/// Files are named by their first halves.
struct BenchResult {
    std::vector<BenchTable> tables;  // one a measurement
    std::vector<std::pair<std::string, Plot>> plots;
    std::vector<std::pair<std::string, RgbPicture>> pictures;
    std::vector<std::string> wrong;  // what must be alike and is not
};

/// @return  what there is, when interrupted
/// @throws Error
BenchResult runBench(const Bench& bench, const gpu::Context& context, bool allowExternalFiles, BenchObserver& observer,
                     const std::atomic<bool>& interrupted);

}  // namespace umbrage
