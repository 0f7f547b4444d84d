// SPDX-License-Identifier: Apache-2.0
#include "report/budget_table.h"

#include <gmock/gmock.h>

#include "../diagnostics/runs.h"
#include "report/statistics_page.h"
#include "report/statistics_table.h"

namespace umbrage {
namespace {

std::string lineOf(const Budget& budget) {
    return budgetText(checkBudgets(twoFramesFile(), {budget}).front());
}

TEST(BudgetText, SaysFigureValueFrameLimitAndHowMuchOver) {
    EXPECT_EQ(lineOf({"overdraw.p95", 4}),
              "overdraw.p95 is 5 fragments/pixel in frame 2, 1 (25.0 %) over the budget of 4");
    EXPECT_EQ(lineOf({"overdraw.fragments", 1500}),
              "overdraw.fragments is 2,015 in frame 2, 515 (34.3 %) over the budget of 1,500");
    EXPECT_EQ(lineOf({"overdraw.fragments", 2000, true}),
              "overdraw.fragments is 1,015 in frame 1, 985 (49.2 %) under the budget of 2,000");
    EXPECT_EQ(lineOf({"triangles", 0}), "triangles is 10,144 in frame 1, 10,144 over the budget of 0");
    EXPECT_EQ(lineOf({"stencil.max", 0.5}),
              "stencil.max is 1 volumes/pixel in frame 1, light Lamp, 0.500 (100.0 %) over the budget of 0.500");
}

TEST(BudgetText, SaysWhatIsMissing) {
    EXPECT_EQ(lineOf({"caps.dark", 4}), "caps.dark has no value in any frame, so nothing says that it is at most 4");
    EXPECT_EQ(lineOf({"caps.dark", 4, true}),
              "caps.dark has no value in frame 1, so nothing says that it is at least 4");
}

TEST(BudgetTable, MarksWhatIsOver) {
    StatisticsFile file = twoFramesFile();
    file.budgets = checkBudgets(file, {{"overdraw.p95", 4},
                                       {"overdraw.fragments", 5000},
                                       {"overdraw.fragments", 2000, true},
                                       {"stencil.max", 2},
                                       {"caps.dark", 3}});
    const std::string table =
        "budget                     limit           worst  in frame                         unit\n"
        "  overdraw.p95             at most 4           5         2  OVER by 1 (25.0 %)     fragments/pixel\n"
        "  overdraw.fragments       at most 5,000   2,015         2  held                   count\n"
        "  overdraw.fragments       at least 2,000  1,015         1  UNDER by 985 (49.2 %)  count\n"
        "  stencil.max, light Lamp  at most 2           1         1  held                   volumes/pixel\n"
        "  caps.dark                at most 3           -         -  NO VALUE               count\n";
    EXPECT_EQ(budgetTable(file.budgets), table);
    EXPECT_THAT(statisticsTable(file), testing::HasSubstr("frames: 1,2\n\n" + table + "\nscene "));
    EXPECT_EQ(budgetTable({}), "");
}

TEST(BudgetTable, OfThePageComesWithTheNumbers) {
    StatisticsFile file = twoFramesFile();
    file.budgets = checkBudgets(file, {{"overdraw.p95", 4}});
    EXPECT_THAT(statisticsPage(file, {}), testing::HasSubstr("\"budgets\":[{\"name\":\"overdraw.p95\",\"max\":4,"));
}

}  // namespace
}  // namespace umbrage
