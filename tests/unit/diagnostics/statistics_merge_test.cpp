// SPDX-License-Identifier: Apache-2.0
#include "diagnostics/statistics_merge.h"

#include <gmock/gmock.h>

#include "error.h"
#include "runs.h"

namespace umbrage {
namespace {

using testing::HasSubstr;

StatisticsFile framesOf(const StatisticsFile& file, int frame) {
    StatisticsSelection selection;
    selection.frame = [=](int f) { return f == frame; };
    return selectedStatistics(file, selection);
}

void expectRefused(const std::vector<NamedStatistics>& files, const std::string& message) {
    try {
        mergedStatistics(files);
        ADD_FAILURE() << "merged: " << message;
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::Input);
        EXPECT_EQ(error.where(), files.back().name);
        EXPECT_THAT(error.message(), HasSubstr(message));
    }
}

TEST(StatisticsMerge, ShardsGiveTheFileOfTheWholeRun) {
    const StatisticsFile whole = twoFramesFile();
    const StatisticsFile merged = mergedStatistics({{"b.json", framesOf(whole, 2)}, {"a.json", framesOf(whole, 1)}});
    EXPECT_EQ(merged.json(), whole.json());
    const StatisticsFile read = mergedStatistics({{"b.json", parseStatistics(framesOf(whole, 2).json(), "b.json")},
                                                  {"a.json", parseStatistics(framesOf(whole, 1).json(), "a.json")}});
    EXPECT_EQ(read.json(), whole.json());
}

TEST(StatisticsMerge, EqualNumbersOfOnePlaceAreNoConflict) {
    EXPECT_EQ(mergedStatistics({{"a", twoFramesFile()}, {"b", twoFramesFile()}}).json(), twoFramesFile().json());
}

TEST(StatisticsMerge, DifferentNumbersOfOnePlaceAreRefused) {
    Statistics other = twoFrames();
    other.record(2, {.light = "Lamp", .caster = "/Tree"}, "overdraw.fragments", 7);
    expectRefused({{"a", twoFramesFile()}, {"b", other.file({{"sequence", "courtyard.yaml"}})}},
                  "another overdraw.fragments for frame 2, lights Lamp, casters /Tree");
    Statistics third = twoFrames();
    third.record(1, {}, "overdraw", distributionOf({9}));
    expectRefused({{"a", twoFramesFile()}, {"b", third.file({})}}, "another overdraw for frame 1");
}

TEST(StatisticsMerge, OtherSequencesAreRefused) {
    expectRefused({{"a", twoFramesFile()}, {"b", Statistics().file({{"sequence", "hall.yaml"}})}},
                  "is of hall.yaml, the files before are of courtyard.yaml");
}

TEST(StatisticsMerge, TheHeadNamesAllDevices) {
    const StatisticsFile merged = mergedStatistics({{"a", Statistics().file({{"device", "A"}})},
                                                    {"b", Statistics().file({{"device", "B"}})},
                                                    {"c", Statistics().file({{"device", "A"}, {"clock", "c"}})}});
    EXPECT_THAT(merged.header, testing::ElementsAre(std::pair("device", "A; B"), std::pair("clock", "c")));
}

TEST(StatisticsMerge, TablesOfOtherVersionsAreJoined) {
    StatisticsFile other;
    other.counters = {{"flux", "odd", "Wb", "?", Combine::Sum, "", ""},
                      twoFramesFile().counters[Counter("quads").index()]};
    other.frames[9][{}].values = {{0, 5.0}, {1, 6.0}};
    const StatisticsFile merged = mergedStatistics({{"a", twoFramesFile()}, {"b", other}});
    ASSERT_EQ(merged.counters.size(), kCounters.size() + 1);
    EXPECT_EQ(merged.counters.back().name, "flux");
    EXPECT_EQ(merged.frames.at(9).at({}).values.at(kCounters.size()), 5.0);
    EXPECT_EQ(merged.frames.at(9).at({}).values.at(Counter("quads").index()), 6.0);

    other.counters[1].unit = "bytes";
    expectRefused({{"a", twoFramesFile()}, {"b", other}}, "quads means something else");
}

TEST(StatisticsSelection, KeepsTheFramesLightsAndNamesAskedFor) {
    StatisticsSelection selection;
    selection.frame = [](int frame) { return frame == 2; };
    selection.light = [](const std::string& id) { return id == "Lamp"; };
    selection.name = [](const std::string& name) { return name != "edges.silhouette"; };
    const StatisticsFile selected = selectedStatistics(twoFramesFile(), selection);
    ASSERT_EQ(selected.frames.size(), 1u);
    const FrameFigures& frame = selected.frames.at(2);
    EXPECT_EQ(frame.size(), 3u) << "the light and its two casters";
    EXPECT_TRUE(frame.at({.light = "Lamp"}).values.empty());
    EXPECT_EQ(frame.at({.light = "Lamp"}).distributions.size(), 1u);
    EXPECT_FALSE(frame.contains({}));
    EXPECT_EQ(selectedStatistics(twoFramesFile(), {}).json(), twoFramesFile().json());
}

}  // namespace
}  // namespace umbrage
