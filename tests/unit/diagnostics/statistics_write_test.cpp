// SPDX-License-Identifier: Apache-2.0
// The two forms of a run's numbers.
#include <gmock/gmock.h>

#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "../json_schema.h"
#include "runs.h"

namespace umbrage {
namespace {

using testing::HasSubstr;
using Json = nlohmann::ordered_json;

TEST(StatisticsCsv, IsTidy) {
    Statistics s;
    s.record(1, {}, "triangles", 10144);
    s.record(1, {}, "time.frame", 12.25);
    s.record(1, {.light = "Lamp"}, "edges.silhouette", 320);
    s.record(2, {.light = "Lamp", .caster = "/Box", .material = "oak"}, "quads", 322);
    s.record(2, {.light = "Lamp"}, "updates", distributionOf({0, 1, 1, 6}));
    EXPECT_EQ(s.file({}).csv(),
              "frame,light,caster,material,counter,unit,value\n"
              "1,,,,triangles,count,10144\n"
              "1,,,,time.frame,ms,12.25\n"
              "1,Lamp,,,edges.silhouette,count,320\n"
              "2,Lamp,,,updates.mean,updates/pixel,2\n"
              "2,Lamp,,,updates.p50,updates/pixel,1\n"
              "2,Lamp,,,updates.p95,updates/pixel,6\n"
              "2,Lamp,,,updates.p99,updates/pixel,6\n"
              "2,Lamp,,,updates.max,updates/pixel,6\n"
              "2,Lamp,/Box,oak,quads,count,322\n");
}

TEST(StatisticsCsv, QuotesNamesWithCommasAndQuotes) {
    Statistics s;
    s.record(1, {.light = "a \"key\", light", .caster = "/B,x"}, "quads", 4);
    EXPECT_THAT(s.file({}).csv(), HasSubstr("1,\"a \"\"key\"\", light\",\"/B,x\",,quads,count,4\n"));
}

TEST(Statistics, OrderOfRecordingChangesNothing) {
    Statistics backwards;
    backwards.record(2, {.light = "Lamp"}, "edges.silhouette", 322);
    backwards.record(1, {.light = "Lamp"}, "edges.silhouette", 320);
    backwards.record(1, {}, "triangles", 10144);
    Statistics forwards;
    forwards.record(1, {}, "triangles", 10144);
    forwards.record(1, {.light = "Lamp"}, "edges.silhouette", 320);
    forwards.record(2, {.light = "Lamp"}, "edges.silhouette", 322);
    EXPECT_EQ(backwards.file({}).csv(), forwards.file({}).csv());
    EXPECT_EQ(backwards.file({}).json(), forwards.file({}).json());
}

TEST(Statistics, ALaterValueReplacesAnEarlierOne) {
    Statistics s;
    s.record(1, {}, "triangles", 10144);
    s.record(1, {}, "triangles", 7);
    s.record(1, {}, "overdraw", distributionOf({1}));
    s.record(1, {}, "overdraw", distributionOf({2}));
    EXPECT_THAT(s.file({}).csv(), HasSubstr("1,,,,triangles,count,7\n"));
    EXPECT_THAT(s.file({}).csv(), HasSubstr("overdraw.max,fragments/pixel,2\n"));
    EXPECT_THAT(s.file({}).csv(), Not(HasSubstr("10144")));
}

TEST(Statistics, LargeCountsKeepAllTheirDigits) {
    Statistics s;
    s.record(1, {}, "overdraw.fragments", 123456789012.0);
    EXPECT_THAT(s.file({}).csv(), HasSubstr(",123456789012\n"));
    EXPECT_THAT(s.file({}).json(), HasSubstr("{\"overdraw.fragments\":123456789012}"));
}

TEST(StatisticsJson, NestsFramesLightsAndCastersAndExplainsItsTerms) {
    const Json json = Json::parse(twoFramesFile().json());
    EXPECT_EQ(json["sequence"], "courtyard.yaml");
    EXPECT_EQ(json["device"], "llvmpipe");
    EXPECT_EQ(json["counters"].size(), kCounters.size());
    EXPECT_EQ(json["counters"]["time.frame"]["unit"], "ms");
    EXPECT_EQ(json["counters"]["time.frame"]["group"], "time");
    EXPECT_EQ(json["counters"]["scene.overdraw"]["ratio"], Json({"scene.shaded", "scene.covered"}));
    EXPECT_EQ(json["quantities"]["overdraw"]["aov"], "overdraw.fragments");
    ASSERT_EQ(json["frames"].size(), 2u);
    const Json& frame = json["frames"][0];
    EXPECT_EQ(frame["frame"], 1);
    EXPECT_EQ(frame["values"]["triangles"], 10144);
    EXPECT_TRUE(frame["values"]["triangles"].is_number_integer());
    EXPECT_EQ(frame["values"]["time.frame"], 12.25);
    EXPECT_EQ(frame["lights"]["Lamp"]["values"]["edges.silhouette"], 320);
    EXPECT_EQ(frame["lights"]["Lamp"]["casters"]["/Tree"]["values"]["overdraw.fragments"], 1000);
    EXPECT_EQ(frame["lights"]["Sun"]["values"], Json::object());
    EXPECT_EQ(frame["materials"]["bark"]["values"]["scene.shaded"], 50);
    EXPECT_EQ(frame["distributions"]["overdraw"],
              Json::parse(R"({"pixels": 4, "sum": 4.5, "mean": 1.125, "p50": 1, "p95": 2, "p99": 2, "max": 2.5,
                              "histogram": [[0, 1], [1, 2], [2, 1]]})"));
}

TEST(StatisticsJson, SummaryHasTotalsMeansAndLargestValues) {
    const Json summary = Json::parse(twoFramesFile().json())["summary"];
    EXPECT_EQ(summary["frames"], 2);
    EXPECT_EQ(summary["values"]["time.frame"],
              Json::parse(R"({"total": 36.75, "mean": 18.375, "max": 24.5, "maxFrame": 2})"));
    EXPECT_EQ(summary["values"]["triangles"], Json::parse(R"({"mean": 10144, "max": 10144, "maxFrame": 1})"));
    EXPECT_EQ(summary["lights"]["Lamp"]["distributions"]["stencil"]["pixels"], 6);
    EXPECT_EQ(summary["casters"]["/Box"]["values"]["overdraw.fragments"]["total"], 30);
    EXPECT_EQ(summary["materials"]["bark"]["values"]["scene.shaded"]["total"], 100);
    EXPECT_EQ(summary["topCasters"][0]["caster"], "/Tree");
    EXPECT_EQ(summary["topCasters"][0]["overdraw.fragments"], 3000);
}

TEST(StatisticsJson, OfNothingHasTablesAndNoFrames) {
    const Json json = Json::parse(Statistics().file({}).json());
    EXPECT_EQ(json["frames"], Json::array());
    EXPECT_EQ(json["counters"].size(), kCounters.size());
}

TEST(StatisticsJson, SurvivesALightNameThatIsNotUtf8) {
    Statistics s;
    s.record(1, {.light = "bad\xff"}, "quads", 4);
    EXPECT_NO_THROW(Json::parse(s.file({}).json()));
}

TEST(StatisticsSchema, AcceptsWhatIsWritten) {
    const Json schema = Json::parse(statisticsSchema());
    EXPECT_TRUE(validates(schema, Json::parse(twoFramesFile().json())));
}

TEST(StatisticsSchema, RefusesWhatIsNot) {
    const Json schema = Json::parse(statisticsSchema());
    const Json good = Json::parse(twoFramesFile().json());
    const auto refused = [&](const char* pointer, const Json& value) {
        Json bad = good;
        bad[Json::json_pointer(pointer)] = value;
        EXPECT_FALSE(validates(schema, bad)) << pointer << " = " << value;
    };
    refused("/format", "umbrage statistics 2");
    refused("/clock", 3);
    refused("/frames/0/frame", 1.5);
    refused("/frames/0/values/triangles", "many");
    refused("/frames/0/values/trinagles", 3);
    refused("/frames/0/lights/Lamp/casters/~1Box/frame", 3);
    refused("/frames/0/distributions/overdraw/histogram/0", Json({1, 2, 3}));
    refused("/frames/0/distributions/overdraw/histogram/0/1", 0.5);
    refused("/summary/values/triangles/maxFrame", Json());
    Json bad = good;
    bad["frames"][0].erase("values");
    EXPECT_FALSE(validates(schema, bad));
}

TEST(StatisticsReference, IsTheCommittedPage) {
    std::ifstream file(std::string(UMBRAGE_SOURCE_DIR) + "/docs/statistics.md");
    const std::string committed{std::istreambuf_iterator<char>(file), {}};
    EXPECT_TRUE(committed == statisticsReference())
        << "docs/statistics.md is out of date; build/umbrage schema --statistics --markdown > docs/statistics.md";
}

}  // namespace
}  // namespace umbrage
