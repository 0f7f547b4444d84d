// SPDX-License-Identifier: Apache-2.0
#include "report/budget_table.h"

#include <fmt/format.h>

#include "report/statistics_table.h"
#include "report/text_table.h"

namespace umbrage {
namespace {

std::string limitText(const BudgetResult& result) {
    return fmt::format("at {} {}", result.atLeast ? "least" : "most", readableNumber(result.limit));
}

std::string lightText(const BudgetResult& result) {
    return result.light.empty() ? "" : fmt::format(", light {}", printable(result.light));
}

std::string shareText(const BudgetResult& result) {
    return result.limit > 0.0 ? fmt::format(" ({:.1f} %)", 100.0 * result.excess() / result.limit) : "";
}

std::string verdictText(const BudgetResult& result) {
    if (!result.exceeded) return "held";
    if (!result.value) return "NO VALUE";
    return fmt::format("{} by {}{}", result.atLeast ? "UNDER" : "OVER", readableNumber(result.excess()),
                       shareText(result));
}

}  // namespace

std::string budgetText(const BudgetResult& result) {
    if (!result.value) {
        const std::string where = result.frame ? fmt::format("in frame {}", *result.frame) : "in any frame";
        return fmt::format("{} has no value {}, so nothing says that it is {}", result.name, where, limitText(result));
    }
    const bool isPlain = result.unit == "count" || result.unit == "ratio";
    const std::string unit = isPlain ? "" : fmt::format(" {}", result.unit);
    return fmt::format("{} is {}{} in frame {}{}, {}{} {} the budget of {}", result.name, readableNumber(*result.value),
                       unit, *result.frame, lightText(result), readableNumber(result.excess()), shareText(result),
                       result.atLeast ? "under" : "over", readableNumber(result.limit));
}

std::string budgetTable(const std::vector<BudgetResult>& results) {
    if (results.empty()) return "";
    std::vector<std::vector<std::string>> rows{{"budget", "limit", "worst", "in frame", "", "unit"}};
    for (const BudgetResult& result : results) {
        rows.push_back({fmt::format("  {}{}", result.name, lightText(result)), limitText(result),
                        result.value ? readableNumber(*result.value) : "-",
                        result.frame ? std::to_string(*result.frame) : "-", verdictText(result), result.unit});
    }
    return alignedTable(rows, {true, true, false, false, true, true});
}

}  // namespace umbrage
