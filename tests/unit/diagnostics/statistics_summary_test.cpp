// SPDX-License-Identifier: Apache-2.0
// Parts add up to wholes, frames to the sequence.
#include "diagnostics/statistics_summary.h"

#include <gmock/gmock.h>

#include "runs.h"

namespace umbrage {
namespace {

std::size_t at(Counter counter) {
    return counter.index();
}

TEST(StatisticsSummary, WholesAreTheSumsOfTheirParts) {
    const StatisticsFile file = twoFramesFile();
    const FrameFigures frame = withWholes(file, file.frames.at(2));
    EXPECT_EQ(frame.at({.light = "Lamp"}).values.at(at("overdraw.fragments")), 2010);
    EXPECT_EQ(frame.at({.light = "Sun"}).values.at(at("overdraw.fragments")), 5);
    EXPECT_EQ(frame.at({.caster = "/Box"}).values.at(at("overdraw.fragments")), 15);
    EXPECT_EQ(frame.at({}).values.at(at("overdraw.fragments")), 2015);
    EXPECT_EQ(frame.at({}).values.at(at("edges.silhouette")), 321);
}

TEST(StatisticsSummary, WhatWasRecordedStays) {
    Statistics s;
    s.record(1, {}, "quads", 100);
    s.record(1, {.light = "Lamp"}, "quads", 3);
    s.record(1, {.caster = "/Box"}, "quads", 4);
    const FrameFigures frame = withWholes(s.file({}), s.file({}).frames.at(1));
    EXPECT_EQ(frame.at({}).values.at(at("quads")), 100);
}

TEST(StatisticsSummary, LightsComeBeforeCastersWhereBothHaveParts) {
    Statistics s;
    s.record(1, {.light = "Lamp"}, "quads", 3);
    s.record(1, {.light = "Sun"}, "quads", 5);
    s.record(1, {.caster = "/Box"}, "quads", 7);
    const FrameFigures frame = withWholes(s.file({}), s.file({}).frames.at(1));
    EXPECT_EQ(frame.at({}).values.at(at("quads")), 8);
}

TEST(StatisticsSummary, OfPartsTheTableSaysHowTheyCombine) {
    Statistics s;
    for (const double i : {1.0, 2.0}) {
        const StatisticsPlace part{.material = std::to_string(i)};
        s.record(1, part, "scene.shaded", 30 * i);
        s.record(1, part, "scene.covered", 20);
        s.record(1, part, "scene.overdraw", 1.5 * i);
        s.record(1, part, "memory.device", 8 * i);
        s.record(1, part, "overdraw.depthComplexity", i);
    }
    const FrameFigures frame = withWholes(s.file({}), s.file({}).frames.at(1));
    const auto& whole = frame.at({}).values;
    EXPECT_EQ(whole.at(at("scene.shaded")), 90);
    EXPECT_EQ(whole.at(at("memory.device")), 16);
    EXPECT_EQ(whole.at(at("scene.overdraw")), 90.0 / 40.0) << "not 1.5 + 3, nor their mean";
    EXPECT_FALSE(whole.contains(at("overdraw.depthComplexity")))
        << "what its parts are divided by is no counter, so the whole's cannot be known";
}

TEST(StatisticsSummary, FramesAddUp) {
    const StatisticsSummary summary = summaryOf(twoFramesFile());
    EXPECT_EQ(summary.frames, 2u);
    const PlaceSummary& whole = summary.places.at({});
    const CounterSummary& fragments = whole.values.at(at("overdraw.fragments"));
    EXPECT_EQ(fragments.total, 1015 + 2015);
    EXPECT_EQ(fragments.mean, 1515);
    EXPECT_EQ(fragments.max, 2015);
    EXPECT_EQ(fragments.maxFrame, 2);
    EXPECT_EQ(whole.values.at(at("scene.overdraw")).mean, (150.0 + 300.0) / 200.0);
    EXPECT_EQ(whole.distributions.at(Quantity("overdraw").index()), distributionOf({0, 1, 1, 2.5, 0, 1, 1, 5}));
}

TEST(StatisticsSummary, MeansAreOverTheFramesThatHaveTheValue) {
    Statistics s;
    s.record(1, {}, "triangles", 4);
    s.record(2, {}, "triangles", 4);
    s.record(2, {.light = "Lamp"}, "quads", 6);
    s.record(2, {}, "overdraw.depthComplexity", 3);
    const StatisticsSummary summary = summaryOf(s.file({}));
    EXPECT_EQ(summary.places.at({.light = "Lamp"}).values.at(at("quads")).mean, 6);
    EXPECT_EQ(summary.places.at({}).values.at(at("triangles")).mean, 4);
    EXPECT_EQ(summary.places.at({}).values.at(at("overdraw.depthComplexity")).mean, 3);
}

TEST(StatisticsSummary, NegativeNumbersHaveALargestToo) {
    Statistics s;
    s.record(1, {}, "count.net", -7);
    s.record(2, {}, "count.net", -5);
    const StatisticsSummary summary = summaryOf(s.file({}));
    EXPECT_EQ(summary.places.at({}).values.at(at("count.net")).max, -5);
    EXPECT_EQ(summary.places.at({}).values.at(at("count.net")).maxFrame, 2);
}

TEST(StatisticsSummary, TopCastersAreTheTenWithMostFragments) {
    Statistics s;
    for (int i = 0; i < 25; ++i) {
        const StatisticsPlace place{.light = "Lamp", .caster = "/C" + std::to_string(i)};
        s.record(1, place, "overdraw.fragments", i);
        s.record(2, place, "overdraw.fragments", i);
    }
    const StatisticsSummary summary = summaryOf(s.file({}));
    ASSERT_EQ(summary.topCasters.size(), kMostTopCasters);
    EXPECT_EQ(summary.topCasters[0].caster, "/C24");
    EXPECT_EQ(summary.topCasters[0].value, 48);
    EXPECT_DOUBLE_EQ(summary.topCasters[0].share, 24.0 / 300.0);
    EXPECT_EQ(summary.topCasters[9].caster, "/C15");
}

TEST(StatisticsSummary, ThereAreNoTopCastersWithoutFill) {
    Statistics s;
    s.record(1, {.light = "Lamp", .caster = "/Box"}, "overdraw.fragments", 0);
    EXPECT_TRUE(summaryOf(s.file({})).topCasters.empty());
    EXPECT_TRUE(summaryOf(Statistics().file({})).topCasters.empty());
}

}  // namespace
}  // namespace umbrage
