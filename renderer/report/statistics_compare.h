// SPDX-License-Identifier: Apache-2.0
// Two runs of a sequence: what changed, and whether it is more than noise.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "diagnostics/statistics_file.h"

namespace umbrage {

/// What a counter or a distribution's figure is in both runs, over the frames that both have.
struct StatisticsChange {
    StatisticsPlace place;  // the whole, a light, a caster or a material
    std::string name, unit;
    double before = 0.0, after = 0.0;  // sums where values add up, else means or largest values; times: means
    std::size_t frames = 0, framesThatDiffer = 0;

    /// Of times, whose noise hides small changes: the median of the frames' ratios, and the interval that holds it with
    /// 95 %. Counts have no noise: any difference is one.
    bool isMeasured = false;
    double ratio = 1.0;  // after / before; of times the median; NaN where `before` is 0
    std::optional<std::pair<double, double>> interval{};  // not with fewer than six frames

    bool isSignificant() const {
        return isMeasured ? interval && (interval->first > 1.0 || interval->second < 1.0) : framesThatDiffer > 0;
    }
};

/// The median's 95 % interval from the sign test: two order statistics of the values, whatever their distribution is.
/// @param values  in any order; with fewer than six there is none
std::optional<std::pair<double, double>> medianInterval(std::vector<double> values);

/// Each frame's numbers by place and name, parts combined to wholes; of distributions their figures. Without parts of
/// parts.
using NamedFrames = std::map<int, std::map<StatisticsPlace, std::map<std::string, double>>>;
NamedFrames namedFrames(const StatisticsFile& file);

/// The light, caster or material; empty for the whole.
std::string placeText(const StatisticsPlace& place);

struct StatisticsComparison {
    std::vector<StatisticsChange> changes;
    std::vector<std::string> onlyBefore, onlyAfter;  // lights, casters and materials that the other run does not have
};

StatisticsComparison compareStatistics(const StatisticsFile& before, const StatisticsFile& after);

/// All changes of the whole; of lights, casters and materials only the significant ones. Ends with what was compared.
std::string comparisonTable(const StatisticsFile& before, const StatisticsFile& after);

}  // namespace umbrage
