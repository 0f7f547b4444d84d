// SPDX-License-Identifier: Apache-2.0
#include "golden/result_text.h"

#include <fmt/format.h>

#include <algorithm>

#include "golden/metrics.h"
#include "report/budget_table.h"

namespace umbrage {
namespace {

std::string joined(const std::string& reason, const std::string& decision, Outcome outcome) {
    if (reason.empty() && decision.empty()) return std::string(infoOf(outcome).meaning);
    if (reason.empty() || decision.empty()) return reason + decision;
    return fmt::format("{} ({})", reason, decision);
}

}  // namespace

Outcome outcomeOf(const BudgetResult& budget) {
    return budget.exceeded ? Outcome::Fail : Outcome::Pass;
}

std::string boundName(const BudgetResult& budget) {
    return budget.atLeast ? "min" : "max";
}

std::array<std::size_t, kOutcomes.size()> countsOf(const Comparison& comparison) {
    std::array<std::size_t, kOutcomes.size()> counts{};
    for (const ImageResult& image : comparison.images) ++counts[std::size_t(image.outcome)];
    for (const StatisticsResult& column : comparison.statistics) ++counts[std::size_t(column.outcome)];
    for (const BudgetResult& budget : comparison.budgets) ++counts[std::size_t(outcomeOf(budget))];
    return counts;
}

std::string countsText(const Comparison& comparison) {
    const auto counts = countsOf(comparison);
    std::string failing, passing;
    for (std::size_t o = 0; o < counts.size(); ++o) {
        if (counts[o] == 0) continue;
        std::string& text = kOutcomes[o].passes ? passing : failing;
        text += fmt::format("{}{} {}", text.empty() ? "" : ", ", counts[o], kOutcomes[o].name);
    }
    if (failing.empty() && passing.empty()) return "nothing was compared";
    return failing.empty() || passing.empty() ? failing + passing : failing + ", " + passing;
}

std::string shownNumber(double value) {
    return fmt::format("{:.6g}", value);
}

bool isWorseBelow(const std::string& metric) {
    const MetricInfo* info = findMetric(metric);  // a report that was read may have metrics of another version
    return info && !info->largerIsWorse;
}

std::string decisionText(const ImageResult& image) {
    if (!image.decision) return {};
    const auto& [rule, metric, limit, value] = *image.decision;
    const bool below = isWorseBelow(metric);
    const bool holds = below ? value >= limit : value <= limit;
    return fmt::format("{}: {} {} is {} {}", rule, metric, shownNumber(value),
                       holds   ? "within"
                       : below ? "under"
                               : "over",
                       shownNumber(limit));
}

std::string explanation(const ImageResult& image) {
    return joined(image.reason, decisionText(image), image.outcome);
}

std::string explanation(const StatisticsResult& column) {
    const std::string frame = column.frame > 0 ? fmt::format(" in frame {}", column.frame) : "";
    return joined(column.reason,
                  fmt::format("{} instead of {}{}, tolerance {}", shownNumber(column.output),
                              shownNumber(column.golden), frame, shownNumber(column.tolerance)),
                  column.outcome);
}

std::string explanation(const BudgetResult& budget) {
    return joined(budget.exceeded ? budgetText(budget) : "", "", outcomeOf(budget));
}

std::vector<std::string> metricsIn(const Comparison& comparison) {
    std::vector<std::string> metrics;
    for (const ImageResult& image : comparison.images) {
        for (const Figure& figure : image.figures) {
            if (std::find(metrics.begin(), metrics.end(), figure.metric) == metrics.end()) {
                metrics.push_back(figure.metric);
            }
        }
    }
    return metrics;
}

}  // namespace umbrage
