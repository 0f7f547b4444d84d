// SPDX-License-Identifier: Apache-2.0
// The command line itself: help, version, and what is wrong with it (exit code 2).
#include <algorithm>

#include "workspace.h"

namespace umbrage::cli {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

class Usage : public Workspace {
protected:
    /// One line that says what is wrong, and one that says where help is; nothing on stdout.
    void expectUsageError(const std::vector<std::string>& arguments, const std::string& message) const {
        SCOPED_TRACE(message);
        const Result result = umbrage(arguments);
        EXPECT_EQ(result.exitCode, 2);
        EXPECT_THAT(result.out, IsEmpty());
        EXPECT_THAT(result.err, StartsWith("umbrage: error: "));
        EXPECT_THAT(result.err, HasSubstr(message));
    }
};

TEST_F(Usage, HelpAndVersionGoToStdout) {
    const Result version = umbrage({"--version"});
    EXPECT_EQ(version.exitCode, 0);
    EXPECT_THAT(version.out, testing::MatchesRegex("umbrage [0-9]+\\.[0-9]+\\.[0-9]+\n"));
    EXPECT_THAT(version.err, IsEmpty());

    const Result help = umbrage({"--help"});
    EXPECT_EQ(help.exitCode, 0);
    EXPECT_THAT(help.err, IsEmpty());
    for (const char* word : {"render", "verify", "inspect", "stats", "devices", "schema", "Exit codes", "130/143"}) {
        EXPECT_THAT(help.out, HasSubstr(word));
    }
    const Result ofRender = umbrage({"render", "--help"});
    EXPECT_EQ(ofRender.exitCode, 0);
    for (const char* option : {"--frames", "--size", "--camera", "--out", "--set", "--dry-run", "--device"}) {
        EXPECT_THAT(ofRender.out, HasSubstr(option));
    }
}

TEST_F(Usage, HelpStartsInMilliseconds) {
    double seconds = 1.0;
    for (int i = 0; i < 5; ++i) seconds = std::min(seconds, umbrage({"--help"}).seconds);
    EXPECT_LT(seconds, 0.1) << "the best of five; opening the image libraries alone takes longer";
}

TEST_F(Usage, OnlyRenderingNeedsTheImageCodec) {
    const std::filesystem::path alone = folder() / "umbrage";
    std::filesystem::copy_file(UMBRAGE_PROGRAM, alone);
    writeSequence();
    for (const std::vector<std::string>& arguments :
         {std::vector<std::string>{"--help"}, {"--version"}, {"schema"}, {"render", "seq.yaml", "--dry-run"}}) {
        const Result result = umbrage(Launch{.program = alone}, arguments);
        EXPECT_EQ(result.exitCode, 0) << arguments[0] << ": " << result.err;
    }
    const Result render = umbrage(Launch{.program = alone}, {"render", "seq.yaml"});
    EXPECT_EQ(render.exitCode, 4);
    EXPECT_THAT(render.err, HasSubstr("the image codec is missing"));
    EXPECT_THAT(render.err, HasSubstr("keep libumbrage_codec.so beside the program"));
}

TEST_F(Usage, TheSchemaIsData) {
    const Result schema = umbrage({"schema"});
    EXPECT_EQ(schema.exitCode, 0);
    EXPECT_THAT(schema.out, StartsWith("{"));
    EXPECT_THAT(schema.err, IsEmpty());
    EXPECT_EQ(umbrage({"schema", "--markdown"}).out, contentsOf(UMBRAGE_SOURCE_DIR "/docs/sequence.md"));
}

TEST_F(Usage, CommandsThatDoNotExistGetTheNearestOne) {
    expectUsageError(
        {}, "a command is missing (known: render, compare, accept, verify, bench, inspect, stats, devices, schema)");
    expectUsageError({"rendr", "seq.yaml"}, "there is no command 'rendr' (did you mean \"render\"?)");
    expectUsageError({"-q", "rendr"}, "there is no command 'rendr'");
    expectUsageError({"seq.yaml"}, "there is no command 'seq.yaml'");
}

TEST_F(Usage, OptionsThatDoNotExistGetTheNearestOne) {
    expectUsageError({"render", "seq.yaml", "--frmes", "1"},
                     "there is no option '--frmes' (did you mean \"--frames\"?)");
    expectUsageError({"render", "seq.yaml", "--qiuet"}, "(did you mean \"--quiet\"?)");
    expectUsageError({"schema", "--markdwn"}, "(did you mean \"--markdown\"?)");
}

TEST_F(Usage, WhatIsMissingOrTooMuchIsNamed) {
    expectUsageError({"render"}, "input is required");
    expectUsageError({"inspect"}, "scene is required");
    expectUsageError({"schema", "surplus"}, "surplus");
    expectUsageError({"render", "seq.yaml", "--frames"}, "--frames");
}

TEST_F(Usage, ValuesOfTheWrongFormAreRefused) {
    writeSequence();
    for (const char* size : {"nonsense", "64", "64x", "x48", "64x48x2", "-64x48", "64x4.8", "64X48"}) {
        expectUsageError(
            {"render", "seq.yaml", "--size", size},
            std::string("--size: \"") + size + "\" is not WIDTHxHEIGHT (two numbers of pixels, such as 640x480)");
    }
    expectUsageError({"render", "seq.yaml", "--progress", "loud"}, "--progress: loud not in {auto,bar,lines,none}");
    expectUsageError({"render", "seq.yaml", "--workers", "-3"}, "--workers: Value -3 not in range 0 to 256");
    expectUsageError({"render", "seq.yaml", "--set", "exposure"}, "--set exposure: this is not an assignment");
}

TEST_F(Usage, AFullStdoutIsAnOutputThatCouldNotBeWritten) {
    writeSequence();
    for (const char* what : {"--help", "--version", "schema"}) {
        const Result result = umbrage(Launch{.standardOutput = "/dev/full"}, {what});
        EXPECT_EQ(result.exitCode, 5) << what;
        EXPECT_THAT(result.err, HasSubstr("umbrage: error: stdout: cannot be written\n")) << what;
    }
}

}  // namespace
}  // namespace umbrage::cli
