// SPDX-License-Identifier: Apache-2.0
// What commands do with budgets that did not hold.
#pragma once

#include <string>
#include <vector>

#include "diagnostics/budgets.h"
#include "exit_codes.h"
#include "report/budget_table.h"
#include "say.h"

namespace umbrage {

/// A line on stderr for each that is exceeded.
/// @param where  in front of them, such as the file's name; may be empty
/// @return  the exit code that they ask for
inline ExitCode sayBudgets(const std::vector<BudgetResult>& results, const std::string& where) {
    for (const BudgetResult& result : results) {
        if (!result.exceeded) continue;
        say("umbrage: over budget: {}{}{}\n", where, where.empty() ? "" : ": ", budgetText(result));
    }
    return anyExceeded(results) ? kFramesFailed : kOk;
}

}  // namespace umbrage
