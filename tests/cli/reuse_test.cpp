// SPDX-License-Identifier: Apache-2.0
// Frames in which nothing changed are not rendered again: what they leave behind is bit for bit what rendering them
// leaves behind.
#include <nlohmann/json.hpp>

#include "workspace.h"

namespace umbrage::cli {
namespace {

using Json = nlohmann::json;
using testing::ElementsAre;

// The lamp is at one place in the frames 0 and 9 to 11, at another in 3 to 6, and on its way, the same both ways, in
// the others.
constexpr const char* kPauses =
    "animations: []\n"
    "lights: [{type: point, name: key, intensity: 60, interpolation: linear,\n"
    "          position: {0: [1, 3, 2], 0.125: [2, 3, 1], 0.25: [2, 3, 1], 0.375: [1, 3, 2]}}]\n"
    "output: {path: \"out/{aov}.{frame:04}.{ext}\", aovs: {beauty: png, shadow: exr}}\n"
    "statistics: {path: out/statistics.json, page: out/statistics.html}\n";
const std::vector<int> kReused{4, 5, 6, 7, 8, 9, 10, 11};

class Reuse : public Workspace {
protected:
    /// @return  frames that were not rendered, by the statistics
    std::vector<int> reusedIn(const std::string& out, const std::vector<std::string>& more = {}) const {
        std::vector<std::string> arguments{"render", "seq.yaml", "--frames", "0-11", "--out", out};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Result result = umbrage(arguments);
        EXPECT_EQ(result.exitCode, 0) << result.err;
        std::vector<int> reused;
        const Json frames = statisticsIn(out)["frames"];
        for (const Json& frame : frames) {
            if (frame["values"]["frames.reused"] == 1) reused.push_back(frame["frame"]);
        }
        return reused;
    }

    Json statisticsIn(const std::string& out) const {
        return Json::parse(contentsOf(folder() / out / "statistics.json"));
    }

