// SPDX-License-Identifier: Apache-2.0
#include "report/statistics_compare.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numeric>

#include "../diagnostics/runs.h"

namespace umbrage {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

const StatisticsChange* find(const StatisticsComparison& comparison, const StatisticsPlace& place,
                             const std::string& name) {
    for (const StatisticsChange& change : comparison.changes) {
        if (change.place == place && change.name == name) return &change;
    }
    return nullptr;
}

std::vector<double> oneTo(int n) {
    std::vector<double> values(static_cast<std::size_t>(n));
    std::iota(values.begin(), values.end(), 1.0);
    return values;
}

// The ranks that tables of the sign test's interval for the median have.
TEST(MedianInterval, HasTheSignTestsRanks) {
    using Interval = std::pair<double, double>;
    EXPECT_FALSE(medianInterval({}));
    EXPECT_FALSE(medianInterval(oneTo(5)));
    EXPECT_EQ(medianInterval(oneTo(6)), Interval(1, 6));
    EXPECT_EQ(medianInterval(oneTo(8)), Interval(1, 8));
    EXPECT_EQ(medianInterval(oneTo(9)), Interval(2, 8));
    EXPECT_EQ(medianInterval(oneTo(12)), Interval(3, 10));
    EXPECT_EQ(medianInterval(oneTo(25)), Interval(8, 18));
    EXPECT_EQ(medianInterval(oneTo(100)), Interval(40, 61));
    const auto many = medianInterval(oneTo(100000));  // half the number, -+ 1.96 half its root
    ASSERT_TRUE(many);
    EXPECT_NEAR(many->first, 50000 - 310, 2);
    EXPECT_NEAR(many->second, 50000 + 311, 2);
}

TEST(StatisticsCompare, OfARunWithItselfFindsNoChange) {
    const StatisticsComparison same = compareStatistics(twoFramesFile(), twoFramesFile());
    EXPECT_GT(same.changes.size(), 10u);
    for (const StatisticsChange& change : same.changes) {
        EXPECT_FALSE(change.isSignificant()) << change.name;
        EXPECT_EQ(change.ratio, 1.0) << change.name;
        EXPECT_EQ(change.before, change.after) << change.name;
    }
    EXPECT_THAT(comparisonTable(twoFramesFile(), twoFramesFile()), Not(HasSubstr("*\n")));
}

TEST(StatisticsCompare, CountsAreComparedExactly) {
    Statistics changed = twoFrames();
    changed.record(2, {.light = "Lamp", .caster = "/Tree"}, "overdraw.fragments", 2001);
    const StatisticsComparison comparison = compareStatistics(twoFramesFile(), changed.file({}));
    const StatisticsChange* whole = find(comparison, {}, "overdraw.fragments");
    ASSERT_NE(whole, nullptr);
    EXPECT_EQ(whole->before, 3030);
    EXPECT_EQ(whole->after, 3031);
    EXPECT_DOUBLE_EQ(whole->ratio, 3031.0 / 3030.0);
    EXPECT_EQ(whole->frames, 2u);
    EXPECT_EQ(whole->framesThatDiffer, 1u);
    EXPECT_TRUE(whole->isSignificant());
    EXPECT_TRUE(find(comparison, {.light = "Lamp"}, "overdraw.fragments")->isSignificant());
    EXPECT_TRUE(find(comparison, {.caster = "/Tree"}, "overdraw.fragments")->isSignificant());
    EXPECT_FALSE(find(comparison, {.light = "Sun"}, "overdraw.fragments")->isSignificant());
    EXPECT_FALSE(find(comparison, {}, "triangles")->isSignificant());
}

TEST(StatisticsCompare, ChangesThatCancelAreChanges) {
    Statistics a, b;
    a.record(1, {}, "quads", 10);
    a.record(2, {}, "quads", 20);
    b.record(1, {}, "quads", 20);
    b.record(2, {}, "quads", 10);
    const StatisticsComparison comparison = compareStatistics(a.file({}), b.file({}));
    EXPECT_EQ(find(comparison, {}, "quads")->ratio, 1.0);
    EXPECT_EQ(find(comparison, {}, "quads")->framesThatDiffer, 2u);
    EXPECT_TRUE(find(comparison, {}, "quads")->isSignificant());
}

TEST(StatisticsCompare, DistributionsAreComparedByTheirFigures) {
    Statistics changed = twoFrames();
    changed.record(2, {}, "overdraw", distributionOf({0, 1, 1, 9}));
    const StatisticsComparison comparison = compareStatistics(twoFramesFile(), changed.file({}));
    EXPECT_EQ(find(comparison, {}, "overdraw.max")->before, 5);
    EXPECT_EQ(find(comparison, {}, "overdraw.max")->after, 9);
    EXPECT_TRUE(find(comparison, {}, "overdraw.max")->isSignificant());
    EXPECT_FALSE(find(comparison, {}, "overdraw.p50")->isSignificant());
}

/// Frames with times of 10 ms and noise of a tenth, times `factor`.
StatisticsFile timed(int frames, double factor, int seed) {
    Statistics s;
    for (int f = 1; f <= frames; ++f) s.record(f, {}, "time.frame", factor * (10 + std::sin(seed * 37.0 * f)));
    return s.file({});
}

TEST(StatisticsCompare, TimesAreMarkedOnlyWhereNoiseCannotExplainThem) {
    const auto change = [](int frames, double factor) {
        return *find(compareStatistics(timed(frames, 1.0, 1), timed(frames, factor, 2)), {}, "time.frame");
    };
    EXPECT_FALSE(change(40, 1.0).isSignificant()) << "only noise";
    const StatisticsChange slower = change(40, 1.25);
    EXPECT_TRUE(slower.isSignificant());
    EXPECT_NEAR(slower.ratio, 1.25, 0.08);
    EXPECT_LT(slower.interval->first, 1.25);
    EXPECT_GT(slower.interval->second, 1.25);
    EXPECT_TRUE(change(40, 0.75).isSignificant());
    EXPECT_FALSE(change(5, 1.25).isSignificant()) << "too few frames to know";
    EXPECT_FALSE(change(5, 1.25).interval);
}

TEST(StatisticsCompare, OnlyFramesOfBothCount) {
    Statistics a, b;
    for (const int f : {1, 2, 3}) a.record(f, {}, "quads", 10 * f);
    for (const int f : {2, 3, 4}) b.record(f, {}, "quads", 10 * f);
    const StatisticsComparison comparison = compareStatistics(a.file({}), b.file({}));
    EXPECT_EQ(find(comparison, {}, "quads")->before, 50);
    EXPECT_EQ(find(comparison, {}, "quads")->after, 50);
    EXPECT_EQ(find(comparison, {}, "quads")->frames, 2u);
    EXPECT_THAT(comparisonTable(a.file({}), b.file({})), HasSubstr("2 of 3 and 3 frames are in both."));
}

TEST(StatisticsCompare, WhatOnlyOneRunHasIsNamed) {
    Statistics a, b;
    a.record(1, {.light = "Old"}, "quads", 1);
    a.record(1, {.light = "Both"}, "quads", 1);
    b.record(1, {.light = "Both"}, "quads", 1);
    b.record(1, {.light = "New"}, "quads", 1);
    const StatisticsComparison comparison = compareStatistics(a.file({}), b.file({}));
    EXPECT_THAT(comparison.onlyBefore, ElementsAre("Old"));
    EXPECT_THAT(comparison.onlyAfter, ElementsAre("New"));
    EXPECT_THAT(comparisonTable(a.file({}), b.file({})), testing::ContainsRegex("New +only after"));
}

TEST(StatisticsCompare, FromNothingThereIsNoRatio) {
    Statistics a, b;
    a.record(1, {}, "caps.dark", 0);
    b.record(1, {}, "caps.dark", 7);
    const StatisticsComparison comparison = compareStatistics(a.file({}), b.file({}));
    EXPECT_TRUE(std::isnan(find(comparison, {}, "caps.dark")->ratio));
    EXPECT_THAT(comparisonTable(a.file({}), b.file({})), Not(HasSubstr("nan")));
}

TEST(StatisticsCompare, TheTablesMayDiffer) {
    const StatisticsFile other = parseStatistics(
        R"({"format": "umbrage statistics 1", "quantities": {},
            "counters": {"flux": {"group": "odd", "unit": "Wb", "doc": "?", "combine": "sum"},
                         "triangles": {"group": "odd", "unit": "count", "doc": "?", "combine": "largest"}},
            "frames": [{"frame": 1, "values": {"flux": 1, "triangles": 10144}},
                       {"frame": 2, "values": {"triangles": 10144}}]})",
        "other.json");
    const StatisticsComparison comparison = compareStatistics(twoFramesFile(), other);
    ASSERT_EQ(comparison.changes.size(), 1u);
    EXPECT_EQ(comparison.changes[0].name, "triangles");
    EXPECT_FALSE(comparison.changes[0].isSignificant());
}

}  // namespace
}  // namespace umbrage
