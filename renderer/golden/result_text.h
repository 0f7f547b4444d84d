// SPDX-License-Identifier: Apache-2.0
// Words and order that several forms of the report share.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "golden/comparison.h"

namespace umbrage {

/// Of a budget: fail or pass.
Outcome outcomeOf(const BudgetResult& budget);

/// "max" or "min", which tells two limits of one figure apart.
std::string boundName(const BudgetResult& budget);

/// Images, statistics and budgets by outcome, in the order of kOutcomes.
std::array<std::size_t, kOutcomes.size()> countsOf(const Comparison& comparison);

/// "1 fail, 191 pass", or "nothing was compared".
std::string countsText(const Comparison& comparison);

/// What decided: "RULE: METRIC 0.31 is over 0.1", or "... within ..."; empty where nothing was measured.
std::string decisionText(const ImageResult& image);

/// The reason and what decided, as one line; the outcome's meaning where there is neither.
std::string explanation(const ImageResult& image);
std::string explanation(const StatisticsResult& statistics);
std::string explanation(const BudgetResult& budget);

/// Metrics that some image has, in the order of their first appearance.
std::vector<std::string> metricsIn(const Comparison& comparison);

/// A number for people and tables: six significant digits.
std::string shownNumber(double value);

/// Whether a smaller value is the worse one, as of PSNR: what a limit then is the least of.
bool isWorseBelow(const std::string& metric);

}  // namespace umbrage
