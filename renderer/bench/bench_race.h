// SPDX-License-Identifier: Apache-2.0
// Contenders, timed in turn.
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bench/bench_contender.h"
#include "bench/bench_run.h"

namespace umbrage {

/// What is compared on one sequence.
struct Race {
    /// With shadows, and the same without.
    struct Pair {
        Contender* shadowed;
        const Contender* bare;

        /// Difference of the medians.
        double shadowsMilliseconds() const;
    };
    std::vector<Pair> rows;
    std::optional<Pair> tracer;  // with the first of its offsets; also one of the rows
};

class Races {
public:
    struct Wishes {
        bool passes = false;          // times them, too
        std::vector<double> offsets;  // of the tracer; none: its own
        std::vector<int> shadowMaps;  // sizes, each with a bias and without
        bool tracer = true;           // where the bench has it
    };
    /// @param what  is measured, for the observer
    Races(const Bench& bench, const BenchScenes& scenes, const Wishes& wishes, const char* what,
          const gpu::Context& context, BenchObserver& observer);

    /// Sets everything up; each contender's first frame and first round are apart: set-up and warm-up. Then all frames
    /// of all contenders, Bench::rounds times, in turn; every other round the other way round.
    /// @return whether it came to its end
    bool run(std::vector<std::string>& remarks, const std::atomic<bool>& interrupted);

    /// One a sequence.
    const std::vector<Race>& all() const { return races_; }

private:
    bool traces(const BenchScene& scene) const;
    bool setUp(const BenchScene& scene, const std::atomic<bool>& interrupted);
    Contender* enter(std::unique_ptr<Contender> contender);

    const Bench& bench_;
    const BenchScenes& scenes_;
    Wishes wishes_;
    const char* what_;
    const gpu::Context& context_;
    BenchObserver& observer_;
    std::vector<std::unique_ptr<Contender>> contenders_;
    std::vector<Race> races_;
};

}  // namespace umbrage
