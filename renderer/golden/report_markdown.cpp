// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "golden/reports.h"
#include "golden/result_text.h"
#include "report/text_table.h"

namespace umbrage {
namespace {

constexpr std::size_t kMostRows = 20;

struct Row {
    Outcome outcome;
    double excess;  // how many times over its limit; infinite where a gate closed
    std::vector<std::string> cells;
};

double excessOf(double value, double limit, bool isLeast) {
    const double ratio = isLeast ? limit / value : value / limit;
    return std::isnan(ratio) ? 0.0 : ratio;
}

double excessOf(const ImageResult& image) {
    if (!image.decision) return INFINITY;
    return excessOf(image.decision->value, image.decision->limit, isWorseBelow(image.decision->metric));
}

double excessOf(const BudgetResult& budget) {
    return budget.value ? excessOf(*budget.value, budget.limit, budget.atLeast) : INFINITY;
}

/// A fenced block that its text cannot end.
std::string codeBlock(const std::string& code) {
    std::string fence = "```";
    while (code.find(fence) != std::string::npos) fence += '`';
    return fmt::format("{0}sh\n{1}\n{0}\n", fence, printable(code));
}

}  // namespace

std::string comparisonMarkdown(const Comparison& comparison) {
    std::string text =
        fmt::format("## Golden frames: {}\n\n{}\n\n", comparison.passes() ? "pass" : "fail", countsText(comparison));
    for (const std::string& note : comparison.notes) text += fmt::format("- {}\n", markdownCell(note));
    if (!comparison.notes.empty()) text += "\n";

    std::vector<Row> rows;
    for (const ImageResult& image : comparison.images) {
        if (infoOf(image.outcome).passes && image.outcome != Outcome::Warn) continue;
        rows.push_back({image.outcome,
                        excessOf(image),
                        {image.name, std::string(infoOf(image.outcome).name), explanation(image)}});
    }
    for (const StatisticsResult& column : comparison.statistics) {
        if (infoOf(column.outcome).passes && column.outcome != Outcome::Warn) continue;
        rows.push_back({column.outcome,
                        std::abs(column.output - column.golden) / std::abs(column.golden * column.tolerance),
                        {column.column, std::string(infoOf(column.outcome).name), explanation(column)}});
    }
    for (const BudgetResult& budget : comparison.budgets) {
        if (!budget.exceeded) continue;
        const Outcome outcome = outcomeOf(budget);
        rows.push_back({outcome,
                        excessOf(budget),
                        {"budget " + budget.name, std::string(infoOf(outcome).name), explanation(budget)}});
    }
    std::stable_sort(rows.begin(), rows.end(), [](const Row& a, const Row& b) {
        const bool aPasses = infoOf(a.outcome).passes, bPasses = infoOf(b.outcome).passes;
        return aPasses != bPasses ? bPasses : a.excess > b.excess;
    });
    if (!rows.empty()) {
        std::vector<std::vector<std::string>> table{{"what", "outcome", "why"}};
        for (const Row& row : rows) {
            if (table.size() <= kMostRows) table.push_back(row.cells);
        }
        text += markdownTable(table, {true, true, true});
        if (rows.size() > kMostRows) text += fmt::format("\nand {} more\n", rows.size() - kMostRows);
        text += "\n";
    }
    if (!comparison.passes()) {
        if (!comparison.renderCommand.empty()) text += "To render again:\n\n" + codeBlock(comparison.renderCommand);
        if (!comparison.acceptCommand.empty()) text += "\nTo accept:\n\n" + codeBlock(comparison.acceptCommand);
    }
    return text;
}

}  // namespace umbrage
