// SPDX-License-Identifier: Apache-2.0
// Statistics against the golden's, by hand-made runs.
#include "golden/compare_statistics.h"

#include <gmock/gmock.h>

#include "../diagnostics/runs.h"

namespace umbrage {
namespace {

using testing::HasSubstr;

const StatisticsResult* columnOf(const std::vector<StatisticsResult>& results, const std::string& column) {
    const auto found = std::ranges::find(results, column, &StatisticsResult::column);
    return found == results.end() ? nullptr : &*found;
}

/// twoFrames() with other numbers in frame 2.
StatisticsFile changed(double fragmentsOfTree, double frameMilliseconds = 24.5) {
    Statistics s = twoFrames();
    s.record(2, {.light = "Lamp", .caster = "/Tree"}, "overdraw.fragments", fragmentsOfTree);
    s.record(2, {}, "time.frame", frameMilliseconds);
    return s.file({});
}

Outcome outcomeOf(const StatisticsFile& output, const std::string& column,
                  const std::vector<StatisticsTolerance>& tolerances) {
    const std::vector<StatisticsResult> results = compareWithin(twoFramesFile(), output, tolerances);
    const StatisticsResult* result = columnOf(results, column);
    EXPECT_NE(result, nullptr) << column;
    return result ? result->outcome : Outcome::Unreadable;
}

TEST(CompareWithin, EqualRunsPassInEveryColumnButTimes) {
    const std::vector<StatisticsResult> results = compareWithin(twoFramesFile(), changed(2000, 99), {});
    ASSERT_FALSE(results.empty());
    for (const StatisticsResult& result : results) {
        EXPECT_EQ(result.outcome, result.column == "time.frame" ? Outcome::Skipped : Outcome::Pass) << result.column;
    }
    EXPECT_EQ(columnOf(results, "time.frame")->reason, "measured, so it differs from run to run");
    for (const char* column :
         {"triangles", "overdraw.fragments", "overdraw.fragments, Lamp", "overdraw.fragments, /Tree", "overdraw.p95",
          "stencil.max, Lamp", "scene.shaded, bark"}) {
        EXPECT_NE(columnOf(results, column), nullptr) << column;
    }
}

TEST(CompareWithin, CountsAreExactAndTheWorstFrameIsNamed) {
    Statistics s = twoFrames();
    s.record(1, {.light = "Lamp", .caster = "/Tree"}, "overdraw.fragments", 1001);
    s.record(2, {.light = "Lamp", .caster = "/Tree"}, "overdraw.fragments", 1900);
    const std::vector<StatisticsResult> results = compareWithin(twoFramesFile(), s.file({}), {});
    const StatisticsResult* tree = columnOf(results, "overdraw.fragments, /Tree");
    ASSERT_NE(tree, nullptr);
    EXPECT_EQ(tree->outcome, Outcome::Fail);
    EXPECT_EQ(tree->frame, 2) << "5 % is more than 0.1 %";
    EXPECT_EQ(tree->golden, 2000);
    EXPECT_EQ(tree->output, 1900);
    EXPECT_EQ(tree->reason, "5 % off, 0 % is allowed");
    EXPECT_EQ(columnOf(results, "overdraw.fragments")->outcome, Outcome::Fail) << "what parts add up to";
    EXPECT_EQ(columnOf(results, "edges.silhouette")->outcome, Outcome::Pass);
}

TEST(CompareWithin, ATolerancesShareIsItselfAllowed) {
    const std::string tree = "overdraw.fragments, /Tree";
    EXPECT_EQ(outcomeOf(changed(2500), tree, {{"overdraw.*", 0.25}}), Outcome::Pass);
    EXPECT_EQ(outcomeOf(changed(2501), tree, {{"overdraw.*", 0.25}}), Outcome::Fail);
    EXPECT_EQ(outcomeOf(changed(1500), tree, {{"overdraw.*", 0.25}}), Outcome::Pass);
    EXPECT_EQ(outcomeOf(changed(1499), tree, {{"overdraw.*", 0.25}}), Outcome::Fail);
    EXPECT_EQ(outcomeOf(changed(2001), tree, {{"edges.*", 0.25}}), Outcome::Fail) << "of other columns";
}

TEST(CompareWithin, TheLastToleranceThatMatchesCounts) {
    const std::string tree = "overdraw.fragments, /Tree";
    EXPECT_EQ(outcomeOf(changed(2001), tree, {{"*", 0.5}, {"overdraw.fragments", 0.0}}), Outcome::Fail);
    EXPECT_EQ(outcomeOf(changed(2001), tree, {{"overdraw.fragments", 0.0}, {"*", 0.5}}), Outcome::Pass);
    EXPECT_EQ(outcomeOf(changed(9), tree, {{"overdraw.*", {}}}), Outcome::Skipped);
    EXPECT_EQ(outcomeOf(changed(2000, 25), "time.frame", {{"time.*", 0.01}}), Outcome::Fail) << "where it is asked for";
    EXPECT_EQ(outcomeOf(changed(2000, 25), "time.frame", {{"time.*", 0.05}}), Outcome::Pass);
}

TEST(CompareWithin, NothingButZeroIsWithinAShareOfZero) {
    Statistics golden, output;
    golden.record(1, {}, "caps.dark", 0);
    golden.record(1, {}, "caps.light", 0);
    output.record(1, {}, "caps.dark", 0);
    output.record(1, {}, "caps.light", 1);
    const std::vector<StatisticsResult> results = compareWithin(golden.file({}), output.file({}), {{"*", 1000.0}});
    EXPECT_EQ(columnOf(results, "caps.dark")->outcome, Outcome::Pass);
    EXPECT_EQ(columnOf(results, "caps.light")->outcome, Outcome::Fail);
    EXPECT_EQ(columnOf(results, "caps.light")->reason, "the golden has 0");
}

TEST(CompareWithin, NumbersThatOneLacksAreDifferences) {
    Statistics more = twoFrames();
    more.record(2, {.light = "Torch"}, "quads", 4);
    const std::vector<StatisticsResult> extra = compareWithin(twoFramesFile(), more.file({}), {});
    EXPECT_EQ(columnOf(extra, "quads, Torch")->outcome, Outcome::MissingGolden);
    EXPECT_EQ(columnOf(extra, "quads, Torch")->frame, 2);
    EXPECT_EQ(columnOf(extra, "quads, Torch")->reason, "the golden has no such number in frame 2");
    const std::vector<StatisticsResult> lacking = compareWithin(more.file({}), twoFramesFile(), {{"*", 1.0}});
    EXPECT_EQ(columnOf(lacking, "quads, Torch")->outcome, Outcome::MissingOutput);
}

TEST(CompareWithin, AGoldenThatDoesNotKnowANumberIsOlderButAnOutputIsWrong) {
    StatisticsFile old = twoFramesFile();
    const auto triangles = std::ranges::find(old.counters, "triangles", &StatisticsFile::CounterEntry::name);
    const auto row = std::size_t(triangles - old.counters.begin());
    triangles->name = "renamed";
    for (auto& [frame, places] : old.frames) places[{}].values.erase(row);
    const std::vector<StatisticsResult> older = compareWithin(old, twoFramesFile(), {});
    EXPECT_EQ(columnOf(older, "triangles")->outcome, Outcome::Skipped);
    EXPECT_EQ(columnOf(older, "triangles")->reason, "the golden is older than this number");
    EXPECT_EQ(columnOf(compareWithin(twoFramesFile(), old, {}), "triangles")->outcome, Outcome::MissingOutput);
}

TEST(CompareWithin, FramesThatOneLacksAreADifferenceOfTheirOwn) {
    StatisticsFile first = twoFramesFile();
    first.frames.erase(2);
    const std::vector<StatisticsResult> lacking = compareWithin(twoFramesFile(), first, {});
    EXPECT_EQ(lacking.front().column, "frames");
    EXPECT_EQ(lacking.front().outcome, Outcome::MissingOutput);
    EXPECT_EQ(lacking.front().reason, "frame 2 is not in the output");
    EXPECT_EQ(columnOf(lacking, "triangles")->outcome, Outcome::Pass) << "by the frames of both";
    EXPECT_EQ(compareWithin(first, twoFramesFile(), {}).front().outcome, Outcome::MissingGolden);
    first.frames.clear();
    const std::vector<StatisticsResult> nothing = compareWithin(twoFramesFile(), first, {});
    ASSERT_EQ(nothing.size(), 1u);
    EXPECT_EQ(nothing.front().reason, "2 frames are not in the output, the first is 1");
}

TEST(WithinTable, ShowsWhatIsOverAndCountsTheRest) {
    const std::string table = withinTable(compareWithin(twoFramesFile(), changed(2500), {{"overdraw.*", 0.2}}));
    EXPECT_EQ(table,
              "column                     frame  golden  output  outcome\n"
              "overdraw.fragments             2   2,015   2,515  fail     24.8 % off, 20 % is allowed\n"
              "overdraw.fragments, /Tree      2   2,000   2,500  fail     25 % off, 20 % is allowed\n"
              "overdraw.fragments, Lamp       2   2,010   2,510  fail     24.9 % off, 20 % is allowed\n"
              "\n"
              "19 pass, 1 skipped, 3 fail\n");
    EXPECT_THAT(withinTable(compareWithin(twoFramesFile(), twoFramesFile(), {})),
                testing::EndsWith(" pass, 1 skipped\n"));
}

}  // namespace
}  // namespace umbrage
