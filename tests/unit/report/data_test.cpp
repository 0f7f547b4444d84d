// SPDX-License-Identifier: Apache-2.0
// JSON and CSV for programs.
#include <gmock/gmock.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>

#include "verdicts.h"

namespace umbrage {
namespace {

using Json = nlohmann::json;

std::vector<std::vector<std::string>> plainCsv(const std::string& text) {
    std::vector<std::vector<std::string>> rows;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        std::vector<std::string>& row = rows.emplace_back();
        std::istringstream fields(line + ",");
        for (std::string field; std::getline(fields, field, ',');) row.push_back(field);
    }
    return rows;
}

TEST(VerifyJson, SaysWhatTheVerdictsHangOn) {
    VerifyHeader special = header();
    special.fault = "shifted-light";
    special.maxHard = 2;
    const Json json = Json::parse(VerifyReport(special).json({}));
    EXPECT_EQ(json["report"], "umbrage verify 1");
    EXPECT_EQ(json["version"], "0.1.0");
    EXPECT_EQ(json["device"], "A device");
    EXPECT_EQ(json["driver"], "A driver");
    EXPECT_EQ(json["command"], "umbrage verify a.yaml b.yaml");
    EXPECT_EQ(json["fault"], "shifted-light");
    EXPECT_EQ(json["maxHard"], 2);
    EXPECT_EQ(json["tolerance"]["lateralPixels"], 1.0 / 128);
    EXPECT_EQ(json["passed"], true);
    for (const char* list : {"totals", "sequences", "frames", "problems"}) EXPECT_TRUE(json[list].empty()) << list;
    EXPECT_TRUE(Json::parse(VerifyReport(header()).json({}))["fault"].is_null());
}

TEST(VerifyJson, HasSumsOfTechniquesAndSequences) {
    const Json json = Json::parse(twoSequences().json({}));
    ASSERT_EQ(json["totals"].size(), 2u);
    EXPECT_EQ(json["totals"][0]["technique"], "compute:z-pass");
    EXPECT_EQ(json["totals"][0]["frames"], 6);
    EXPECT_FALSE(json["totals"][0].contains("sequence"));
    ASSERT_EQ(json["sequences"].size(), 4u);
    const Json& row = json["sequences"][3];
    EXPECT_EQ(row["sequence"], "B1");
    EXPECT_EQ(row["claimsExact"], true);
    EXPECT_EQ(row["litFacing"], 2000);
    EXPECT_EQ(row["hard"], 1);
    EXPECT_EQ(row["hardFalseDark"], 1);
    EXPECT_EQ(row["band"], 4);
    EXPECT_EQ(row["bandRate"], 0.002);
    EXPECT_DOUBLE_EQ(row["signedBiasPixels"].get<double>(), 5.0 / 400.0);
    EXPECT_EQ(row["radianceLargest"], 0.25);
    EXPECT_EQ(row["renderMilliseconds"], 10.0);
    EXPECT_EQ(json["hardErrors"], 1);
    EXPECT_EQ(json["passed"], false);
}

TEST(VerifyJson, HasTheWrongFramesAndAllWhereAskedTo) {
    const Json json = Json::parse(twoSequences().json({}));
    ASSERT_EQ(json["frames"].size(), 1u);
    const Json& wrong = json["frames"][0];
    EXPECT_EQ(wrong["sequence"], "B1");
    EXPECT_EQ(wrong["frame"], 1);
    EXPECT_EQ(wrong["technique"], "cpu:z-fail");
    ASSERT_EQ(wrong["lights"].size(), 2u);
    EXPECT_EQ(wrong["lights"][0]["light"], "Key");
    EXPECT_EQ(wrong["lights"][0]["hard"], 1);
    EXPECT_EQ(wrong["lights"][1]["hard"], 0);
    EXPECT_EQ(Json::parse(twoSequences().json({.frames = true}))["frames"].size(), 8u);
}

TEST(VerifyJson, AFrameWithWrongCountsOnlyIsWrong) {
    VerifyReport report(header());
    LightVerdict miscounted = light("Key");
    miscounted.hardCountErrors = 1;
    report.add("A1", true, frame(1, "compute:z-pass", {miscounted}));
    EXPECT_EQ(Json::parse(report.json({}))["frames"].size(), 1u);
}

TEST(VerifyJson, AnyNameAndFigureIsJson) {
    VerifyReport report(header());
    FrameVerdict odd = frame(1, "compute:z-pass", {light("\"\\\xff\n", 1)});
    odd.radiance.largest = std::numeric_limits<double>::quiet_NaN();
    odd.radiance.rms = std::numeric_limits<double>::infinity();
    report.add("\xf0 \"quoted\"", true, odd);
    report.addProblem("\x80", "tab\there");
    const Json json = Json::parse(report.json({}));
    EXPECT_EQ(json["frames"][0]["sequence"], "\xEF\xBF\xBD \"quoted\"");
    EXPECT_EQ(json["frames"][0]["lights"][0]["light"], "\"\\\xEF\xBF\xBD\n");
    EXPECT_TRUE(json["frames"][0]["radianceLargest"].is_null());
    EXPECT_TRUE(json["sequences"][0]["radianceRms"].is_null());
    EXPECT_EQ(json["problems"][0]["message"], "tab\there");
}

TEST(VerifyCsv, IsTidy) {
    const std::vector<std::vector<std::string>> rows = plainCsv(twoSequences().csv());
    ASSERT_EQ(rows.size(), 1u + 8u * 2u);
    for (const std::vector<std::string>& row : rows) EXPECT_EQ(row.size(), rows[0].size());
    EXPECT_EQ(rows[0][0], "sequence");
    EXPECT_EQ(rows[0][4], "litFacing");
    const std::vector<std::string> first(rows[1].begin(), rows[1].begin() + 7);
    EXPECT_THAT(first, testing::ElementsAre("A1", "1", "compute:z-pass", "Key", "1000", "400", "0"));
}

TEST(VerifyCsv, HasTheFiguresThatJsonHas) {
    const std::vector<std::string> names = plainCsv(twoSequences().csv())[0];
    const Json light = Json::parse(twoSequences().json({}))["frames"][0]["lights"][0];
    for (const auto& [name, value] : light.items()) EXPECT_THAT(names, testing::Contains(name));
}

TEST(VerifyCsv, QuotesNamesAndLeavesOutWhatIsNoNumber) {
    VerifyReport report(header());
    FrameVerdict odd = frame(1, "compute:z-pass", {light("a \"b\"\nc")});
    odd.radiance = {std::numeric_limits<double>::quiet_NaN(), 0.0, 0, 0.0};
    report.add("x,y", true, odd);
    const std::string csv = report.csv();
    EXPECT_THAT(csv, testing::HasSubstr("\n\"x,y\",1,compute:z-pass,\"a \"\"b\"\"\nc\",1000,"));
    EXPECT_THAT(csv, testing::EndsWith(",0,,0.0,0,0.0,10.0,100.0\n"));
}

TEST(VerifyForms, DoNotHangOnWhichTechniqueGoesFirstThroughTheFrames) {
    VerifyReport byFrame(header()), byTechnique(header());
    const auto judged = [](int number, const char* technique) {
        return frame(number, technique, {light("Key", std::uint64_t(number)), light("Fill")});
    };
    for (const int number : {1, 2, 3}) {
        for (const char* technique : {"compute:z-pass", "cpu:z-pass"})
            byFrame.add("A1", true, judged(number, technique));
    }
    for (const char* technique : {"compute:z-pass", "cpu:z-pass"}) {
        for (const int number : {3, 1, 2}) byTechnique.add("A1", true, judged(number, technique));
    }
    for (const VerifyDetail detail : {VerifyDetail{.frames = true}, VerifyDetail{.frames = true, .lights = true}}) {
        EXPECT_EQ(byFrame.table(detail), byTechnique.table(detail));
        EXPECT_EQ(byFrame.markdown(detail), byTechnique.markdown(detail));
    }
    EXPECT_EQ(Json::parse(byFrame.json({}))["sequences"], Json::parse(byTechnique.json({}))["sequences"]);
}

}  // namespace
}  // namespace umbrage
