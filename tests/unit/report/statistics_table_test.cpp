// SPDX-License-Identifier: Apache-2.0
#include "report/statistics_table.h"

#include <gmock/gmock.h>

#include "../diagnostics/runs.h"

namespace umbrage {
namespace {

using testing::HasSubstr;

TEST(ReadableNumber, GroupsDigitsAndShortensFractions) {
    EXPECT_EQ(readableNumber(0), "0");
    EXPECT_EQ(readableNumber(999), "999");
    EXPECT_EQ(readableNumber(1000), "1,000");
    EXPECT_EQ(readableNumber(123456789012.0), "123,456,789,012");
    EXPECT_EQ(readableNumber(-1234567), "-1,234,567");
    EXPECT_EQ(readableNumber(-123), "-123");
    EXPECT_EQ(readableNumber(1.23456), "1.235");
    EXPECT_EQ(readableNumber(12.3456), "12.35");
    EXPECT_EQ(readableNumber(123.456), "123.5");
    EXPECT_EQ(readableNumber(1234.56), "1,235");
    EXPECT_EQ(readableNumber(0.00001234), "1.23e-05");
    EXPECT_EQ(readableNumber(1e20), "1e+20");
}

TEST(StatisticsTable, HasGroupsLightsDistributionsAndCasters) {
    EXPECT_EQ(statisticsTable(twoFramesFile()),
              "sequence: courtyard.yaml; version: 0.1.0; device: llvmpipe; clock: wall clock between glFinish calls; "
              "frames: 1,2\n"
              "\n"
              "scene                 total    mean  largest  in frame  unit\n"
              "  scene.shaded          450     225      300         2  count\n"
              "  scene.covered         200     100      100         1  pixels\n"
              "  scene.overdraw              2.250        3         2  fragments/pixel\n"
              "\n"
              "casters               total    mean  largest  in frame  unit\n"
              "  triangles                  10,144   10,144         1  count\n"
              "  edges.silhouette      641   320.5      321         2  count\n"
              "\n"
              "fill                  total    mean  largest  in frame  unit\n"
              "  overdraw.fragments  3,030   1,515    2,015         2  count\n"
              "\n"
              "time                  total    mean  largest  in frame  unit\n"
              "  time.frame          36.75   18.38    24.50         2  ms\n"
              "\n"
              "light Lamp            total    mean  largest  in frame  unit\n"
              "  edges.silhouette      641   320.5      321         2  count\n"
              "  overdraw.fragments  3,020   1,510    2,010         2  count\n"
              "\n"
              "light Sun             total    mean  largest  in frame  unit\n"
              "  overdraw.fragments     10       5        5         1  count\n"
              "\n"
              "pixels              mean  p50  p95  p99  max  unit\n"
              "  overdraw  frame  1.438    1    5    5    5  fragments/pixel\n"
              "  stencil   Lamp   0.333    0    1    1    1  volumes/pixel\n"
              "\n"
              "casters with most fill  overdraw.fragments   share\n"
              "  /Tree                              3,000  99.0 %\n"
              "  /Box                                  30   1.0 %\n");
}

TEST(StatisticsTable, OfNothingIsItsHead) {
    EXPECT_EQ(statisticsTable(Statistics().file({{"sequence", "a.yaml"}})), "sequence: a.yaml; frames: none\n");
}

TEST(StatisticsTable, NamesCannotMoveTheCursor) {
    Statistics s;
    s.record(1, {.light = "a\x1b[2J\nb"}, "quads", 4);
    EXPECT_THAT(statisticsTable(s.file({{"device", "x\ty"}})), HasSubstr("light a?[2J?b"));
    EXPECT_THAT(statisticsTable(s.file({{"device", "x\ty"}})), HasSubstr("device: x?y"));
}

}  // namespace
}  // namespace umbrage
