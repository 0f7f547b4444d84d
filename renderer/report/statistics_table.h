// SPDX-License-Identifier: Apache-2.0
// Statistics files as tables for people.
#pragma once

#include <string>

#include "diagnostics/statistics_file.h"

namespace umbrage {

/// A number as people read it: digits in groups of three, fractions to about four digits.
std::string readableNumber(double value);

/// Budgets, the whole sequence in groups, then each light, then the casters with most fill.
std::string statisticsTable(const StatisticsFile& file);

}  // namespace umbrage
