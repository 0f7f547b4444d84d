// SPDX-License-Identifier: Apache-2.0
// Several statistics files as one, and parts of one.
#pragma once

#include <functional>

#include "diagnostics/statistics_file.h"

namespace umbrage {

struct NamedStatistics {
    std::string name;  // for messages
    StatisticsFile file;
};

/// Shards of one sequence put together. The head is the first one's; where others say something else, so does the
/// result.
///
/// @param files  at least one
/// @throws Error(Input) where they are of different sequences, explain a name differently, or have different numbers
/// for one place
StatisticsFile mergedStatistics(const std::vector<NamedStatistics>& files);

/// What to keep; an empty function keeps all.
struct StatisticsSelection {
    std::function<bool(int frame)> frame{};
    std::function<bool(const std::string& id)> light{};   // where given, only numbers of a light are kept
    std::function<bool(const std::string& name)> name{};  // of counters and quantities
};

/// Budgets are judged by the frames that are kept.
StatisticsFile selectedStatistics(const StatisticsFile& file, const StatisticsSelection& selection);

}  // namespace umbrage
