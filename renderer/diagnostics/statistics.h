// SPDX-License-Identifier: Apache-2.0
// Where a run's numbers are recorded. What they become is statistics_file.h's.
#pragma once

#include "diagnostics/counters.h"
#include "diagnostics/quantities.h"
#include "diagnostics/statistics_file.h"

namespace umbrage {

/// The order of recording changes nothing. Not thread-safe.
class Statistics {
public:
    /// @param value  finite, in the counter's unit; replaces one recorded before
    void record(int frame, const StatisticsPlace& place, Counter counter, double value);

    /// @param distribution  replaces one recorded before
    void record(int frame, const StatisticsPlace& place, Quantity quantity, const Distribution& distribution);

    /// A frame's numbers are those of an earlier one.
    void repeat(int frame, int earlier);

    /// @param header  sequence, version, device, clock
    StatisticsFile file(std::vector<std::pair<std::string, std::string>> header) const;

private:
    std::map<int, FrameFigures> frames_;
};

/// The largest resident memory this process has had, for the counter memory.peak.
double peakHostMemoryMebibytes();

}  // namespace umbrage
