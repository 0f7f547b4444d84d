// SPDX-License-Identifier: Apache-2.0
// Limits on a run's figures, and whether they held.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace umbrage {

struct StatisticsFile;

/// What every frame must hold to. A figure is a counter of kCounters, or one of a quantity's distribution:
/// overdraw.p95.
struct Budget {
    std::string name;      // of the figure
    double limit = 0.0;    // in its unit, itself allowed
    bool atLeast = false;  // else at most

    bool operator==(const Budget&) const = default;
};

/// A budget and the frame that comes nearest to its limit, or is farthest beyond it.
struct BudgetResult {
    std::string name, unit;
    double limit = 0.0;
    bool atLeast = false;
    std::optional<double> value{};  // none: the frame has no such number, or no frame has
    std::optional<int> frame{};     // the first of equals; none: no frame has such a number
    std::string light{};            // whose value it is, of a figure that a whole frame has not; else empty
    bool exceeded = false;          // also where there is nothing to judge

    /// How far the value is beyond the limit, or, if negative, within it; 0 without a value.
    double excess() const { return value ? (atLeast ? limit - *value : *value - limit) : 0.0; }

    bool operator==(const BudgetResult&) const = default;
};

/// What has to be measured for a budget.
enum class BudgetNeeds : std::uint8_t {
    Figures,  // counters and distributions of each frame
    Counts,   // and how many volumes hold each pixel, without the skips that change that
    Memory,   // of the process
    Times,    // of the passes
    Ratio,    // each frame with and without shadows
};

/// Every figure that a budget may be on, by its name.
std::vector<std::string> budgetFigures();

/// @param name  one of budgetFigures()
BudgetNeeds needsOf(const std::string& name);

/// The unit of a figure in that file's terms; nothing where it has no such figure.
std::optional<std::string> unitOfFigure(const StatisticsFile& file, const std::string& name);

bool anyNeeds(const std::vector<Budget>& budgets, BudgetNeeds needs);

/// Judges each frame as a whole: what its lights, casters or materials combine to, as withWholes() has it. A figure
/// that only lights have is judged light by light. Frames without a number break only budgets of at least something; a
/// budget on what no frame has is broken, for nothing says that it was kept.
///
/// @return  a result for each budget, in their order
std::vector<BudgetResult> checkBudgets(const StatisticsFile& file, const std::vector<Budget>& budgets);

/// What these are results of.
std::vector<Budget> budgetsOf(const std::vector<BudgetResult>& results);

bool anyExceeded(const std::vector<BudgetResult>& results);

}  // namespace umbrage
