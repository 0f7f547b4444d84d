// SPDX-License-Identifier: Apache-2.0
// Limits on figures, judged by hand-made runs.
#include "diagnostics/budgets.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "../json_schema.h"
#include "diagnostics/statistics_merge.h"
#include "error.h"
#include "runs.h"

namespace umbrage {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using Json = nlohmann::ordered_json;

BudgetResult check(const StatisticsFile& file, const Budget& budget) {
    const std::vector<BudgetResult> results = checkBudgets(file, {budget});
    EXPECT_EQ(results.size(), 1u);
    return results.front();
}

TEST(Budgets, NameTheWorstFrameAndAllowTheLimitItself) {
    // fragments of frame 1: 10 + 1000 of Lamp, 5 of Sun; of frame 2: 10 + 2000 and 5
    const BudgetResult over = check(twoFramesFile(), {"overdraw.fragments", 2000});
    EXPECT_EQ(over, (BudgetResult{.name = "overdraw.fragments",
                                  .unit = "count",
                                  .limit = 2000,
                                  .value = 2015,
                                  .frame = 2,
                                  .exceeded = true}));
    EXPECT_EQ(over.excess(), 15);
    const BudgetResult held = check(twoFramesFile(), {"overdraw.fragments", 2015});
    EXPECT_FALSE(held.exceeded);
    EXPECT_EQ(held.frame, 2) << "the nearest to the limit";
    EXPECT_TRUE(check(twoFramesFile(), {"overdraw.fragments", 2014.999}).exceeded);
}

TEST(Budgets, OfAtLeastNameTheSmallest) {
    const BudgetResult under = check(twoFramesFile(), {"overdraw.fragments", 1016, true});
    EXPECT_EQ(under.value, 1015);
    EXPECT_EQ(under.frame, 1);
    EXPECT_TRUE(under.exceeded);
    EXPECT_EQ(under.excess(), 1);
    EXPECT_FALSE(check(twoFramesFile(), {"overdraw.fragments", 1015, true}).exceeded);
}

TEST(Budgets, OfEqualFramesTheFirstIsNamed) {
    EXPECT_EQ(check(twoFramesFile(), {"triangles", 1}).frame, 1);
    EXPECT_EQ(check(twoFramesFile(), {"triangles", 1, true}).frame, 1);
}

TEST(Budgets, TakeFiguresOfDistributions) {
    const BudgetResult over = check(twoFramesFile(), {"overdraw.p95", 4});
    EXPECT_EQ(over.value, 5);
    EXPECT_EQ(over.unit, "fragments/pixel");
    EXPECT_TRUE(over.exceeded);
    EXPECT_EQ(check(twoFramesFile(), {"overdraw.mean", 4}).value, (0 + 1 + 1 + 5) / 4.0);
    EXPECT_EQ(check(twoFramesFile(), {"overdraw.p50", 1}).exceeded, false);
}

TEST(Budgets, OnWhatOnlyLightsHaveAreJudgedLightByLight) {
    Statistics s = twoFrames();
    s.record(2, {.light = "Sun"}, "stencil", distributionOf({0, 3}));
    const BudgetResult over = check(s.file({}), {"stencil.max", 2});
    EXPECT_EQ(over.value, 3);
    EXPECT_EQ(over.frame, 2);
    EXPECT_EQ(over.light, "Sun");
    EXPECT_TRUE(over.exceeded);
    EXPECT_EQ(check(s.file({}), {"overdraw.fragments", 0}).light, "") << "what a frame has is the frame's";
}

TEST(Budgets, OnWhatNoFrameHasAreBroken) {
    for (const bool atLeast : {false, true}) {
        const BudgetResult nothing = check(twoFramesFile(), {"caps.dark", 5, atLeast});
        EXPECT_TRUE(nothing.exceeded);
        EXPECT_EQ(nothing.value, std::nullopt);
        EXPECT_EQ(nothing.excess(), 0);
        EXPECT_TRUE(check(Statistics().file({}), {"caps.dark", 5, atLeast}).exceeded) << "no frame at all";
        EXPECT_TRUE(check(twoFramesFile(), {"no.such.figure", 5, atLeast}).exceeded);
    }
    EXPECT_EQ(check(twoFramesFile(), {"caps.dark", 5}).frame, std::nullopt);
}

TEST(Budgets, OfAtLeastAreBrokenByAFrameWithoutTheNumber) {
    Statistics s = twoFrames();
    s.record(2, {}, "caps.dark", 7);
    const BudgetResult most = check(s.file({}), {"caps.dark", 7});
    EXPECT_FALSE(most.exceeded);
    EXPECT_EQ(most.frame, 2);
    const BudgetResult least = check(s.file({}), {"caps.dark", 1, true});
    EXPECT_TRUE(least.exceeded);
    EXPECT_EQ(least.value, std::nullopt);
    EXPECT_EQ(least.frame, 1);
    s.record(3, {}, "caps.dark", 0);
    EXPECT_EQ(check(s.file({}), {"caps.dark", 1, true}).frame, 1) << "nothing at all is worse than too little";
}

TEST(Budgets, AreOnAllCountersAndFiguresOfDistributions) {
    const std::vector<std::string> figures = budgetFigures();
    EXPECT_EQ(figures.size(), kCounters.size() + 5 * kQuantities.size());
    for (const char* name : {"overdraw.p95", "edges.silhouette", "time.frame.ratio", "memory.peak", "stencil.max"}) {
        EXPECT_THAT(figures, Contains(name));
    }
    EXPECT_THAT(figures, Not(Contains("overdraw")));
    // Each is found in the file's terms.
    for (const std::string& figure : figures) EXPECT_TRUE(unitOfFigure(twoFramesFile(), figure)) << figure;
}

TEST(Budgets, SayWhatHasToBeMeasured) {
    EXPECT_EQ(needsOf("overdraw.p95"), BudgetNeeds::Figures);
    EXPECT_EQ(needsOf("edges.silhouette"), BudgetNeeds::Figures);
    EXPECT_EQ(needsOf("memory.device"), BudgetNeeds::Figures);
    EXPECT_EQ(needsOf("stencil.max"), BudgetNeeds::Counts);
    EXPECT_EQ(needsOf("memory.peak"), BudgetNeeds::Memory);
    EXPECT_EQ(needsOf("time.frame"), BudgetNeeds::Times);
    for (const char* name : {"time.picture", "time.unshadowed", "time.frame.ratio"}) {
        EXPECT_EQ(needsOf(name), BudgetNeeds::Ratio) << name;
    }
    EXPECT_TRUE(anyNeeds({{"quads", 1}, {"time.frame", 1}}, BudgetNeeds::Times));
    EXPECT_FALSE(anyNeeds({{"quads", 1}, {"time.frame", 1}}, BudgetNeeds::Memory));
}

StatisticsFile fileWithBudgets() {
    StatisticsFile file = twoFramesFile();
    file.budgets = checkBudgets(
        file, {{"overdraw.p95", 4}, {"overdraw.fragments", 1, true}, {"stencil.max", 1}, {"caps.dark", 2.5}});
    return file;
}

TEST(Budgets, AreInTheJsonAndReadBack) {
    const StatisticsFile file = fileWithBudgets();
    const Json json = Json::parse(file.json());
    EXPECT_EQ(json["budgets"],
              Json::parse(R"([{"name": "overdraw.p95", "max": 4, "value": 5, "frame": 2, "exceeded": true},
                              {"name": "overdraw.fragments", "min": 1, "value": 1015, "frame": 1, "exceeded": false},
                              {"name": "stencil.max", "max": 1, "value": 1, "frame": 1, "light": "Lamp",
                               "exceeded": false},
                              {"name": "caps.dark", "max": 2.5, "exceeded": true}])"));
    EXPECT_EQ(parseStatistics(file.json(), "s.json").budgets, file.budgets);
    EXPECT_EQ(parseStatistics(file.json(), "s.json").json(), file.json());
    EXPECT_FALSE(Json::parse(twoFramesFile().json()).contains("budgets"));
}

TEST(Budgets, FitTheSchema) {
    const Json schema = Json::parse(statisticsSchema());
    Json json = Json::parse(fileWithBudgets().json());
    EXPECT_TRUE(validates(schema, json));
    Json both = json, neither = json, wrong = json;
    both["budgets"][0]["min"] = 1;
    neither["budgets"][0].erase("max");
    wrong["budgets"][0]["exceeded"] = "yes";
    EXPECT_FALSE(validates(schema, both));
    EXPECT_FALSE(validates(schema, neither));
    EXPECT_FALSE(validates(schema, wrong));
}

TEST(Budgets, ThatNoWriterWroteAreRefusedAtTheirPlace) {
    const auto expectRefused = [](const char* key, const Json& value, const std::string& where,
                                  const std::string& message) {
        Json json = Json::parse(fileWithBudgets().json());
        json["budgets"][0][key] = value;
        try {
            parseStatistics(json.dump(), "s.json");
            ADD_FAILURE() << key << " was read";
        } catch (const Error& error) {
            EXPECT_EQ(error.where(), "s.json: " + where);
            EXPECT_THAT(error.message(), HasSubstr(message));
        }
    };
    expectRefused("name", "overdraw.p96", "/budgets/0/name", "is not explained under /counters or /quantities");
    expectRefused("min", 1, "/budgets/0", "has both \"min\" and \"max\"");
    expectRefused("max", "4", "/budgets/0/max", "must be a number, but is string");
    expectRefused("exceeded", 1, "/budgets/0/exceeded", "must be true or false, but is number");
}

TEST(Budgets, OfSelectedFramesAreJudgedByThoseAlone) {
    const StatisticsFile file = fileWithBudgets();
    StatisticsSelection first;
    first.frame = [](int frame) { return frame == 1; };
    EXPECT_EQ(selectedStatistics(file, first).budgets[0].value, 2);
    EXPECT_FALSE(selectedStatistics(file, first).budgets[0].exceeded);
    // What is left out of sight is still judged.
    StatisticsSelection sun;
    sun.light = [](const std::string& id) { return id == "Sun"; };
    sun.name = [](const std::string& name) { return name == "quads"; };
    EXPECT_EQ(selectedStatistics(file, sun).budgets, file.budgets);
}

TEST(Budgets, OfShardsAreJudgedTogether) {
    const auto shard = [](int frame, const std::vector<Budget>& budgets) {
        StatisticsSelection selection;
        selection.frame = [=](int f) { return f == frame; };
        StatisticsFile file = selectedStatistics(twoFramesFile(), selection);
        file.budgets = checkBudgets(file, budgets);
        return NamedStatistics{std::to_string(frame), file};
    };
    const StatisticsFile merged =
        mergedStatistics({shard(1, {{"overdraw.p95", 4}}), shard(2, {{"overdraw.p95", 4}, {"edges.silhouette", 321}})});
    ASSERT_EQ(merged.budgets.size(), 2u);
    EXPECT_EQ(merged.budgets[0].frame, 2);
    EXPECT_TRUE(merged.budgets[0].exceeded);
    EXPECT_EQ(merged.budgets[1].value, 321);
    EXPECT_TRUE(anyExceeded(merged.budgets));
    EXPECT_THAT(budgetsOf(merged.budgets), ElementsAre(Budget{"overdraw.p95", 4}, Budget{"edges.silhouette", 321}));
    EXPECT_THAT(mergedStatistics({{"a", twoFramesFile()}}).budgets, IsEmpty());
}

}  // namespace
}  // namespace umbrage
