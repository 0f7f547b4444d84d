// SPDX-License-Identifier: Apache-2.0
#include "diagnostics/statistics.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <set>

namespace umbrage {
namespace {

using testing::HasSubstr;

Statistics twoFrames() {
    Statistics statistics;
    statistics.record(1, "", "triangles", 10144);
    statistics.record(1, "", "time.frame", 12.25);
    statistics.record(1, "Lamp", "edges.silhouette", 320);
    statistics.record(2, "Lamp", "edges.silhouette", 322);
    return statistics;
}

TEST(Counters, HaveUniqueNamesUnitsAndDocumentation) {
    std::set<std::string_view> names;
    for (const CounterInfo& counter : kCounters) {
        EXPECT_TRUE(names.insert(counter.name).second) << counter.name;
        EXPECT_FALSE(counter.unit.empty()) << counter.name;
        EXPECT_FALSE(counter.doc.empty()) << counter.name;
    }
}

TEST(Counters, AreFoundByNameWhileCompiling) {
    constexpr Counter counter = "overdraw.updates";
    static_assert(counter.info().name == "overdraw.updates");
    EXPECT_EQ(counter.info().unit, "count");
}

TEST(Statistics, CsvIsTidy) {
    EXPECT_EQ(twoFrames().csv(),
              "frame,light,counter,unit,value\n"
              "1,,triangles,count,10144\n"
              "1,,time.frame,ms,12.25\n"
              "1,Lamp,edges.silhouette,count,320\n"
              "2,Lamp,edges.silhouette,count,322\n");
}

TEST(Statistics, OrderOfRecordingChangesNothing) {
    Statistics backwards;
    backwards.record(2, "Lamp", "edges.silhouette", 322);
    backwards.record(1, "Lamp", "edges.silhouette", 320);
    backwards.record(1, "", "time.frame", 12.25);
    backwards.record(1, "", "triangles", 10144);
    EXPECT_EQ(backwards.csv(), twoFrames().csv());
    EXPECT_EQ(backwards.json({}), twoFrames().json({}));
}

TEST(Statistics, ALaterValueReplacesAnEarlierOne) {
    Statistics statistics = twoFrames();
    statistics.record(1, "", "triangles", 7);
    EXPECT_THAT(statistics.csv(), HasSubstr("1,,triangles,count,7\n"));
    EXPECT_THAT(statistics.csv(), Not(HasSubstr("10144")));
}

TEST(Statistics, CsvQuotesLightsWithCommasAndQuotes) {
    Statistics statistics;
    statistics.record(1, "a \"key\", light", "quads", 4);
    EXPECT_THAT(statistics.csv(), HasSubstr("1,\"a \"\"key\"\", light\",quads,count,4\n"));
}

TEST(Statistics, LargeCountsKeepAllTheirDigits) {
    Statistics statistics;
    statistics.record(1, "", "overdraw.fragments", 123456789012.0);
    EXPECT_THAT(statistics.csv(), HasSubstr(",123456789012\n"));
    EXPECT_THAT(statistics.json({}), HasSubstr("\"overdraw.fragments\": 123456789012\n"));
}

TEST(Statistics, JsonNestsFramesLightsAndValuesAndExplainsCounters) {
    const auto document =
        nlohmann::json::parse(twoFrames().json({{"sequence", "courtyard.yaml"}, {"device", "llvmpipe"}}));
    EXPECT_EQ(document["sequence"], "courtyard.yaml");
    EXPECT_EQ(document["device"], "llvmpipe");
    EXPECT_EQ(document["counters"].size(), kCounters.size());
    EXPECT_EQ(document["counters"]["time.frame"]["unit"], "ms");
    ASSERT_EQ(document["frames"].size(), 2u);
    EXPECT_EQ(document["frames"][0]["frame"], 1);
    EXPECT_EQ(document["frames"][0]["values"]["triangles"], 10144);
    EXPECT_TRUE(document["frames"][0]["values"]["triangles"].is_number_integer());
    EXPECT_EQ(document["frames"][0]["values"]["time.frame"], 12.25);
    EXPECT_EQ(document["frames"][0]["lights"]["Lamp"]["edges.silhouette"], 320);
    EXPECT_TRUE(document["frames"][1]["values"].empty());
}

TEST(Statistics, JsonOfNothingHasCountersAndNoFrames) {
    const auto document = nlohmann::json::parse(Statistics().json({}));
    EXPECT_TRUE(document["frames"].is_array());
    EXPECT_TRUE(document["frames"].empty());
}

TEST(Statistics, JsonSurvivesALightNameThatIsNotUtf8) {
    Statistics statistics;
    statistics.record(1, "bad\xff", "quads", 4);
    EXPECT_NO_THROW(nlohmann::json::parse(statistics.json({})));
}

TEST(PeakMemory, CoversWhatWasTouched) {
    const std::vector<char> touched(64 << 20, 1);
    EXPECT_GE(peakHostMemoryMebibytes(), 64.0) << touched.back();
}

}  // namespace
}  // namespace umbrage
