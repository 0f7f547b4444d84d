// SPDX-License-Identifier: Apache-2.0
#include "diagnostics/statistics.h"

#include <sys/resource.h>

#include <cassert>
#include <cmath>

namespace umbrage {

void Statistics::record(int frame, const StatisticsPlace& place, Counter counter, double value) {
    assert(std::isfinite(value));
    frames_[frame][place].values[counter.index()] = value;
}

void Statistics::record(int frame, const StatisticsPlace& place, Quantity quantity, const Distribution& distribution) {
    frames_[frame][place].distributions[quantity.index()] = distribution;
}

void Statistics::repeat(int frame, int earlier) {
    const auto found = frames_.find(earlier);
    if (found != frames_.end()) frames_[frame] = found->second;
}

StatisticsFile Statistics::file(std::vector<std::pair<std::string, std::string>> header) const {
    StatisticsFile file;
    file.header = std::move(header);
    const auto text = [](std::string_view view) { return std::string(view); };
    for (std::size_t i = 0; i < kCounters.size(); ++i) {
        const CounterInfo& row = kCounters[i];
        file.counters.push_back({text(row.name), text(groupOf(i).name), text(row.unit), text(row.doc), row.combine,
                                 text(row.numerator), text(row.denominator)});
    }
    for (const QuantityInfo& row : kQuantities) {
        file.quantities.push_back({text(row.name), text(row.unit), text(row.doc), text(row.aov)});
    }
    file.frames = frames_;
    return file;
}

double peakHostMemoryMebibytes() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1024.0;  // Linux counts in KiB
}

}  // namespace umbrage
