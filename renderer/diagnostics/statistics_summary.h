// SPDX-License-Identifier: Apache-2.0
// A sequence in one table: what its frames add up to.
#pragma once

#include "diagnostics/statistics_file.h"

namespace umbrage {

/// A counter over the frames that have it.
struct CounterSummary {
    double total = 0.0;
    double mean = 0.0;  // of a ratio: that of the totals it is made of
    double max = 0.0;
    int maxFrame = 0;  // the first with that value
};

struct PlaceSummary {
    std::map<std::size_t, CounterSummary> values;
    std::map<std::size_t, Distribution> distributions;  // of all frames' pixels
};

/// The caster's part of the counter below, over all frames and lights.
struct TopCaster {
    std::string caster;
    double value = 0.0;
    double share = 0.0;  // of the whole sequence's
};
inline constexpr const char* kTopCastersCounter = "overdraw.fragments";
inline constexpr std::size_t kMostTopCasters = 10;

struct StatisticsSummary {
    std::size_t frames = 0;
    std::map<StatisticsPlace, PlaceSummary> places;  // the whole, each light, each caster and each material
    std::vector<TopCaster> topCasters;               // the largest first
};

/// The frame's figures, and for each counter that a whole lacks the one its parts combine to: lights where they have
/// it, else casters, else materials.
FrameFigures withWholes(const StatisticsFile& file, const FrameFigures& frame);

StatisticsSummary summaryOf(const StatisticsFile& file);

}  // namespace umbrage
