// SPDX-License-Identifier: Apache-2.0
// Statistics against the golden's, column by column.
#pragma once

#include <string>
#include <vector>

#include "diagnostics/statistics_file.h"
#include "golden/comparison.h"
#include "job/golden_rules.h"

namespace umbrage {

/// Every column of either file: a counter or a distribution's figure of the whole frame, or of a light, a caster or a
/// material. Counts must be equal and measured numbers are skipped where no tolerance says otherwise. A column passes
/// where every frame does: |output - golden| <= share |golden|, so nothing but 0 is within a share of 0; of the frames
/// the one with the largest share is named. Frames that one file lacks are a column "frames" of their own, and not
/// compared.
///
/// @param tolerances  the last one that matches counts
/// @return  the whole's columns first, in the order of places and names
std::vector<StatisticsResult> compareWithin(const StatisticsFile& golden, const StatisticsFile& output,
                                            const std::vector<StatisticsTolerance>& tolerances);

/// Those that are over, then how many there are of each outcome.
std::string withinTable(const std::vector<StatisticsResult>& results);

}  // namespace umbrage
