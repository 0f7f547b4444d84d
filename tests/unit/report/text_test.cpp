// SPDX-License-Identifier: Apache-2.0
// The table for people and the Markdown for documents.
#include <gmock/gmock.h>

#include <algorithm>
#include <limits>
#include <sstream>

#include "verdicts.h"

namespace umbrage {
namespace {

using testing::ContainsRegex;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

std::vector<std::string> linesOf(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

TEST(VerifyTable, HasALineForEachSequenceAndTechniqueAndItsColumnsStandBelowEachOther) {
    const std::vector<std::string> lines = linesOf(twoSequences().table({}));
    ASSERT_GE(lines.size(), 6u);
    EXPECT_THAT(lines[0], StartsWith("sequence  technique       frames  light-facing  hard"));
    EXPECT_THAT(lines[1], StartsWith("A1        compute:z-pass       3          6000     0    12      0.002"));
    EXPECT_THAT(lines[4], StartsWith("B1        cpu:z-fail           1          2000     1     4      0.002"));
    for (std::size_t i = 1; i < 5; ++i) EXPECT_EQ(lines[i].size(), lines[0].size());
    EXPECT_THAT(lines[1], HasSubstr("+0.01000"));                        // two dark samples on 200 px of outline
    EXPECT_THAT(lines[1], HasSubstr("2 (3 px)"));                        // the largest error
    EXPECT_THAT(lines[1], ContainsRegex(" - +0.75 +3 +0 +20.0 +100$"));  // no counts; radiance, codes, toggles, times
}

TEST(VerifyTable, ShowsFramesOrLightsWhereAskedTo) {
    const VerifyReport report = twoSequences();
    EXPECT_THAT(linesOf(report.table({.frames = true}))[2], ContainsRegex("^A1 +compute:z-pass +2 +2000 "));
    EXPECT_THAT(linesOf(report.table({.lights = true}))[2], ContainsRegex("^A1 +compute:z-pass +3 +Fill +3000 "));
    EXPECT_THAT(linesOf(report.table({.frames = true, .lights = true}))[3],
                ContainsRegex("^A1 +compute:z-pass +2 +Key +1000 "));
}

TEST(VerifyTable, EndsWithWhatIsWrongAndTheSum) {
    const std::string table = twoSequences().table({});
    EXPECT_THAT(table, HasSubstr("\nwrong: B1 frame 1, light Key: 1 false dark, 0 false lit by cpu:z-fail\n"));
    EXPECT_THAT(table, EndsWith("\n1 hard error in 16000 light-facing samples of 8 frames\n"));
}

TEST(VerifyTable, TellsTheWorstFirstAndTechniquesThatErrAlikeTogether) {
    VerifyReport report(header());
    report.add("A1", true, frame(1, "compute:z-pass", {light("Key", 2)}));
    report.add("A1", true, frame(1, "cpu:z-pass", {light("Key", 2)}));
    report.add("A1", true, frame(2, "compute:z-pass", {light("Key", 9)}));
    report.add("B1", false, frame(3, "compute:z-pass", {light("Key", 99)}));
    const std::string table = report.table({});
    const std::size_t worst = table.find("wrong: A1 frame 2"),
                      both = table.find("2 false dark, 0 false lit by compute:z-pass cpu:z-pass\n"),
                      unclaimed = table.find("99 false dark, 0 false lit by compute:z-pass (claims no exactness)\n");
    EXPECT_LT(worst, both);
    EXPECT_LT(both, unclaimed);
    EXPECT_NE(unclaimed, std::string::npos);
    EXPECT_THAT(
        table, EndsWith("13 hard errors in 3000 light-facing samples of 3 frames; 99 where no exactness is claimed\n"));
}

TEST(VerifyTable, TwentyWrongLinesAreEnough) {
    VerifyReport report(header());
    for (int number = 1; number <= 30; ++number) report.add("A1", true, frame(number, "cpu:z-pass", {light("K", 1)}));
    const std::vector<std::string> lines = linesOf(report.table({}));
    EXPECT_EQ(std::count_if(lines.begin(), lines.end(), [](const auto& l) { return l.starts_with("wrong: "); }), 21);
    EXPECT_THAT(report.table({}), HasSubstr("wrong: and 10 lines more\n"));
}

TEST(VerifyTable, SaysCountsOnlyWhereTheyWereJudged) {
    VerifyReport report(header());
    LightVerdict judged = light("Key");
    judged.countsJudged = 500;
    judged.countErrors = 4;
    judged.hardCountErrors = 3;
    report.add("A1", true, frame(1, "compute:z-pass", {judged}));
    EXPECT_THAT(report.table({}), HasSubstr(" 3 / 4 "));
    EXPECT_THAT(report.table({}), HasSubstr("0 false lit, 3 wrong counts by"));
    EXPECT_THAT(report.table({}),
                HasSubstr("0 hard errors in 1000 light-facing samples of 1 frame, 3 wrong counts of 500\n"));
}

TEST(VerifyTable, SaysWhatWasPlantedAllowedOrNotJudged) {
    VerifyHeader special = header();
    special.fault = "missing-edge";
    special.maxHard = 3;
    VerifyReport report(special);
    report.addProblem("A1", "a.yaml:3:1: unknown key");
    const std::string table = report.table({});
    EXPECT_THAT(table, StartsWith("not judged: A1: a.yaml:3:1: unknown key\n"));
    EXPECT_THAT(
        table,
        EndsWith("0 hard errors in 0 light-facing samples of 0 frames; 3 would pass; with the fault missing-edge\n"));
}

TEST(VerifyTable, HasNoNumbersThatAreNone) {
    VerifyReport report(header());
    report.add("Dark", true, frame(1, "compute:z-pass", {LightVerdict{}}));
    FrameVerdict broken = frame(1, "compute:z-fail", {light("Key")});
    broken.radiance.largest = std::numeric_limits<double>::infinity();
    report.add("Dark", true, broken);
    for (const std::string& text : {report.table({}), report.markdown({})}) {
        EXPECT_THAT(text, Not(ContainsRegex("[+ ]nan|[+ ]inf|-nan")));
        EXPECT_THAT(text, HasSubstr("not finite"));
    }
}

TEST(VerifyTable, NamesCannotMoveTheCursorOrMakeRows) {
    VerifyReport report(header());
    report.add("a\x1b[2J\nb", true, frame(1, "compute:z-pass", {light("K\r", 1)}));
    const std::string table = report.table({.lights = true});
    EXPECT_THAT(table, HasSubstr("a?[2J?b"));
    EXPECT_THAT(table, Not(HasSubstr("\x1b")));
    EXPECT_THAT(table, Not(HasSubstr("\r")));
    EXPECT_EQ(linesOf(table).size(), 5u);  // two of the table, a blank one, what is wrong, the sum
}

TEST(VerifyMarkdown, SaysHowItWasMadeAndOnWhat) {
    const std::string text = twoSequences().markdown({});
    EXPECT_THAT(text, StartsWith("# Shadows against the exact answer\n"));
    EXPECT_THAT(text, HasSubstr("\n    umbrage verify a.yaml b.yaml\n"));
    EXPECT_THAT(text, HasSubstr("umbrage 0.1.0 on A device (A driver). Tolerance: 0.0078125 px"));
    EXPECT_THAT(text, HasSubstr("**1 hard error in 16000 light-facing samples of 8 frames**"));
    EXPECT_THAT(text, HasSubstr("## What is wrong\n\n- B1 frame 1, light Key: 1 false dark"));
}

TEST(VerifyMarkdown, EveryTableRowHasAsManyCellsAsItsHead) {
    VerifyReport report = twoSequences();
    report.add("pipe|in|name", true, frame(1, "compute:z-pass", {light("Key")}));
    std::size_t cells = 0, tables = 0;
    for (const std::string& line : linesOf(report.markdown({.frames = true, .lights = true}))) {
        if (line.empty() || line[0] != '|') {
            cells = 0;
            continue;
        }
        std::size_t bars = 0;
        for (std::size_t i = 0; i < line.size(); ++i) bars += line[i] == '|' && (i == 0 || line[i - 1] != '\\');
        tables += cells == 0;
        if (cells == 0) cells = bars;
        EXPECT_EQ(bars, cells) << line;
    }
    EXPECT_EQ(tables, 3u);
}

TEST(VerifyMarkdown, HasTheMatrixOfTechniquesAndInSummaryNoSequences) {
    VerifyReport report(header());
    report.add("A1", true, frame(1, "compute:z-pass", {light("Key", 0)}));
    report.add("A1", true, frame(1, "cpu:z-pass", {light("Key", 2)}));
    report.add("B1", true, frame(1, "cpu:z-pass", {light("Key", 1)}));
    report.add("A1", false, frame(1, "cpu:z-pass-plus", {light("Key", 5)}));
    const std::string text = report.markdown({.summary = true});
    EXPECT_THAT(text, HasSubstr("| hard errors | z-pass | z-pass-plus |\n"));
    EXPECT_THAT(text, HasSubstr("\n| compute | 0 | - |\n"));
    EXPECT_THAT(text, HasSubstr("\n| cpu | 3 | 5 (claims no exactness) |\n"));
    EXPECT_THAT(text, Not(HasSubstr("## Each sequence")));
    EXPECT_THAT(linesOf(report.table({.summary = true}))[0], StartsWith("technique "));
}

TEST(VerifyMarkdown, SaysNothingIsWrongWhereNothingIs) {
    VerifyReport report(header());
    report.add("A1", true, frame(1, "compute:z-pass", {light("Key")}));
    EXPECT_THAT(report.markdown({}), Not(HasSubstr("What is wrong")));
    report.addProblem("B1", "there is no such file");
    EXPECT_THAT(report.markdown({}), HasSubstr("## What is wrong\n\n- not judged: B1: there is no such file\n"));
}

}  // namespace
}  // namespace umbrage
