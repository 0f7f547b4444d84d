// SPDX-License-Identifier: Apache-2.0
// The JSON form: written, by its schema, and read back.
#include <gmock/gmock.h>

#include <filesystem>

#include "../json_schema.h"
#include "comparisons.h"
#include "error.h"
#include "golden/reports.h"

namespace umbrage {
namespace {

using Json = nlohmann::ordered_json;
using testing::HasSubstr;

TEST(ComparisonJson, ComesBackAsItWas) {
    const Comparison before = everyOutcome();
    const std::string text = comparisonJson(before);
    const Comparison after = readComparison(text, "c.json");
    EXPECT_EQ(comparisonJson(after), text);
    EXPECT_EQ(after.golden, before.golden);
    EXPECT_EQ(after.outputFrom->processor, "avx512");
    EXPECT_TRUE(after.foreignDevice);
    EXPECT_EQ(after.notes, before.notes);
    ASSERT_EQ(after.images.size(), kOutcomes.size());
    for (std::size_t o = 0; o < kOutcomes.size(); ++o) EXPECT_EQ(after.images[o].outcome, Outcome(o));
    const ImageResult& fail = after.images[std::size_t(Outcome::Fail)];
    EXPECT_EQ(fail.decision->value, 0.7000000000000001);
    EXPECT_EQ(fail.decision->rule, "shadows");
    EXPECT_EQ(fail.worst, std::pair(3, 2));
    EXPECT_EQ(fail.reason, before.images[std::size_t(Outcome::Fail)].reason);
    EXPECT_EQ(after.images[0].worst, std::pair(-1, -1));
    EXPECT_EQ(after.images[0].figures[1].metric, "psnr");
    EXPECT_EQ(after.images[0].figures[1].value, std::numeric_limits<double>::infinity());
    EXPECT_FALSE(after.images[std::size_t(Outcome::MissingOutput)].decision);
    EXPECT_EQ(after.statistics[0].output, 125.5);
    EXPECT_EQ(after.statistics[0].frame, 3);
    EXPECT_EQ(after.budgets, before.budgets);
    EXPECT_EQ(after.acceptCommand, before.acceptCommand);
}

TEST(ComparisonJson, HasNumbersInTheirShortestFormAndNullForInfinity) {
    const std::string text = comparisonJson(everyOutcome());
    EXPECT_THAT(text, HasSubstr("\"limit\": 0.004"));
    EXPECT_THAT(text, HasSubstr("\"value\": 0.7000000000000001"));
    EXPECT_THAT(text, HasSubstr("\"golden\": 100,"));
    EXPECT_THAT(text, HasSubstr("\"psnr\": null"));
}

TEST(ComparisonJson, HasBudgetsAsStatisticsFilesDoAndTheirUnits) {
    const Json json = Json::parse(comparisonJson(everyOutcome()));
    EXPECT_EQ(json["budgets"][0], Json::parse(R"({"name": "overdraw.p95", "max": 6, "value": 7.25, "frame": 12,
                                                  "exceeded": true, "unit": "fragments/pixel"})"));
    EXPECT_EQ(json["budgets"][1], Json::parse(R"({"name": "triangles", "min": 456, "value": 456, "frame": 1,
                                                  "exceeded": false, "unit": "count"})"));
    EXPECT_EQ(json["budgets"][2],
              Json::parse(R"({"name": "caps.dark", "max": 2.5, "exceeded": true, "unit": "count"})"));
    EXPECT_EQ(json["budgets"][3]["light"], "Lamp, <left>");
    EXPECT_FALSE(Json::parse(comparisonJson(sequence(1))).contains("budgets"));

    const Json over = Json::parse(comparisonJson(overBudget()));
    EXPECT_EQ(over["passes"], false);
    EXPECT_EQ(over["counts"], Json::parse(R"({"pass": 61, "fail": 1})"));
}

TEST(ComparisonJson, KeepsItsSchema) {
    const Json schema = Json::parse(comparisonSchema());
    EXPECT_EQ(schema["$schema"], "https://json-schema.org/draft/2020-12/schema");
    const Json good = Json::parse(comparisonJson(everyOutcome()));
    EXPECT_TRUE(validates(schema, good));
    EXPECT_TRUE(validates(schema, Json::parse(comparisonJson(Comparison{}))));
    const auto broken = [&](const char* pointer, const Json& value) {
        Json json = good;
        json[Json::json_pointer(pointer)] = value;
        return json;
    };
    for (const Json& bad :
         {broken("/passes", 1), broken("/images/0/outcome", "passes"), broken("/images/4/worst", {1, 2, 3}),
          broken("/images/4/decision/rule", nullptr), broken("/images/0/figures/max-abs", "0"), broken("/other", 1),
          broken("/budgets/0/min", 1), broken("/budgets/0/unit", 1), broken("/budgets/0/exceeded", "yes")}) {
        EXPECT_FALSE(validates(schema, bad));
    }
}

TEST(ComparisonJson, RefusesWhatTheWriterWouldNotWrite) {
    const Json good = Json::parse(comparisonJson(everyOutcome()));
    const auto message = [&](const char* pointer, const Json& value) -> std::string {
        Json json = good;
        json[Json::json_pointer(pointer)] = value;
        try {
            readComparison(json.dump(), "c.json");
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::Input);
            return error.what();
        }
        return "nothing";
    };
    EXPECT_EQ(message("/images/4/outcome", "fial"),
              "c.json: /images/4/outcome: there is no outcome \"fial\" (did you mean \"fail\"?)");
    EXPECT_THAT(message("/format", "umbrage comparison 9"),
                HasSubstr("c.json: /format: must be \"umbrage comparison 1\""));
    EXPECT_THAT(message("/images/4/worst", {1}), HasSubstr("/images/4/worst: must be a pair"));
    EXPECT_THAT(message("/images/0/width", -1), HasSubstr("/images/0/width: must not be negative"));
    EXPECT_THAT(message("/images/0/frame", 1.5), HasSubstr("must be a whole number"));
    EXPECT_THAT(message("/budgets/0/min", 1), HasSubstr("/budgets/0: has both \"min\" and \"max\""));
    EXPECT_THAT(message("/budgets/2/value", 1), HasSubstr("/budgets/2: has a value, but of no frame"));
    EXPECT_THAT(message("/budgets/1/unit", 1), HasSubstr("/budgets/1/unit: must be a string"));
    EXPECT_THAT(message("/passes", true), HasSubstr("/passes: contradicts the outcomes"));
    EXPECT_THROW(readComparison("{\"format\":", "c.json"), Error);
    EXPECT_THROW(readComparison("[]", "c.json"), Error);
}

TEST(ComparisonJson, FoldersAreSeenFromTheReport) {
    Comparison comparison;
    comparison.golden = "tests/golden/a";
    comparison.output = "out/a";
    const Comparison near = relativeTo("out/report", comparison);
    EXPECT_EQ(near.golden, "../../tests/golden/a");
    EXPECT_EQ(near.output, "../a");
    comparison.output = (std::filesystem::current_path() / "out/a").string();
    EXPECT_EQ(relativeTo("", comparison).output, "out/a");
}

TEST(ComparisonJson, NamesThatAreNoTextAreReplaced) {
    Comparison comparison;
    comparison.images.emplace_back().name = "bad\xff.png";
    EXPECT_EQ(readComparison(comparisonJson(comparison), "c.json").images[0].name, "bad\xef\xbf\xbd.png");
}

TEST(Comparison, PassesWhenAllOutcomesDo) {
    Comparison comparison;
    EXPECT_TRUE(comparison.passes());
    for (std::size_t o = 0; o < kOutcomes.size(); ++o) {
        comparison.images.assign(1, {});
        comparison.images[0].outcome = Outcome(o);
        EXPECT_EQ(comparison.passes(), o <= std::size_t(Outcome::ExpectedFailure)) << kOutcomes[o].name;
    }
    comparison.images.clear();
    comparison.statistics.push_back({"triangles", 0, Outcome::Fail});
    EXPECT_FALSE(comparison.passes());
    comparison.statistics.clear();
    comparison.budgets = {overBudget().budgets[1]};
    EXPECT_TRUE(comparison.passes());
    comparison.budgets = overBudget().budgets;
    EXPECT_FALSE(comparison.passes());
}

}  // namespace
}  // namespace umbrage