    bool isSameFile(const std::string& a, const std::string& b) const {
        return std::filesystem::equivalent(folder() / a, folder() / b);
    }
};

/// Without what a frame is allowed to differ in: what the device was asked for, and whether it was.
Json withoutDevice(Json frame) {
    Json& values = frame["values"];
    for (auto value = values.begin(); value != values.end();) {
        const std::string& name = value.key();
        const bool device = name.starts_with("device.") || name.starts_with("memory.") || name == "frames.reused";
        value = device ? values.erase(value) : std::next(value);
    }
    return frame;
}

TEST_F(Reuse, ChangesNoByteOfFilesAndNoNumber) {
    writeSequence(kPauses);
    EXPECT_THAT(reusedIn("off", {"--set", "shadow.skips.frames=off"}), testing::IsEmpty());
    for (const char* workers : {"1", "4"}) {
        const std::string out = std::string("on") + workers;
        EXPECT_EQ(reusedIn(out, {"--workers", workers}), kReused);
        ASSERT_EQ(filesIn(out), filesIn("off"));
        for (const std::string& file : filesIn(out)) {
            if (file.starts_with("statistics")) continue;
            EXPECT_EQ(contentsOf(folder() / out / file), contentsOf(folder() / "off" / file)) << file;
        }
        const Json on = statisticsIn(out)["frames"], off = statisticsIn("off")["frames"];
        ASSERT_EQ(on.size(), 12u);
        for (std::size_t i = 0; i < on.size(); ++i) EXPECT_EQ(withoutDevice(on[i]), withoutDevice(off[i])) << i;
    }
    EXPECT_EQ(Json::parse(contentsOf(folder() / "on1/manifest.json"))["images"],
              Json::parse(contentsOf(folder() / "off/manifest.json"))["images"]);
}

TEST_F(Reuse, AsksTheDeviceForNothing) {
    writeSequence(kPauses);
    ASSERT_EQ(reusedIn("out"), kReused);
    const Json frames = statisticsIn("out")["frames"];
    for (const Json& frame : frames) {
        const bool reused = frame["values"]["frames.reused"] == 1;
        for (const char* counter :
             {"device.draws", "device.dispatches", "device.stateChanges", "device.uploaded", "device.readBack"}) {
            EXPECT_EQ(frame["values"][counter] == 0, reused) << counter << " of frame " << frame["frame"];
        }
    }
    const std::string page = contentsOf(folder() / "out/statistics.html");
    std::size_t thumbnails = 0;
    for (std::size_t at = 0; (at = page.find("data:image/png;base64,", at)) != page.npos; ++at) ++thumbnails;
    EXPECT_EQ(thumbnails, 12u) << "each frame has its own, whether it was rendered or not";
}

TEST_F(Reuse, ALaterRunReplacesOneFrameAndNotThoseLinkedToIt) {
    writeSequence(kPauses);
    ASSERT_EQ(reusedIn("out"), kReused);
    ASSERT_TRUE(isSameFile("out/beauty.0003.png", "out/beauty.0006.png"));
    const std::string before = contentsOf(folder() / "out/beauty.0006.png");
    ASSERT_EQ(umbrage({"render", "seq.yaml", "--frames", "3", "--set", "color.exposure=2", "--out", "out"}).exitCode,
              0);
    EXPECT_NE(contentsOf(folder() / "out/beauty.0003.png"), before);
    EXPECT_EQ(contentsOf(folder() / "out/beauty.0006.png"), before);
    ASSERT_EQ(reusedIn("out"), kReused) << "over links that are there";
    EXPECT_EQ(contentsOf(folder() / "out/beauty.0003.png"), before);
    for (const std::string& file : filesIn("out")) EXPECT_THAT(file, testing::Not(testing::StartsWith(".")));
}

TEST_F(Reuse, MotionLooksAtTheFrameBeforeToo) {
    writeSequence(kPauses);
    EXPECT_THAT(reusedIn("out", {"--set", "output.aovs.motion=exr"}), ElementsAre(5, 6, 10, 11))
        << "frame 4 has the lamp where it was in frame 3, which had it elsewhere before";
}

TEST_F(Reuse, ChannelsThatHoldOneValueAreLeftOutAndChangeNoByte) {
    std::string held = kPauses;
    const std::string moving = "{0: [1, 3, 2], 0.125: [2, 3, 1], 0.25: [2, 3, 1], 0.375: [1, 3, 2]}";
    held.replace(held.find(moving), moving.size(), "{0: [0.1, 3.3, 1.7], 0.125: [0.1, 3.3, 1.7]}");
    held.replace(held.find("animations: []\n"), 15, "");  // the lantern's own goes on
    writeSequence(held);
    reusedIn("off", {"--set", "shadow.skips={channels: off, frames: off}"});
    reusedIn("on", {"--set", "shadow.skips.frames=off"});
    EXPECT_EQ(statisticsIn("off")["frames"][0]["values"]["channels.idle"], 0);
    EXPECT_EQ(statisticsIn("on")["frames"][0]["values"]["channels.idle"], 1);
    for (const std::string& file : filesIn("on")) {
        if (file.starts_with("statistics")) continue;
        EXPECT_EQ(contentsOf(folder() / "on" / file), contentsOf(folder() / "off" / file)) << file;
    }
}

TEST_F(Reuse, IsExplained) {
    writeSequence(kPauses);
    const Result result = umbrage({"render", "seq.yaml", "--frames", "0-11", "--explain"});
    EXPECT_EQ(result.exitCode, 0) << result.err;
    EXPECT_THAT(result.out, testing::StartsWith("frame 0\n  456 triangles in 5 placed meshes\n  light "));
    EXPECT_THAT(result.out, testing::HasSubstr("frames 4-6: as frame 3, and not rendered again\n"
                                               "frame 7: as frame 2, and not rendered again\n"));
    EXPECT_THAT(result.out, testing::HasSubstr("  lights_key "));
    EXPECT_THAT(result.out, testing::HasSubstr("(casters.outOfReach)\n"));
    std::string dark = kPauses;
    dark.replace(dark.find("intensity: 60"), 13, "intensity: 0");
    writeSequence(dark);
    const Result off =
        umbrage({"render", "seq.yaml", "--frames", "0-3", "--explain", "--set", "shadow.skips.frames=off"});
    EXPECT_THAT(off.out, testing::HasSubstr("; 1 lights left out\n"));
    EXPECT_THAT(off.out, testing::HasSubstr("  lights_key (off)\n"));
    EXPECT_THAT(off.out, testing::HasSubstr("frames 1-3: as frame 0\n"));
    EXPECT_EQ(umbrage({"render", "seq.yaml", "--explain", "--dry-run"}).exitCode, 2);
}

TEST_F(Reuse, FramesWithTheirNumberOnThemAndMeasuredOnesAreTheirOwn) {
    writeSequence(kPauses);
    EXPECT_EQ(reusedIn("a", {"--set", "diagnostics.overlays=[overdraw]"}), kReused);
    EXPECT_THAT(reusedIn("b", {"--set", "diagnostics={overlays: [overdraw], burnIn: true}"}), testing::IsEmpty());
    EXPECT_THAT(reusedIn("c", {"--set", "diagnostics.overlays=[techniques]"}), testing::IsEmpty());
    EXPECT_THAT(reusedIn("d", {"--set", "diagnostics.profile=true"}), testing::IsEmpty());
}

}  // namespace
}  // namespace umbrage::cli
