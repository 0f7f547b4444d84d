// SPDX-License-Identifier: Apache-2.0
// JUnit XML, CSV, annotations and Markdown of a comparison with every outcome.
#include "golden/reports.h"

#include <gmock/gmock.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <pugixml.hpp>
#include <sstream>

#include "comparisons.h"
#include "golden/result_text.h"
#include "job/golden_rules.h"

namespace umbrage {
namespace {

using testing::HasSubstr;
using testing::Not;

std::vector<std::string> linesOf(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

pugi::xml_document parsed(const std::string& xml) {
    pugi::xml_document document;
    const pugi::xml_parse_result result = document.load_string(xml.c_str());
    EXPECT_TRUE(result) << result.description() << "\n" << xml;
    return document;
}

/// xmllint's exit code.
int validated(const std::string& xml) {
    const auto file = std::filesystem::temp_directory_path() / "umbrage_junit_test.xml";
    std::ofstream(file) << xml;
    const std::string schema = std::string(UMBRAGE_SOURCE_DIR) + "/tests/unit/golden/junit.xsd";
    const int status =
        std::system(("xmllint --noout --schema '" + schema + "' '" + file.string() + "' >/dev/null 2>&1").c_str());
    std::filesystem::remove(file);
    return WEXITSTATUS(status);
}

TEST(ComparisonJunit, IsValidByTheCommonSchema) {
    if (validated("<testsuites/>") == 127) GTEST_SKIP() << "there is no xmllint here";
    ASSERT_EQ(validated("<testsuites/>"), 0);
    ASSERT_NE(validated("<testsuites><testsuite name=\"a\"/></testsuites>"), 0) << "the schema refuses nothing";
    EXPECT_EQ(validated(comparisonJunit(everyOutcome())), 0) << comparisonJunit(everyOutcome());
    EXPECT_EQ(validated(comparisonJunit(sequence(48))), 0);
    EXPECT_EQ(validated(comparisonJunit({})), 0);
    Comparison odd;
    odd.images.emplace_back().name = "not text \xff, control \x01 and a very odd ]]> <!-- name";
    EXPECT_EQ(validated(comparisonJunit(odd)), 0) << comparisonJunit(odd);
}

TEST(ComparisonJunit, HasACaseForEachImageColumnAndBudget) {
    const pugi::xml_document document = parsed(comparisonJunit(everyOutcome()));
    const pugi::xml_node all = document.child("testsuites");
    EXPECT_EQ(all.attribute("tests").as_int(), 19);
    EXPECT_EQ(all.attribute("failures").as_int(), 12) << "eight images, a column and three budgets";
    EXPECT_EQ(all.attribute("errors").as_int(), 1);
    const pugi::xml_node beauty = all.find_child_by_attribute("testsuite", "name", "beauty");
    EXPECT_EQ(beauty.attribute("tests").as_int(), 12);
    EXPECT_EQ(beauty.attribute("skipped").as_int(), 2);
    const auto testcase = [&](const char* suite, const char* name) {
        return all.find_child_by_attribute("testsuite", "name", suite)
            .find_child_by_attribute("testcase", "name", name);
    };
    const pugi::xml_node fail = testcase("beauty", "beauty/fail.0001.png");
    EXPECT_STREQ(fail.attribute("classname").value(), "golden.beauty");
    EXPECT_STREQ(fail.child("failure").attribute("type").value(), "fail");
    EXPECT_STREQ(fail.child("failure").attribute("message").value(),
                 "fail: more than the limit:?50%, <a> & \"b\" (shadows: max-abs 0.7 is over 0.004)");
    EXPECT_TRUE(testcase("beauty", "beauty/pass.0001.png"));
    EXPECT_FALSE(testcase("beauty", "beauty/pass.0001.png").first_child());
    EXPECT_STREQ(testcase("beauty", "beauty/warn.0001.png").child("system-out").text().get(),
                 "warn: near: psnr 39.5 is under 40");
    EXPECT_STREQ(testcase("beauty", "beauty/skipped.0001.png").child("skipped").attribute("message").value(),
                 "skipped: noise is skipped by \"noise*\"");
    EXPECT_TRUE(testcase("beauty", "beauty/expected-failure.0001.png").child("skipped"));
    EXPECT_TRUE(testcase("beauty", "beauty/unreadable.0001.png").child("error"));
    for (const char* outcome :
         {"unexpected-pass", "missing-output", "missing-golden", "size-mismatch", "channel-mismatch", "non-finite"}) {
        EXPECT_STREQ(testcase("beauty", ("beauty/" + std::string(outcome) + ".0001.png").c_str())
                         .child("failure")
                         .attribute("type")
                         .value(),
                     outcome);
    }
    EXPECT_TRUE(testcase("images", "odd, ]]> name%::file.png").child("failure"));
    EXPECT_STREQ(
        testcase("statistics", "overdraw.fragments Lamp frame 3").child("failure").attribute("message").value(),
        "fail: 125.5 instead of 100 in frame 3, tolerance 0.01");
    const pugi::xml_node budgets = all.find_child_by_attribute("testsuite", "name", "budgets");
    EXPECT_EQ(budgets.attribute("tests").as_int(), 4);
    EXPECT_EQ(budgets.attribute("failures").as_int(), 3);
    const auto broken = [&](const char* name) {
        return std::string(testcase("budgets", name).child("failure").attribute("message").value());
    };
    EXPECT_EQ(broken("overdraw.p95 max"),
              "fail: overdraw.p95 is 7.250 fragments/pixel in frame 12, 1.250 (20.8 %) over the budget of 6");
    EXPECT_EQ(broken("caps.dark max"),
              "fail: caps.dark has no value in any frame, so nothing says that it is at most 2.500");
    EXPECT_EQ(broken("stencil.max max"),
              "fail: stencil.max is 3 layers in frame 1, light Lamp, <left>, 1 (50.0 %) over the budget of 2");
    EXPECT_STREQ(testcase("budgets", "triangles min").attribute("classname").value(), "golden.budgets");
    EXPECT_FALSE(testcase("budgets", "triangles min").first_child());
    EXPECT_THAT(comparisonJunit(everyOutcome()), Not(HasSubstr("time")));
}

TEST(ComparisonCsv, HasARowForEachImageAndBudgetAndAColumnForEachFigure) {
    const std::vector<std::string> lines = linesOf(comparisonCsv(everyOutcome()));
    ASSERT_GT(lines.size(), kOutcomes.size());
    EXPECT_EQ(lines[0], "name,aov,frame,outcome,rule,metric,limit,value,reason,max-abs,psnr,flip");
    EXPECT_EQ(lines[1], "beauty/pass.0001.png,beauty,1,pass,default,max-abs,0.004,0,,0,inf,");
    EXPECT_EQ(lines[2], "beauty/warn.0001.png,beauty,1,warn,near,psnr,40,39.5,,,,");
    EXPECT_EQ(lines[3], "beauty/skipped.0001.png,beauty,1,skipped,,,,,\"noise is skipped by \"\"noise*\"\"\",,,");
    // a field with a line end is two lines of the file
    EXPECT_EQ(lines[5],
              "beauty/fail.0001.png,beauty,1,fail,shadows,max-abs,0.004,0.7000000000000001,\"more than the limit:");
    EXPECT_EQ(lines[6], "50%, <a> & \"\"b\"\"\",0.7000000000000001,24.25,0.1");
    EXPECT_EQ(lines[10], "\"odd, ]]> name%::file.png\",,1,extra-output,,,,,,,,");
    ASSERT_EQ(lines.size(), 1 + kOutcomes.size() + 1 + 4);
    EXPECT_EQ(lines[15],
              "budget overdraw.p95,,12,fail,max,overdraw.p95,6,7.25,\"overdraw.p95 is 7.250 fragments/pixel in frame "
              "12, 1.250 (20.8 %) over the budget of 6\",,,");
    EXPECT_EQ(lines[16], "budget triangles,,1,pass,min,triangles,456,456,,,,");
    EXPECT_EQ(lines[17],
              "budget caps.dark,,,fail,max,caps.dark,2.5,,\"caps.dark has no value in any frame, so nothing says that "
              "it is at most 2.500\",,,");
}

TEST(ComparisonAnnotations, SayWhatFailsAndWhatWarns) {
    const std::vector<std::string> lines = linesOf(comparisonAnnotations(everyOutcome()));
    ASSERT_EQ(lines.size(), 14u) << "nine images that fail, one that warns, one column, three budgets";
    EXPECT_EQ(
        lines[0],
        "::warning file=tests/golden/courtyard/beauty/warn.0001.png,title=warn%3A beauty/warn.0001.png::near: psnr "
        "39.5 is under 40");
    EXPECT_EQ(
        lines[1],
        "::error file=tests/golden/courtyard/beauty/fail.0001.png,title=fail%3A beauty/fail.0001.png::more than the "
        "limit:%0A50%25, <a> & \"b\" (shadows: max-abs 0.7 is over 0.004)");
    EXPECT_EQ(lines[5],
              "::error file=tests/golden/courtyard/odd%2C ]]> name%25%3A%3Afile.png,title=extra-output%3A odd%2C ]]> "
              "name%25%3A%3Afile.png::an output that nobody asked for");
    EXPECT_EQ(lines[10],
              "::error title=fail%3A overdraw.fragments Lamp::125.5 instead of 100 in frame 3, tolerance 0.01");
    EXPECT_EQ(
        lines[11],
        "::error title=fail%3A budget overdraw.p95::overdraw.p95 is 7.250 fragments/pixel in frame 12, 1.250 (20.8 "
        "%25) over the budget of 6");
}

TEST(ComparisonMarkdown, FitsAScreenAndPutsTheWorstFirst) {
    const std::string text = comparisonMarkdown(everyOutcome());
    EXPECT_THAT(text, testing::StartsWith("## Golden frames: fail\n\n5 fail, 1 unexpected-pass, 1 missing-output"));
    EXPECT_THAT(text, HasSubstr("- no manifest.json beside"));
    EXPECT_THAT(text, HasSubstr("| beauty/fail.0001.png | fail | more than the limit:?50%, \\<a> & \"b\" "));
    EXPECT_THAT(text, HasSubstr("```sh\numbrage accept tests/golden/courtyard out/courtyard\n```"));
    EXPECT_LT(text.find("beauty/fail.0001.png"), text.find("beauty/warn.0001.png"));
    EXPECT_THAT(text, Not(HasSubstr("beauty/pass")));
    EXPECT_THAT(text, HasSubstr("| budget stencil.max | fail | stencil.max is 3 layers in frame 1, light Lamp, "));
    EXPECT_THAT(text, Not(HasSubstr("triangles")));
    EXPECT_LT(text.find("budget caps.dark"), text.find("budget stencil.max")) << "what has no value is the worst";
    EXPECT_LT(text.find("budget stencil.max"), text.find("budget overdraw.p95")) << "half over, a fifth over";

    Comparison many = sequence(48);
    for (ImageResult& image : many.images) image.outcome = Outcome::Fail;
    many.images[100].decision->value = 77.0;
    const std::string long_ = comparisonMarkdown(many);
    EXPECT_LT(linesOf(long_).size(), 45u);
    EXPECT_THAT(long_, HasSubstr("\nand 172 more\n"));
    const std::string head = "|---|---|---|\n| ";
    EXPECT_EQ(long_.substr(long_.find(head) + head.size(), many.images[100].name.size()), many.images[100].name);
}

TEST(ComparisonMarkdown, SaysFailAndWhyOfABrokenBudgetAlone) {
    const std::string text = comparisonMarkdown(overBudget());
    EXPECT_THAT(text, testing::StartsWith("## Golden frames: fail\n\n1 fail, 61 pass\n\n"));
    EXPECT_THAT(text, HasSubstr("| budget overdraw.p95 | fail | overdraw.p95 is 7.250 fragments/pixel in frame 12, "));
    EXPECT_THAT(text, HasSubstr("To render again:"));
}

TEST(ResultText, KnowsOfEachMetricWhichValuesAreWorse) {
    for (const MetricInfo& metric : kMetrics) {
        EXPECT_EQ(isWorseBelow(std::string(metric.name)), !metric.largerIsWorse) << metric.name;
    }
    EXPECT_TRUE(isWorseBelow("psnr"));
    EXPECT_FALSE(isWorseBelow("of another version"));
}

TEST(ComparisonMarkdown, OfAPassIsShort) {
    Comparison good = sequence(1);
    EXPECT_EQ(comparisonMarkdown(good), "## Golden frames: pass\n\n4 pass\n\n");
    EXPECT_EQ(comparisonMarkdown({}), "## Golden frames: pass\n\nnothing was compared\n\n");
    EXPECT_EQ(comparisonAnnotations(good), "");
}

}  // namespace
}  // namespace umbrage
