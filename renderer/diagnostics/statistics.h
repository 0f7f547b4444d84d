// SPDX-License-Identifier: Apache-2.0
// The numbers of a run, per frame and light, and their two forms: CSV for tables, JSON for programs. Whoever has a file
// name writes the text with writeWhole().
#pragma once

#include <compare>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "diagnostics/counters.h"

namespace umbrage {

using StatisticsHeader = std::vector<std::pair<std::string, std::string>>;  // sequence, device, version ...

/// The order of csv() and json() is that of frame, light and kCounters, whatever the order of recording.
/// Not thread-safe.
class Statistics {
public:
    /// @param light  the light's id; empty: the value is the frame's
    /// @param value  finite, in the counter's unit; replaces one recorded before
    void record(int frame, std::string_view light, Counter counter, double value);

    /// Lines end in \n; the first is frame,light,counter,unit,value. Fields are quoted as RFC 4180 has it.
    std::string csv() const;

    /// {header..., "counters": {name: {unit, doc}}, "frames": [{"frame", "values": {name: value},
    /// "lights": {light: {name: value}}}]}
    std::string json(const StatisticsHeader& header) const;

private:
    struct Key {
        int frame;
        std::string light;
        std::size_t counter;

        auto operator<=>(const Key&) const = default;
    };

    std::map<Key, double> values_;
};

/// The largest resident memory this process has had, for the counter memory.peak.
double peakHostMemoryMebibytes();

}  // namespace umbrage
