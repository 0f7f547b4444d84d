// SPDX-License-Identifier: Apache-2.0
// What the writer, the reader and the schema of statistics files agree on.
#pragma once

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string_view>

#include "diagnostics/statistics_file.h"

namespace umbrage {

inline constexpr std::string_view kStatisticsFormat = "umbrage statistics 1";

/// What places are told apart by, and the member of a place's JSON object that holds its parts. Parts of a part are
/// those further down: a light's casters.
struct Dimension {
    const char* key;
    std::string StatisticsPlace::*name;
    const char* doc;
};
inline constexpr std::array kDimensions{
    Dimension{"lights", &StatisticsPlace::light, "by the light's id"},
    Dimension{"casters", &StatisticsPlace::caster, "by the node path of the shadow caster"},
    Dimension{"materials", &StatisticsPlace::material, "by the material's name"},
};

inline std::size_t dimensionsOf(const StatisticsPlace& place) {
    std::size_t count = 0;
    for (const Dimension& dimension : kDimensions) count += !(place.*dimension.name).empty();
    return count;
}

/// A distribution in five numbers.
struct DistributionFigure {
    const char* name;
    double (*of)(const Distribution&);
    const char* doc;
};
inline constexpr std::array kDistributionFigures{
    DistributionFigure{"mean", [](const Distribution& d) { return d.mean(); }, "arithmetic mean of all values"},
    DistributionFigure{"p50", [](const Distribution& d) { return d.percentile(50); },
                       "smallest value with at least 50 % of the pixels at or below it"},
    DistributionFigure{"p95", [](const Distribution& d) { return d.percentile(95); }, "the same for 95 %"},
    DistributionFigure{"p99", [](const Distribution& d) { return d.percentile(99); }, "the same for 99 %"},
    DistributionFigure{"max", [](const Distribution& d) { return d.max(); }, "largest value"},
};

/// As CSV, budgets and comparisons call it: overdraw.p95
inline std::string figureName(std::string_view quantity, const DistributionFigure& figure) {
    return std::string(quantity).append(".").append(figure.name);
}

/// Whether numbers of this unit are measured, and so differ from run to run; counts do not.
inline bool isMeasured(std::string_view unit) {
    return unit == "ms" || unit == "MiB" || unit == "ratio";
}

inline constexpr std::array<std::string_view, 3> kCombineNames{"sum", "largest", "mean"};

inline std::string_view nameOf(Combine combine) {
    return kCombineNames[static_cast<std::size_t>(combine)];
}

}  // namespace umbrage
