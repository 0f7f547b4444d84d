// SPDX-License-Identifier: Apache-2.0
// Budgets for people.
#pragma once

#include <string>
#include <vector>

#include "diagnostics/budgets.h"

namespace umbrage {

/// One that did not hold, in a line: "overdraw.p95 is 7 fragments/pixel in frame 12, 1 (16.7 %) over the budget of 6".
/// @param result  exceeded
std::string budgetText(const BudgetResult& result);

/// A row each, what is over the limit marked; empty without budgets.
std::string budgetTable(const std::vector<BudgetResult>& results);

}  // namespace umbrage
