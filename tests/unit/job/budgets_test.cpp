// SPDX-License-Identifier: Apache-2.0
// statistics.budgets and --budget.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "../json_schema.h"
#include "expect_error.h"

namespace umbrage {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

const std::string kYaml = sequence("statistics: {budgets: {overdraw.p95: 6, edges.silhouette: {max: 1e5, min: 1}}}\n");

JobOverrides budgetOptions(const std::vector<std::string>& budgets) {
    JobOverrides overrides;
    overrides.budgets = budgets;
    return overrides;
}

TEST(JobBudgets, AreALimitOrTwo) {
    EXPECT_THAT(read(kYaml).statistics.budgets, ElementsAre(Budget{"overdraw.p95", 6}, Budget{"edges.silhouette", 1e5},
                                                            Budget{"edges.silhouette", 1, true}));
    EXPECT_THAT(read(sequence("statistics: {budgets: {quads: {min: 0}}}")).statistics.budgets,
                ElementsAre(Budget{"quads", 0, true}));
    EXPECT_THAT(read(sequence("")).statistics.budgets, IsEmpty());
}

TEST(JobBudgets, AloneMakeStatisticsWantedButNotWritten) {
    const Job job = read(kYaml);
    EXPECT_TRUE(job.statistics.isWanted());
    EXPECT_FALSE(job.statistics.isWritten());
    EXPECT_FALSE(read(sequence("statistics: {budgets: {}}")).statistics.isWanted());
}

TEST(JobBudgets, OfTheCommandLineAddAndReplace) {
    const Job job = read(kYaml, budgetOptions({"overdraw.p95=5", "quads={min: 2, max: 3}", "edges.silhouette=9"}));
    EXPECT_THAT(job.statistics.budgets, ElementsAre(Budget{"overdraw.p95", 5}, Budget{"edges.silhouette", 9},
                                                    Budget{"quads", 3}, Budget{"quads", 2, true}));
    EXPECT_THAT(read(sequence(""), budgetOptions({"overdraw.p95=5"})).statistics.budgets,
                ElementsAre(Budget{"overdraw.p95", 5}));
    EXPECT_THAT(read(sequence(""), {{"statistics.budgets.\"overdraw.p95\"=4"}}).statistics.budgets,
                ElementsAre(Budget{"overdraw.p95", 4}));
}

TEST(JobBudgets, OfTheCommandLineAreReadWithoutASequence) {
    EXPECT_THAT(parseBudgets({"overdraw.p95=5", "quads={min: 1}", "overdraw.p95=7"}),
                ElementsAre(Budget{"overdraw.p95", 7}, Budget{"quads", 1, true}));
    EXPECT_THAT(parseBudgets({}), IsEmpty());
}

TEST(JobBudgets, NonsenseIsRefusedAtItsPlace) {
    const auto refused = [](const std::string& budgets, const Expected& expected) {
        expectRefused(sequence("statistics:\n  budgets: " + budgets + "\n"), expected);
    };
    refused("{overdraw.p96: 6}",
            {"s.yaml:4:13", "unknown name \"overdraw.p96\" in budgets", "did you mean \"overdraw.p95\"?"});
    refused("{edges.silhouete: 6}", {"s.yaml:4:13", "unknown name \"edges.silhouete\"", "\"edges.silhouette\"?"});
    refused("{overdraw: 6}", {"s.yaml:4:13", "unknown name \"overdraw\"", ""});
    refused("{quads: many}", {"s.yaml:4:20", "quads must be a number of at least 0", ""});
    refused("{quads: -1}", {"s.yaml:4:20", "quads must be a number of at least 0, not -1", ""});
    refused("{quads: .nan}", {"s.yaml:4:20", "quads must be a number of at least 0", "finite"});
    refused("{quads: }", {"s.yaml:4:20", "quads must be a number of at least 0, not nothing", ""});
    refused("{quads: {}}", {"s.yaml:4:20", "the budget has no limit", "max: or min:"});
    refused("{quads: {most: 4}}", {"s.yaml:4:21", "unknown key \"most\" in budget", "max"});
    refused("{quads: {min: 4, max: 3}}", {"s.yaml:4:20", "no value is at least 4 and at most 3", ""});
    refused("[quads]", {"s.yaml:4:12", "budgets must be a mapping {figure: limit, ...}", ""});
    refused("{quads: 1, quads: 2}", {"s.yaml:4:23", "the key \"quads\" is there twice", "s.yaml:4:13"});
}

TEST(JobBudgets, NonsenseOfTheCommandLineNamesItsOption) {
    const auto refused = [](const std::string& budget, const Expected& expected) {
        SCOPED_TRACE(budget);
        expectError([&] { read(kYaml, budgetOptions({budget})); }, expected);
        expectError([&] { parseBudgets({budget}); }, expected);
    };
    refused("overdraw.p96=6", {"--budget", "unknown name \"overdraw.p96\"", "did you mean \"overdraw.p95\"?"});
    refused("overdraw.p95=six", {"--budget", "overdraw.p95 must be a number of at least 0", ""});
    refused("overdraw.p95=", {"--budget", "overdraw.p95 must be a number of at least 0, not nothing", ""});
    refused("overdraw.p95", {"--budget", "this is not an assignment", ""});
    refused("=6", {"--budget", "this is not an assignment", ""});
}

TEST(JobBudgets, OnTimesNeedTheProfile) {
    for (const std::string figure : {"time.frame", "time.counts", "time.frame.ratio"}) {
        expectRefused(
            sequence("statistics: {budgets: {" + figure + ": 2}}\n"),
            {"s.yaml:3:" + std::to_string(26 + figure.size()),
             figure + " is measured only where diagnostics.profile is true", "set diagnostics.profile to true"});
        EXPECT_EQ(read(sequence("diagnostics: {profile: true}\nstatistics: {budgets: {" + figure + ": 2}}\n"))
                      .statistics.budgets.size(),
                  1u);
    }
    expectError([] { read(sequence(""), budgetOptions({"time.frame=2"})); }, {"--budget", "diagnostics.profile", ""});
    EXPECT_EQ(read(sequence("statistics: {budgets: {memory.peak: 900}}\n")).statistics.budgets.size(), 1u);
}

TEST(JobBudgets, AreInTheSchema) {
    using Json = nlohmann::ordered_json;
    const Json schema = Json::parse(jobSchema());
    const auto valid = [&](const char* budgets) {
        Json json = Json::parse(R"({"umbrage": 1, "scene": [{"gltf": "a.glb"}]})");
        json["statistics"]["budgets"] = Json::parse(budgets);
        return validates(schema, json);
    };
    EXPECT_TRUE(valid(R"({"overdraw.p95": 6, "quads": {"max": 4}, "edges": {"min": 1, "max": 2}})"));
    EXPECT_FALSE(valid(R"({"overdraw.p96": 6})"));
    EXPECT_FALSE(valid(R"({"quads": "6"})"));
    EXPECT_FALSE(valid(R"({"quads": {"most": 6}})"));
}

}  // namespace
}  // namespace umbrage
