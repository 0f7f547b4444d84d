// SPDX-License-Identifier: Apache-2.0
// Budgets and their results in JSON, as every file has them that says whether they held.
#pragma once

#include <nlohmann/json.hpp>

#include "diagnostics/budgets.h"
#include "diagnostics/json_node.h"

namespace umbrage {

/// All but the unit, which a file may have elsewhere.
nlohmann::ordered_json budgetJson(const BudgetResult& result);

/// @return  what budgetJson() wrote, without a unit
/// @throws Error(Input) with the JSON pointer of what is not as budgetJson() writes it
BudgetResult readBudget(const JsonNode& node);

/// The JSON Schema of budgetJson().
nlohmann::ordered_json budgetSchema();

}  // namespace umbrage
