// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "diagnostics/csv_field.h"
#include "golden/reports.h"
#include "golden/result_text.h"

namespace umbrage {

std::string comparisonCsv(const Comparison& comparison) {
    const std::vector<std::string> metrics = metricsIn(comparison);
    std::string csv = "name,aov,frame,outcome,rule,metric,limit,value,reason";
    for (const std::string& metric : metrics) csv += fmt::format(",{}", csvField(metric));
    csv += "\n";
    for (const ImageResult& image : comparison.images) {
        std::vector<std::string> row{csvField(image.name), csvField(image.aov),
                                     image.frame > 0 ? std::to_string(image.frame) : "",
                                     std::string(infoOf(image.outcome).name)};
        if (image.decision) {
            const auto& [rule, metric, limit, value] = *image.decision;
            row.insert(row.end(),
                       {csvField(rule), csvField(metric), fmt::format("{}", limit), fmt::format("{}", value)});
        } else {
            row.resize(row.size() + 4);
        }
        row.push_back(csvField(image.reason));
        for (const std::string& metric : metrics) {
            const auto found = std::find_if(image.figures.begin(), image.figures.end(),
                                            [&](const Figure& figure) { return figure.metric == metric; });
            row.push_back(found == image.figures.end() ? "" : fmt::format("{}", found->value));
        }
        csv += fmt::format("{}\n", fmt::join(row, ","));
    }
    for (const BudgetResult& budget : comparison.budgets) {
        std::vector<std::string> row{csvField("budget " + budget.name),
                                     "",
                                     budget.frame ? std::to_string(*budget.frame) : "",
                                     std::string(infoOf(outcomeOf(budget)).name),
                                     boundName(budget),
                                     csvField(budget.name),
                                     fmt::format("{}", budget.limit),
                                     budget.value ? fmt::format("{}", *budget.value) : "",
                                     budget.exceeded ? csvField(explanation(budget)) : ""};
        row.resize(row.size() + metrics.size());
        csv += fmt::format("{}\n", fmt::join(row, ","));
    }
    return csv;
}

}  // namespace umbrage
