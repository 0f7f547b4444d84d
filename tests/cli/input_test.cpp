// SPDX-License-Identifier: Apache-2.0
// Sequences and scenes that are wrong (exit code 3), and machines without OpenGL (4): the exact message of each.
#include "workspace.h"

namespace umbrage::cli {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

class Input : public Workspace {
protected:
    void SetUp() override {
        Workspace::SetUp();
        writeSequence();
    }

    /// The last line on stderr is the error; nothing is on stdout, and nothing was written.
    void expectError(int exitCode, const std::vector<std::string>& arguments, const std::string& message,
                     const Launch& launch = {}) const {
        SCOPED_TRACE(message);
        const Result result = umbrage(launch, arguments);
        EXPECT_EQ(result.exitCode, exitCode);
        EXPECT_THAT(result.out, IsEmpty());
        EXPECT_THAT(result.err, testing::EndsWith("umbrage: error: " + message + "\n"));
        EXPECT_THAT(filesIn("out"), IsEmpty());
    }

    void expectRefused(const std::vector<std::string>& more, const std::string& message) const {
        std::vector<std::string> arguments{"render", "seq.yaml", "--out", "out"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        expectError(3, arguments, message);
    }
};

TEST_F(Input, AMisspeltKeyHasItsPlaceAndTheNearestName) {
    writeSequence("imgae: {samples: 4}\n");
    expectError(3, {"render", "seq.yaml"}, "seq.yaml:5:1: unknown key \"imgae\" in sequence (did you mean \"image\"?)");
    writeSequence("shadow:\n  cuont: z-fail\n");
    expectError(3, {"render", "seq.yaml"}, "seq.yaml:6:3: unknown key \"cuont\" in shadow (did you mean \"count\"?)");
}

TEST_F(Input, AMissingFileIsNamed) {
    expectError(3, {"render", "nowhere.yaml"}, "nowhere.yaml: there is no such file");
    expectError(3, {"render", "nowhere.glb"}, "nowhere.glb: there is no such file");
    expectError(3, {"inspect", "nowhere.glb"}, "nowhere.glb: there is no such file");
    const std::string longName(5000, 'a');
    expectError(3, {"render", longName}, longName + ": File name too long");
    writeFile("seq.yaml", "umbrage: 1\nscene:\n  - gltf: nowhere.glb\n");
    const std::string notThere =
        "seq.yaml:3:11: there is no file nowhere.glb (paths are read from the folder of the sequence file)";
    expectError(3, {"render", "seq.yaml"}, notThere);
    expectError(3, {"render", "seq.yaml", "--dry-run"}, notThere);
}

TEST_F(Input, AFrameRangeWithAColonIsExplained) {
    const std::string explained =
        "frame range \"1:3\" has a ':' (tools disagree about it: a stagger in fileseq and OpenCue, between first and "
        "last "
        "in usdrecord, a step in OpenJobDescription and Slurm; write 1-10 for a range and 1-10x2 for every second "
        "frame)";
    expectRefused({"--frames", "1:3"}, "--frames: " + explained);
    expectRefused({"--set", "time.frames=1:3"}, "--set time.frames: " + explained);
    writeFile("colon.yaml", "umbrage: 1\nscene: [{gltf: a.glb}]\ntime: {frames: \"1:3\"}\n");
    expectError(3, {"render", "colon.yaml"}, "colon.yaml:3:16: " + explained);
}

TEST_F(Input, FramesThatAreNoneAreRefused) {
    expectRefused({"--frames", "3-1"},
                  "--frames: frame range \"3-1\" runs backwards (write 1-3; frames are rendered in "
                  "ascending order)");
    expectRefused({"--frames", "1-3,2"}, "--frames: \"1-3\" and \"2\" both have frame 2 (name every frame once)");
    expectRefused({"--frames", "it's"},
                  "--frames: \"it's\" is not a frame range (write A, A-B or A-BxS, several with commas "
                  "between: 1-48 or 1-99x2,100)");
}

TEST_F(Input, AllFramesAreForScenesOnly) {
    expectError(
        2, {"render", "seq.yaml", "--frames", "all"},
        "--frames all: is for scenes without YAML; a sequence names its frames (leave --frames out for all of them)");
}

TEST_F(Input, ASizeOutOfRangeIsRefused) {
    expectRefused({"--size", "0x48"}, "--size: an entry of size must be an integer from 1 to 16384, not 0");
    expectRefused({"--size", "64x99999"}, "--size: an entry of size must be an integer from 1 to 16384, not 99999");
}

TEST_F(Input, AWrongCameraListsThoseThatThereAre) {
    expectRefused({"--camera", "/Nope"}, "--camera: there is no camera \"/Nope\" (known: /Camera)");
    expectRefused({"--camera", "it's"}, "--camera: there is no camera \"it's\" (known: /Camera)");
    writeSequence("camera: /Camra\n");
    expectRefused({}, "seq.yaml:5:9: there is no camera \"/Camra\" (did you mean \"/Camera\"?)");
}

TEST_F(Input, OverridesThatFitNothingAreRefused) {
    expectRefused({"--set", "shadow.cuont=z-fail"},
                  "--set shadow.cuont: unknown key \"cuont\" in shadow (did you mean \"count\"?)");
    expectRefused({"--set", "image.size.2=3"}, "--set image.size.2: \"2\" is not an entry of a list of 2 (0 to 1)");
    expectRefused({"--set", "image.samples=3"}, "--set image.samples: samples must be one of 1, 2, 4, 8, 16, not 3");
}

TEST_F(Input, SkipsAndAovsAreKnownByName) {
    expectRefused({"--set", "shadow.skips.hlave=off"},
                  "--set shadow.skips.hlave: unknown name \"hlave\" in skips (did you mean \"halve\"?)");
    expectRefused({"--set", "output.aovs.dept=exr"},
                  "--set output.aovs.dept: unknown name \"dept\" in aovs (did you mean \"depth\"?)");
}

TEST_F(Input, DataIsNotWrittenAsPng) {
    for (const std::string aov : {"depth", "normal", "shadow", "stencil", "overdraw"}) {
        writeSequence("output:\n  aovs: {beauty: png, " + aov + ": png}\n");
        const std::string column = std::to_string(std::string("  aovs: {beauty: png, : ").size() + aov.size() + 1);
        expectRefused({}, "seq.yaml:6:" + column + ": " + aov + " is data, which PNG would cut to [0, 1] (write exr)");
    }
}

TEST_F(Input, StatisticsAreJsonOrCsv) {
    writeSequence("statistics: {path: numbers.txt}\n");
    expectRefused({}, "seq.yaml:5:20: path must be a path that ends with .json or .csv, not \"numbers.txt\"");
}

TEST_F(Input, AColourConfigurationThatIsNotThereIsRefused) {
    const Result result = umbrage({"render", "seq.yaml", "--out", "out", "--ocio", "nowhere.ocio"});
    EXPECT_EQ(result.exitCode, 3);
    EXPECT_THAT(result.err, HasSubstr("umbrage: error: nowhere.ocio: the colour configuration cannot be used"));
    EXPECT_THAT(filesIn("out"), IsEmpty());
}

TEST_F(Input, WithoutAnEglDriverTheHintSaysWhatToInstall) {
    const Launch none{.environment = {"__EGL_VENDOR_LIBRARY_FILENAMES=/nonexistent.json"}};
    const std::string hint = " (umbrage needs EGL with OpenGL 4.5; on Debian: apt-get install libegl1 libgl1-mesa-dri)";
    expectError(4, {"render", "seq.yaml", "--out", "out"}, "there is no EGL driver" + hint, none);
    expectError(4, {"devices"}, "no EGL device found" + hint, none);
}

TEST_F(Input, AnOpenGlThatIsTooOldIsToldApart) {
    const Result result =
        umbrage(Launch{.environment = {"MESA_GL_VERSION_OVERRIDE=3.3"}}, {"render", "seq.yaml", "--out", "out"});
    if (result.exitCode == 0) GTEST_SKIP() << "this driver does not let itself be made older";
    EXPECT_EQ(result.exitCode, 4);
    EXPECT_THAT(result.err, HasSubstr("creating an OpenGL 4.5 core context failed"));
}

TEST_F(Input, ADeviceThatIsNotThereGetsTheListOfThoseThatAre) {
    const Result devices = umbrage({"devices"});
    ASSERT_EQ(devices.exitCode, 0) << devices.err;
    EXPECT_THAT(devices.out, testing::StartsWith("0  "));
    const Result result = umbrage({"render", "seq.yaml", "--out", "out", "--device", "no such device"});
    EXPECT_EQ(result.exitCode, 4);
    EXPECT_THAT(result.err, HasSubstr("umbrage: error: no usable OpenGL device for 'no such device'; 0: "));
    EXPECT_THAT(result.err, HasSubstr("one that umbrage devices lists)"));
    EXPECT_EQ(umbrage({"render", "seq.yaml", "--out", "out", "--device", "0"}).exitCode, 0);
}

}  // namespace
}  // namespace umbrage::cli
