// SPDX-License-Identifier: Apache-2.0
// How a run goes: equal bytes each time, what is said meanwhile, and what an interruption leaves behind.
#include <csignal>

#include "workspace.h"

namespace umbrage::cli {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

class Run : public Workspace {
protected:
    void expectSameFiles(const std::string& a, const std::string& b) const {
        ASSERT_EQ(filesIn(a), filesIn(b));
        for (const std::string& file : filesIn(a)) {
            EXPECT_EQ(contentsOf(folder() / a / file), contentsOf(folder() / b / file))
                << file << " of " << a << " and " << b;
        }
    }

    /// Ends a run of 40 frames when the third is reported, and continues it as the message says.
    void expectInterruptible(int signal, int exitCode) const {
        writeSequence("output: {aovs: {beauty: png, depth: exr, shadow: exr}}\n");
        const std::vector<std::string> arguments{"render", "seq.yaml", "--frames", "1-40"};
        const auto into = [&](std::vector<std::string> more, const std::string& out) {
            std::vector<std::string> all = arguments;
            all.insert(all.end(), {"--out", out});
            all.insert(all.end(), more.begin(), more.end());
            return all;
        };
        ASSERT_EQ(umbrage(into({}, "whole")).exitCode, 0);

        const Result stopped = umbrage(
            Launch{.signal = [&](const std::string& err) { return err.find("(3 of 40)") != err.npos ? signal : 0; }},
            into({}, "out"));
        EXPECT_EQ(stopped.exitCode, exitCode);
        const std::size_t count = filesIn("out").size();
        EXPECT_GE(count, 9u);
        EXPECT_LT(count, 120u) << "it was not interrupted at all";
        EXPECT_EQ(count % 3, 0u) << "a frame has three files";
        for (const std::string& file : filesIn("out")) {
            EXPECT_THAT(file, Not(testing::StartsWith(".")));
            EXPECT_EQ(contentsOf(folder() / "out" / file), contentsOf(folder() / "whole" / file)) << file;
        }

        const std::string before = "umbrage: interrupted; frames still to render: --frames ";
        const std::size_t at = stopped.err.rfind(before);
        ASSERT_NE(at, std::string::npos) << stopped.err;
        const std::string rest =
            stopped.err.substr(at + before.size(), stopped.err.find('\n', at) - at - before.size());
        const Result continued = umbrage({"render", "seq.yaml", "--frames", rest, "--out", "out"});
        EXPECT_EQ(continued.exitCode, 0) << continued.err;
        EXPECT_THAT(continued.err, HasSubstr("of " + std::to_string(40 - count / 3) + ")")) << "no frame twice";
        expectSameFiles("out", "whole");
    }
};

TEST_F(Run, TheSameJobGivesTheSameBytes) {
    writeSequence(
        "lights: [{type: point, name: Key, position: [1, 2, 1], intensity: {0: 1, 1: 9}}]\n"
        "output: {aovs: {beauty: png, depth: exr, normal: exr, shadow: exr, overdraw: exr}}\n"
        "diagnostics: {overlays: [overdraw]}\n"
        "statistics: {path: numbers.json}\n");
    ASSERT_EQ(umbrage({"render", "seq.yaml", "--out", "a"}).exitCode, 0);
    ASSERT_EQ(filesIn("a").size(), 3u * 6u + 1u);
    ASSERT_EQ(umbrage({"render", "seq.yaml", "--out", "b"}).exitCode, 0);
    expectSameFiles("a", "b");
    for (const char* workers : {"1", "4"}) {
        ASSERT_EQ(umbrage({"render", "seq.yaml", "--workers", workers, "--out", workers}).exitCode, 0);
        expectSameFiles("a", workers);
    }
    ASSERT_EQ(umbrage({"render", "seq.yaml", "--set", "output.aovs.beauty=exr", "--out", "c"}).exitCode, 0);
    ASSERT_EQ(
        umbrage({"render", "seq.yaml", "--set", "output.aovs.beauty=exr", "--out", "d", "--workers", "4"}).exitCode, 0);
    expectSameFiles("c", "d");
}

// Means are taken in the order of the pictures, whoever else works at the same time.
TEST_F(Run, AnAccumulatedFrameIsTheSameForAllWorkers) {
    writeSequence("output: {aovs: {beauty: exr, depth: exr, shadow: exr}}\n");
    ASSERT_EQ(umbrage({"render", "seq.yaml", "--out", "plain"}).exitCode, 0);
    for (const char* workers : {"1", "3"}) {
        ASSERT_EQ(
            umbrage({"render", "seq.yaml", "--set", "image.accumulation=5", "--workers", workers, "--out", workers})
                .exitCode,
            0);
    }
    expectSameFiles("1", "3");
    EXPECT_TRUE(contentsOf(folder() / "1/beauty.0001.exr") != contentsOf(folder() / "plain/beauty.0001.exr"));
}

TEST_F(Run, AFrameDoesNotDependOnThoseBeforeIt) {
    writeSequence("output: {aovs: {beauty: exr, shadow: exr}}\n");
    ASSERT_EQ(umbrage({"render", "seq.yaml", "--frames", "1-9", "--out", "all"}).exitCode, 0);
    ASSERT_EQ(umbrage({"render", "seq.yaml", "--frames", "9", "--out", "one"}).exitCode, 0);
    for (const std::string& file : filesIn("one")) {
        EXPECT_EQ(contentsOf(folder() / "one" / file), contentsOf(folder() / "all" / file)) << file;
    }
}

TEST_F(Run, EndsWithTheFolderAndTheCost) {
    writeSequence();
    const Result result = umbrage({"render", "seq.yaml", "--out", "out"});
    EXPECT_EQ(result.exitCode, 0);
    EXPECT_THAT(result.out, IsEmpty());
    const std::size_t lastLine = result.err.rfind('\n', result.err.size() - 2) + 1;
    EXPECT_THAT(
        result.err.substr(lastLine),
        testing::MatchesRegex("3 of 3 frames in out: [0-9.]+ s to load, [0-9.]+ s to render \\([0-9.]+ s a frame\\), "
                              "[0-9]+ MiB at most\n"));
}

TEST_F(Run, ProgressIsLinesWhereThereIsNoTerminal) {
    writeSequence();
    const Result result = umbrage({"render", "seq.yaml", "--out", "out"});
    for (const char* line : {"(1 of 3)\n", "(2 of 3)\n", "(3 of 3)\n"}) EXPECT_THAT(result.err, HasSubstr(line));
    for (const char* frame : {"frame 1 written", "frame 2 written", "frame 3 written"}) {
        EXPECT_THAT(result.err, HasSubstr(frame));
    }
    EXPECT_THAT(result.err, Not(HasSubstr("\r")));
    EXPECT_THAT(result.err, Not(HasSubstr("\x1b")));
}

TEST_F(Run, ProgressIsABarOnATerminal) {
    writeSequence();
    const Result result = umbrage(Launch{.terminal = true}, {"render", "seq.yaml", "--out", "out"});
    EXPECT_EQ(result.exitCode, 0);
    EXPECT_THAT(result.out, IsEmpty());
    EXPECT_THAT(result.err, HasSubstr("[..............................] 0/3"));
    EXPECT_THAT(result.err, HasSubstr("[##############################] 3/3"));
    EXPECT_THAT(result.err, testing::ContainsRegex("[0-9.]+ s a frame, 0:[0-9][0-9] left"));
    EXPECT_THAT(result.err, Not(HasSubstr("written")));
    EXPECT_THAT(result.err, HasSubstr("3 of 3 frames in out"));
}

TEST_F(Run, ProgressIsChosenByName) {
    writeSequence();
    EXPECT_THAT(umbrage({"render", "seq.yaml", "--out", "out", "--progress", "bar"}).err, HasSubstr("] 3/3"));
    EXPECT_THAT(umbrage(Launch{.terminal = true}, {"render", "seq.yaml", "--out", "out", "--progress", "lines"}).err,
                HasSubstr("frame 3 written"));
    const Result none = umbrage({"render", "seq.yaml", "--out", "out", "--progress", "none"});
    EXPECT_THAT(none.err, Not(HasSubstr("written")));
    EXPECT_THAT(none.err, HasSubstr("3 of 3 frames"));
}

TEST_F(Run, QuietSaysNothingButErrors) {
    writeSequence();
    for (const bool terminal : {false, true}) {
        const Result result = umbrage(Launch{.terminal = terminal}, {"render", "seq.yaml", "--out", "out", "--quiet"});
        EXPECT_EQ(result.exitCode, 0);
        EXPECT_THAT(result.out + result.err, IsEmpty());
    }
    EXPECT_EQ(filesIn("out").size(), 3u);
    EXPECT_THAT(umbrage({"-q", "render", "nowhere.yaml"}).err, HasSubstr("there is no such file"));
}

TEST_F(Run, InterruptingLeavesWholeFramesAndSaysHowToGoOn) {
    expectInterruptible(SIGINT, 130);
}

TEST_F(Run, TerminatingLeavesWholeFramesAndSaysHowToGoOn) {
    expectInterruptible(SIGTERM, 143);
}

TEST_F(Run, InterruptingWhileLoadingLeavesNothing) {
    writeSequence();
    int polls = 0;
    const Result result = umbrage(Launch{.signal = [&](const std::string&) { return ++polls == 50 ? SIGINT : 0; }},
                                  {"render", "seq.yaml", "--frames", "1-40", "--out", "out"});
    EXPECT_EQ(result.exitCode, 130);
    EXPECT_THAT(filesIn("out"), IsEmpty());
}

}  // namespace
}  // namespace umbrage::cli
