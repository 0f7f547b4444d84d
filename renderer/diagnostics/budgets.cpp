// SPDX-License-Identifier: Apache-2.0
#include "diagnostics/budgets.h"

#include <fmt/format.h>

#include <algorithm>

#include "diagnostics/quantities.h"
#include "diagnostics/statistics_format.h"
#include "diagnostics/statistics_summary.h"

namespace umbrage {
namespace {

/// Where a file keeps a figure: a row of its counters, or one of its quantities with a figure of that.
struct FigureIn {
    std::size_t row = 0;
    const DistributionFigure* ofDistribution = nullptr;  // null: a counter
    std::string unit{};

    std::optional<double> valueOf(const Figures& figures) const {
        if (ofDistribution) {
            const auto found = figures.distributions.find(row);
            return found == figures.distributions.end() ? std::nullopt
                                                        : std::optional(ofDistribution->of(found->second));
        }
        const auto found = figures.values.find(row);
        return found == figures.values.end() ? std::nullopt : std::optional(found->second);
    }
};

std::optional<FigureIn> figureIn(const StatisticsFile& file, const std::string& name) {
    for (std::size_t i = 0; i < file.counters.size(); ++i) {
        if (file.counters[i].name == name) return FigureIn{i, nullptr, file.counters[i].unit};
    }
    for (std::size_t i = 0; i < file.quantities.size(); ++i) {
        for (const DistributionFigure& figure : kDistributionFigures) {
            if (figureName(file.quantities[i].name, figure) != name) continue;
            return FigureIn{i, &figure, file.quantities[i].unit};
        }
    }
    return std::nullopt;
}

/// One budget, frame after frame.
class Check {
public:
    Check(const StatisticsFile& file, const Budget& budget) {
        result_.name = budget.name;
        result_.limit = budget.limit;
        result_.atLeast = budget.atLeast;
        figure_ = figureIn(file, budget.name);
        if (figure_) result_.unit = figure_->unit;
    }

    void frame(int frame, const FrameFigures& places) {
        bool found = false;
        const auto look = [&](const StatisticsPlace& place, const Figures& figures) {
            const std::optional<double> value = figure_ ? figure_->valueOf(figures) : std::nullopt;
            if (!value) return;
            found = true;
            consider(frame, place.light, value);
        };
        if (const auto whole = places.find({}); whole != places.end()) look({}, whole->second);
        if (found) return;
        for (const auto& [place, figures] : places) {
            if (!place.light.empty() && dimensionsOf(place) == 1) look(place, figures);
        }
        if (!found && result_.atLeast) consider(frame, "", std::nullopt);
    }

    BudgetResult result() const {
        BudgetResult result = result_;
        result.exceeded = !result.value || result.excess() > 0.0;
        return result;
    }

private:
    void consider(int frame, const std::string& light, std::optional<double> value) {
        BudgetResult next = result_;
        next.value = value;
        const bool isWorse = !value || next.excess() > result_.excess();
        if (result_.frame && (!result_.value || !isWorse)) return;
        next.frame = frame;
        next.light = light;
        result_ = next;
    }

    std::optional<FigureIn> figure_;
    BudgetResult result_;
};

}  // namespace

std::vector<std::string> budgetFigures() {
    std::vector<std::string> names;
    for (const CounterInfo& counter : kCounters) names.emplace_back(counter.name);
    for (const QuantityInfo& quantity : kQuantities) {
        for (const DistributionFigure& figure : kDistributionFigures) {
            names.push_back(figureName(quantity.name, figure));
        }
    }
    return names;
}

BudgetNeeds needsOf(const std::string& name) {
    if (name == "memory.peak") return BudgetNeeds::Memory;
    const auto counter = std::ranges::find(kCounters, name, &CounterInfo::name);
    if (counter == kCounters.end()) return name.starts_with("stencil.") ? BudgetNeeds::Counts : BudgetNeeds::Figures;
    const std::string_view group = groupOf(std::size_t(counter - kCounters.begin())).name;
    return group == "time" ? BudgetNeeds::Times : group == "ratio" ? BudgetNeeds::Ratio : BudgetNeeds::Figures;
}

std::optional<std::string> unitOfFigure(const StatisticsFile& file, const std::string& name) {
    const std::optional<FigureIn> figure = figureIn(file, name);
    return figure ? std::optional(figure->unit) : std::nullopt;
}

bool anyNeeds(const std::vector<Budget>& budgets, BudgetNeeds needs) {
    return std::ranges::any_of(budgets, [=](const Budget& budget) { return needsOf(budget.name) == needs; });
}

std::vector<BudgetResult> checkBudgets(const StatisticsFile& file, const std::vector<Budget>& budgets) {
    std::vector<Check> checks;
    for (const Budget& budget : budgets) checks.emplace_back(file, budget);
    if (!checks.empty()) {
        for (const auto& [frame, figures] : file.frames) {
            const FrameFigures places = withWholes(file, figures);
            for (Check& check : checks) check.frame(frame, places);
        }
    }
    std::vector<BudgetResult> results;
    for (const Check& check : checks) results.push_back(check.result());
    return results;
}

std::vector<Budget> budgetsOf(const std::vector<BudgetResult>& results) {
    std::vector<Budget> budgets;
    for (const BudgetResult& result : results) budgets.push_back({result.name, result.limit, result.atLeast});
    return budgets;
}

bool anyExceeded(const std::vector<BudgetResult>& results) {
    return std::ranges::any_of(results, &BudgetResult::exceeded);
}

}  // namespace umbrage
