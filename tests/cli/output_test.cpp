// SPDX-License-Identifier: Apache-2.0
// What a run writes: which files, with which channels and values, and what becomes of outputs that cannot be written
// (exit code 5).
#include <OpenImageIO/imageio.h>
#include <sys/mount.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <cstring>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>

#include "triangle.h"
#include "workspace.h"

namespace umbrage::cli {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr const char* kEveryAov =
    "output:\n"
    "  path: \"out/{aov}.{frame:04}.{ext}\"\n"
    "  aovs: {beauty: exr, depth: exr, normal: exr, shadow: exr, stencil: exr, overdraw: exr}\n";

std::vector<std::string> linesOf(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

/// A file system over a folder of the test's, as long as this lives.
class Mounted {
public:
    Mounted(const std::filesystem::path& folder, unsigned long flags, const char* options) : folder_(folder) {
        std::filesystem::create_directories(folder);
        if (::mount("tmpfs", folder.c_str(), "tmpfs", flags, options) != 0) problem_ = std::strerror(errno);
    }
    ~Mounted() {
        if (problem_.empty()) ::umount(folder_.c_str());
    }
    Mounted(const Mounted&) = delete;
    Mounted& operator=(const Mounted&) = delete;
    const std::string& problem() const { return problem_; }

private:
    std::filesystem::path folder_;
    std::string problem_;
};

class Output : public Workspace {
protected:
    void expectUnwritable(const std::vector<std::string>& more, const std::string& message) const {
        std::vector<std::string> arguments{"render", "seq.yaml"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Result result = umbrage(arguments);
        EXPECT_EQ(result.exitCode, 5);
        EXPECT_THAT(result.out, IsEmpty());
        EXPECT_THAT(result.err, testing::EndsWith("umbrage: error: " + message + "\n"));
    }
};

TEST_F(Output, ADryRunPrintsTheFilesThatARunWrites) {
    writeSequence(std::string(kEveryAov) + "diagnostics: {overlays: [stencil, overdraw]}\n");
    const Result dry = umbrage({"render", "seq.yaml", "--dry-run"});
    EXPECT_EQ(dry.exitCode, 0);
    EXPECT_FALSE(std::filesystem::exists(folder() / "out")) << "a dry run writes nothing";
    std::vector<std::string> announced = linesOf(dry.out);
    std::sort(announced.begin(), announced.end());
    EXPECT_EQ(announced.size(), 3u * 8u);

    const Result result = umbrage({"render", "seq.yaml"});
    EXPECT_EQ(result.exitCode, 0) << result.err;
    EXPECT_THAT(result.out, IsEmpty()) << "pictures are the only data of a run";
    std::vector<std::string> written;
    for (const std::string& file : filesIn("out")) written.push_back("out/" + file);
    EXPECT_EQ(written, announced);
}

TEST_F(Output, EveryAovHasItsChannelsAndFiniteValues) {
    writeSequence(kEveryAov);
    ASSERT_EQ(umbrage({"render", "seq.yaml", "--frames", "1"}).exitCode, 0);
    const auto channels = [&](const char* aov) {
        return channelsOf(folder() / "out" / (std::string(aov) + ".0001.exr"));
    };
    EXPECT_THAT(channels("beauty"), ElementsAre("R", "G", "B"));
    EXPECT_THAT(channels("depth"), ElementsAre("Z"));
    EXPECT_THAT(channels("normal"), ElementsAre("N.X", "N.Y", "N.Z"));
    EXPECT_THAT(channels("shadow"), ElementsAre("shadow.Box_BoxLight", "shadow.Cage_CageLight"));
    EXPECT_THAT(channels("stencil"), ElementsAre("stencil.Box_BoxLight", "stencil.Cage_CageLight"));
    EXPECT_THAT(channels("overdraw"), ElementsAre("overdraw.fragments", "overdraw.updates"));
    for (const std::string& file : filesIn("out")) {
        for (const double value : valuesOf(folder() / "out" / file)) ASSERT_TRUE(std::isfinite(value)) << file;
    }
    EXPECT_THAT(valuesOf(folder() / "out/shadow.0001.exr"), testing::Each(testing::AnyOf(0.0, 1.0)));
    EXPECT_THAT(valuesOf(folder() / "out/shadow.0001.exr"),
                testing::AllOf(testing::Contains(0.0), testing::Contains(1.0)));
    EXPECT_THAT(valuesOf(folder() / "out/stencil.0001.exr"), testing::Contains(testing::Ge(1.0)));
}

TEST_F(Output, WhereNothingIsSeenOnlyDepthIsInfinite) {
    writeFile("empty.yaml", "umbrage: 1\nscene: [{gltf: \"" + sceneFile("pole") +
                                "\"}]\nimage: {size: [64, 48]}\n"
                                "camera: {position: [0, 50, 0], target: [0, 60, 1]}\n" +
                                kEveryAov);
    ASSERT_EQ(umbrage({"render", "empty.yaml"}).exitCode, 0);
    const auto values = [&](const char* aov) { return valuesOf(folder() / "out" / (std::string(aov) + ".0001.exr")); };
    EXPECT_THAT(values("depth"), testing::Each(std::numeric_limits<double>::infinity()));
    for (const char* aov : {"beauty", "normal", "shadow"}) EXPECT_THAT(values(aov), testing::Each(0.0)) << aov;
    for (const char* aov : {"stencil", "overdraw"}) {
        EXPECT_THAT(values(aov), testing::Each(testing::Truly([](double v) { return std::isfinite(v); }))) << aov;
    }
}

TEST_F(Output, OverlaysArePicturesOfTheirOwn) {
    writeSequence("diagnostics: {overlays: [stencil, overdraw]}\n");
    ASSERT_EQ(umbrage({"render", "seq.yaml", "--frames", "2", "--out", "out"}).exitCode, 0);
    EXPECT_THAT(filesIn("out"),
                ElementsAre("beauty.0002.png", "overlay-overdraw.0002.png", "overlay-stencil.0002.png"));
    const std::vector<double> beauty = valuesOf(folder() / "out/beauty.0002.png");
    for (const char* overlay : {"out/overlay-stencil.0002.png", "out/overlay-overdraw.0002.png"}) {
        EXPECT_THAT(channelsOf(folder() / overlay), ElementsAre("R", "G", "B"));
        EXPECT_NE(valuesOf(folder() / overlay), beauty) << overlay;
    }
    EXPECT_NE(valuesOf(folder() / "out/overlay-stencil.0002.png"),
              valuesOf(folder() / "out/overlay-overdraw.0002.png"));
}

/// Pixels of exactly that colour.
int pixelsOf(const std::vector<double>& rgb, int red, int green, int blue) {
    int count = 0;
    for (std::size_t i = 0; i < rgb.size(); i += 3) {
        count += std::lround(255.0 * rgb[i]) == red && std::lround(255.0 * rgb[i + 1]) == green &&
                 std::lround(255.0 * rgb[i + 2]) == blue;
    }
    return count;
}

TEST_F(Output, OverlaysDrawSilhouettesInYellowAndContoursInInk) {
    writeSequence("diagnostics: {overlays: [extraction, toon], only: true}\n");
    for (const char* silhouette : {"compute", "vertex-reject"}) {
        SCOPED_TRACE(silhouette);
        ASSERT_EQ(umbrage({"render", "seq.yaml", "--frames", "2", "--out", silhouette, "--set",
                           std::string("shadow.silhouette=") + silhouette})
                      .exitCode,
                  0);
        const auto overlay = [&](const char* name) {
            return valuesOf(folder() / silhouette / ("overlay-" + std::string(name) + ".0002.png"));
        };
        EXPECT_GT(pixelsOf(overlay("extraction"), 255, 225, 0), 20);
        const std::vector<double> toon = overlay("toon");
        EXPECT_GT(pixelsOf(toon, 0, 0, 0), 50);
        EXPECT_EQ(pixelsOf(toon, 0, 0, 0) + pixelsOf(toon, 255, 255, 255), 64 * 48) << "only ink and paper";
    }
}

TEST_F(Output, StatisticsHaveEveryFrameAndLight) {
    writeSequence("statistics: {path: out/numbers.json}\noutput: {path: \"out/{aov}.{frame:04}.{ext}\"}\n");
    ASSERT_EQ(umbrage({"render", "seq.yaml"}).exitCode, 0);
    const nlohmann::json json = nlohmann::json::parse(contentsOf(folder() / "out/numbers.json"));
    ASSERT_EQ(json["frames"].size(), 3u);
    for (int i = 0; i < 3; ++i) {
        const nlohmann::json& frame = json["frames"][std::size_t(i)];
        EXPECT_EQ(frame["frame"], i + 1);
        EXPECT_EQ(frame["values"]["triangles"], 456);
        ASSERT_EQ(frame["lights"].size(), 2u);
        for (const char* light : {"Box_BoxLight", "Cage_CageLight"}) {
            EXPECT_GT(frame["lights"][light]["values"]["edges.silhouette"], 0);
            EXPECT_GT(frame["lights"][light]["values"]["overdraw.fragments"], 0);
        }
        for (const auto& [name, value] : frame["values"].items()) EXPECT_TRUE(json["counters"].contains(name)) << name;
    }

    ASSERT_EQ(umbrage({"render", "seq.yaml", "--set", "statistics.path=out/numbers.csv"}).exitCode, 0);
    const std::vector<std::string> lines = linesOf(contentsOf(folder() / "out/numbers.csv"));
    ASSERT_FALSE(lines.empty());
    EXPECT_EQ(lines[0], "frame,light,caster,material,counter,unit,value");
    for (const std::string frame : {"1", "2", "3"}) {
        EXPECT_THAT(lines, testing::Contains(frame + ",,,,triangles,count,456"));
        for (const char* light : {"Box_BoxLight", "Cage_CageLight"}) {
            EXPECT_THAT(lines, testing::Contains(testing::StartsWith(frame + "," + light + ",,,quads,count,")));
        }
    }
    for (const std::string& line : lines) EXPECT_EQ(std::count(line.begin(), line.end(), ','), 6) << line;
}

TEST_F(Output, ProfilingAddsTheTimeOfEachPass) {
    writeSequence("statistics: {path: out/numbers.json}\ndiagnostics: {profile: true}\n");
    ASSERT_EQ(umbrage({"render", "seq.yaml", "--frames", "1"}).exitCode, 0);
    const nlohmann::json json = nlohmann::json::parse(contentsOf(folder() / "out/numbers.json"));
    for (const char* pass :
         {"time.gbuffer", "time.silhouettes", "time.counts", "time.resolve", "time.encode", "time.frame"}) {
        EXPECT_GT(json["frames"][0]["values"][pass], 0.0) << pass;
    }
    EXPECT_THAT(json["clock"].get<std::string>(), testing::Not(IsEmpty()));
}

TEST_F(Output, OutReplacesTheFolderPart) {
    writeSequence("output: {path: \"a/b/{scene}/{aov}.{frame}.{ext}\"}\nstatistics: {path: a/numbers.csv}\n");
    ASSERT_EQ(umbrage({"render", "seq.yaml", "--frames", "1", "--out", "there"}).exitCode, 0);
    EXPECT_THAT(filesIn("there"), ElementsAre("beauty.1.png", "numbers.csv"));
    EXPECT_FALSE(std::filesystem::exists(folder() / "a"));
}

TEST_F(Output, OutKeepsFoldersThatTellImagesApart) {
    writeSequence("output: {path: \"a/{aov}/{frame:04}.{ext}\", aovs: {depth: exr, normal: exr}}\n");
    ASSERT_EQ(umbrage({"render", "seq.yaml", "--frames", "1", "--out", "there"}).exitCode, 0);
    EXPECT_THAT(filesIn("there"), ElementsAre("depth/0001.exr", "normal/0001.exr"));
}

TEST_F(Output, TheSizeIsTheOneAskedFor) {
    writeSequence();
    ASSERT_EQ(umbrage({"render", "seq.yaml", "--frames", "1", "--size", "40x30", "--out", "out"}).exitCode, 0);
    const auto input = OIIO::ImageInput::open((folder() / "out/beauty.0001.png").string());
    ASSERT_TRUE(input);
    EXPECT_EQ(input->spec().width, 40);
    EXPECT_EQ(input->spec().height, 30);
}

TEST_F(Output, ACameraIsChosenByPathNameOrIndex) {
    const auto picture = [&](const std::vector<std::string>& camera, const std::string& out) {
        std::vector<std::string> arguments{"render", sceneFile("nested"), "--size", "64x48", "--out", out};
        arguments.insert(arguments.end(), camera.begin(), camera.end());
        const Result result = umbrage(arguments);
        EXPECT_EQ(result.exitCode, 0) << result.err;
        return contentsOf(folder() / out / "beauty.0001.png");
    };
    const std::string first = picture({}, "first"), path = picture({"--camera", "/Outside"}, "path");
    EXPECT_EQ(picture({"--camera", "/Camera"}, "camera"), first) << "the file's first camera is the default";
    EXPECT_NE(path, first);
    EXPECT_EQ(picture({"--camera", "Outside"}, "name"), path);
    EXPECT_EQ(picture({"--camera", "1"}, "index"), path);
}

TEST_F(Output, ASceneWithoutYamlRendersFrameOne) {
    const Result result = umbrage({"render", sceneFile("pole"), "--size", "64x48"});
    EXPECT_EQ(result.exitCode, 0) << result.err;
    EXPECT_THAT(filesIn("."), ElementsAre("out/pole/beauty.0001.png"));
}

TEST_F(Output, ASceneWithoutCameraAndLightsGetsThemAndSaysSo) {
    writeFile("triangle.gltf", triangleGltf(false));
    const Result result = umbrage({"render", "triangle.gltf", "--size", "64x48"});
    EXPECT_EQ(result.exitCode, 0) << result.err;
    EXPECT_THAT(result.err, HasSubstr("no camera"));
    EXPECT_THAT(result.err, HasSubstr("no lights"));
    EXPECT_THAT(valuesOf(folder() / "out/triangle/beauty.0001.png"), testing::Contains(testing::Gt(0.1)));
}

TEST_F(Output, AnEmptySceneIsAPictureOfItsBackground) {
    writeFile("empty.gltf", R"({"asset": {"version": "2.0"}})");
    const Result result = umbrage({"render", "empty.gltf", "--size", "32x24", "--set", "image.background=[1, 0, 0]"});
    EXPECT_EQ(result.exitCode, 0) << result.err;
    const std::vector<double> values = valuesOf(folder() / "out/empty/beauty.0001.png");
    ASSERT_EQ(values.size(), 32u * 24u * 3u);
    for (std::size_t i = 0; i < values.size(); ++i) ASSERT_EQ(values[i], values[i % 3]);
    EXPECT_GT(values[0], values[1] + 0.5);
}

TEST_F(Output, AllFramesOfASceneAreThoseOfItsFirstAnimation) {
    writeFile("triangle.gltf", triangleGltf(true));
    const Result dry = umbrage({"render", "triangle.gltf", "--frames", "all", "--dry-run"});
    EXPECT_EQ(dry.exitCode, 0) << dry.err;
    const std::vector<std::string> files = linesOf(dry.out);
    ASSERT_EQ(files.size(), 12u) << "0.5 s at 24 frames/second";
    EXPECT_EQ(files.front(), "out/triangle/beauty.0001.png");
    EXPECT_EQ(files.back(), "out/triangle/beauty.0012.png");

    EXPECT_EQ(umbrage({"render", "triangle.gltf", "--frames", "all", "--size", "32x24"}).exitCode, 0);
    EXPECT_EQ(filesIn("out/triangle").size(), 12u);
    const auto count = [&](const char* assignment) {
        return linesOf(umbrage({"render", "triangle.gltf", "--frames", "all", "--dry-run", "--set", assignment}).out)
            .size();
    };
    EXPECT_EQ(count("animations=[long]"), 72u);
    EXPECT_EQ(count("time.fps=10"), 5u);
    EXPECT_EQ(count("time.fps=9"), 5u) << "the last frame is at the animation's end or just after it";
}

TEST_F(Output, AllFramesNeedNamesOfTheirOwn) {
    writeFile("triangle.gltf", triangleGltf(true));
    const Result result = umbrage({"render", "triangle.gltf", "--frames", "all", "--set", "output.path=x.png"});
    EXPECT_EQ(result.exitCode, 3);
    EXPECT_THAT(result.err,
                HasSubstr("the output path has no {frame}, but all frames would have this name (add {frame:04})"));
}

TEST_F(Output, AllFramesOfASceneThatStandsStillAreOne) {
    writeFile("triangle.gltf", triangleGltf(false));
    const Result result = umbrage({"render", "triangle.gltf", "--frames", "all", "--size", "32x24"});
    EXPECT_EQ(result.exitCode, 0) << result.err;
    EXPECT_THAT(result.err, HasSubstr("the scene has no animation, so all its frames are frame 1"));
    EXPECT_THAT(filesIn("out"), ElementsAre("triangle/beauty.0001.png"));
}

TEST_F(Output, AFolderThatCannotBeMadeIsNamed) {
    writeSequence("statistics: {path: out/numbers.json}\n");
    writeFile("plain", "");
    const std::string hint = " (make room or choose another place with --out)";
    expectUnwritable({"--out", "plain/below"},
                     "plain/below/beauty.0001.png: cannot make the folder: Not a directory" + hint);
    expectUnwritable({"--out", "/proc/nowhere"},
                     "/proc/nowhere/beauty.0001.png: cannot make the folder: No such file or directory" + hint);
    expectUnwritable({"--set", "statistics.path=plain/numbers.json", "--set", "output.aovs={}"},
                     "plain/numbers.json: cannot make the folder: Not a directory" + hint);
    EXPECT_EQ(contentsOf(folder() / "plain"), "");
}

TEST_F(Output, AFolderThatMustNotBeWrittenToIsNamed) {
    writeSequence();
    const std::filesystem::path out = folder() / "out";
    const std::string hint = " (make room or choose another place with --out)";
    if (::geteuid() != 0) {
        std::filesystem::create_directories(out);
        std::filesystem::permissions(out, std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec);
        expectUnwritable({"--out", "out"},
                         "out/beauty.0001.png: cannot write into this folder: Permission denied" + hint);
        return;
    }
    const Mounted readOnly(out, MS_RDONLY, "");
    if (!readOnly.problem().empty()) GTEST_SKIP() << "no read-only folder can be mounted: " << readOnly.problem();
    expectUnwritable({"--out", "out"},
                     "out/beauty.0001.png: cannot write into this folder: Read-only file system" + hint);
}

TEST_F(Output, AFullDiskLeavesWholeFilesOnly) {
    writeSequence("output: {aovs: {beauty: exr}, exrHalf: off}\n");
    ASSERT_EQ(umbrage({"render", "seq.yaml", "--out", "whole"}).exitCode, 0);
    const Mounted small(folder() / "out", 0, "size=32k");
    if (!small.problem().empty()) GTEST_SKIP() << "no small disk can be mounted: " << small.problem();
    const Result result = umbrage({"render", "seq.yaml", "--out", "out"});
    EXPECT_EQ(result.exitCode, 5);
    EXPECT_THAT(result.err,
                HasSubstr("cannot write: No space left on device (make room or choose another place with --out)"));
    EXPECT_LT(filesIn("out").size(), 3u);
    for (const std::string& file : filesIn("out")) {
        EXPECT_EQ(contentsOf(folder() / "out" / file), contentsOf(folder() / "whole" / file)) << file;
    }
}

}  // namespace
}  // namespace umbrage::cli
