// SPDX-License-Identifier: Apache-2.0
#include "job/overrides.h"

#include "expect_error.h"
#include "job/output_path.h"

namespace umbrage {
namespace {

const std::string kYaml = sequence(
    "lights:\n  - {type: point, name: a, intensity: 1}\n  - {type: point, name: b}\n"
    "camera: /Cam\ndisplace: {/A.b/C: {amplitude: 1}}\nshadow: {count: z-fail}\n");

Job with(std::vector<std::string> set) {
    return read(kYaml, {std::move(set)});
}

void expectRefusedOverride(const std::string& set, const Expected& expected) {
    SCOPED_TRACE(set);
    expectError([&] { with({set}); }, expected);
}

TEST(Overrides, ReplaceAddAndReachIntoLists) {
    const Job job = with({"shadow.count=z-pass", "shadow.silhouette=cpu", "image.size=[64, 48]", "time.frames=-5--2",
                          "lights.0.intensity=40", "lights.1.position={0: [1, 2, 3], 1: [0, 0, 0]}",
                          "output.aovs.depth=exr", "output.aovs.beauty=exr"});
    EXPECT_EQ(job.shadow.count, "z-pass");
    EXPECT_EQ(job.shadow.silhouette, "cpu");
    EXPECT_EQ(job.image.width, 64);
    EXPECT_EQ(job.time.frames.text(), "-5--2");
    EXPECT_EQ(job.lights[0].light.intensity->values[0][0], 40);
    EXPECT_TRUE(job.lights[1].position.animated());
    EXPECT_EQ(job.output.aovs.at("depth"), "exr");
    EXPECT_EQ(job.output.aovs.at("beauty"), "exr");
}

TEST(Overrides, TheLastOneWins) {
    EXPECT_EQ(with({"shadow.count=z-pass", "shadow.count=auto"}).shadow.count, "auto");
}

TEST(Overrides, KeysMayHaveDots) {
    EXPECT_EQ(with({"displace./A.b/C.amplitude=3"}).displacements[0].amplitude.values[0][0], 3);
}

TEST(Overrides, ValuesMayHaveEqualsSigns) {
    EXPECT_EQ(with({"camera=/A=B"}).camera.node.value, "/A=B");
}

TEST(Overrides, AWholePartCanBeReplaced) {
    const Job job = with({"camera={yfov: 30}", "camera.znear=.5", "lights=[]"});
    EXPECT_EQ(job.camera.yfovDegrees, 30);
    EXPECT_EQ(job.camera.znear, .5);
    EXPECT_TRUE(job.lights.empty());
}

TEST(Overrides, EveryCheckOfTheFileHoldsAndNamesTheOverride) {
    expectRefusedOverride("shadow.cuont=auto", {"--set shadow.cuont", "unknown key \"cuont\" in shadow", "\"count\""});
    expectRefusedOverride("shadwo.count=auto", {"--set shadwo.count", "unknown key \"shadwo\"", "\"shadow\""});
    expectRefusedOverride("shadow.count=z", {"--set shadow.count", "one of auto, z-pass, z-fail", ""});
    expectRefusedOverride("image.size=[64, x]", {"--set image.size", "integer from 1 to 16384, not \"x\"", ""});
    expectRefusedOverride("time.frames=1:10", {"--set time.frames", "has a ':'", "stagger"});
    expectRefusedOverride("lights.2.intensity=4",
                          {"--set lights.2.intensity", "\"2\" is not an entry of a list of 2", "0 to 1"});
    expectRefusedOverride("lights.a.intensity=4", {"--set lights.a.intensity", "\"a\" is not an entry", "0 to 1"});
    expectRefusedOverride("camera.yfov=4",
                          {"--set camera.yfov", "camera is \"/Cam\" here, which has no \"yfov\"", "set camera"});
    expectRefusedOverride("output.path=\"{aof}\"", {"--set output.path", "unknown field {aof}", "\"aov\""});
}

TEST(Overrides, BrokenOnesAreRefused) {
    for (const char* set : {"shadow.count", "=1", "shadow..count=1", ".count=1", "shadow.=1", ""}) {
        SCOPED_TRACE(set);
        try {
            with({set});
            ADD_FAILURE() << "it was accepted";
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::Usage);
            EXPECT_THAT(error.hint(), testing::HasSubstr("path=value"));
        }
    }
    expectRefusedOverride("image.size=[1", {"--set image.size", "", "YAML"});
    expectRefusedOverride("camera=", {"--set camera", "not nothing", ""});
    expectRefusedOverride("camera=\xff", {"--set camera", "UTF-8", ""});
    expectRefusedOverride("umbrage=2", {"--set umbrage", "umbrage must be 1", ""});
}

TEST(Overrides, OptionsAreNamedInErrorsAndComeBeforeSet) {
    const Job job = read(sequence(""), {.set = {"image.size=[8, 6]"}, .options = {{"--size", "image.size=[64, 48]"}}});
    EXPECT_EQ(job.image.width, 8);
    expectError(
        [] {
            read(sequence(""), {.set = {}, .options = {{"--frames", "time.frames='1:3'"}}});
        },
        {"--frames", "has a ':'", "stagger"});
}

TEST(Overrides, TheWholeAnimationIsForScenesWithoutYaml) {
    expectError([] { read(sequence(""), {.set = {}, .wholeAnimation = true}); },
                {"--frames all", "a sequence names its frames", "leave --frames out"});
    EXPECT_TRUE(jobForScene("a.glb", {.set = {}, .wholeAnimation = true}).time.wholeAnimation);
    expectError([] { jobForScene("a.glb", {.set = {"output.path=x.png"}, .wholeAnimation = true}); },
                {"--set output.path", "all frames would have this name", "{frame:04}"});
}

TEST(OutputPath, FillsItsFields) {
    Job job;
    job.file = "/seq/hall.day.yaml";
    job.output.path = "o/{scene}/{aov}_{frame:03}_{frame}.{{x}}.{ext}";
    EXPECT_EQ(outputPath(job, "depth", 7, "exr"), "o/hall.day/depth_007_7.{x}.exr");
    EXPECT_EQ(outputPath(job, "depth", -7, "exr"), "o/hall.day/depth_-07_-7.{x}.exr");
    EXPECT_EQ(outputPath(job, "depth", 12345, "exr"), "o/hall.day/depth_12345_12345.{x}.exr");
}

TEST(OutputPath, AFolderWithBracesIsNoTemplate) {
    const Job job = parseJob(sequence(""), "s.yaml", "/a{b}", {});
    EXPECT_EQ(outputPath(job, "beauty", 1, "png"), "/a{b}/beauty.0001.png");
}

TEST(OutputPath, AnAbsolutePathStays) {
    const Job job = read(sequence("output: {path: \"/o/{aov}.{frame:04}.{ext}\"}\n"));
    EXPECT_EQ(outputPath(job, "beauty", 1, "png"), "/o/beauty.0001.png");
}

TEST(OutputPath, RedirectingReplacesTheFolderOnly) {
    Job job = read(sequence("output: {path: \"o/{aov}.{ext}\"}\nstatistics: {path: o/s.csv, page: o/s.html}\n"));
    redirectOutput(job, "/new{1}");
    EXPECT_EQ(outputPath(job, "beauty", 1, "png"), "/new{1}/beauty.png");
    EXPECT_EQ(job.statistics.path, "/new{1}/s.csv");
    EXPECT_EQ(job.statistics.page, "/new{1}/s.html");
}

TEST(OutputPath, RedirectingKeepsFoldersThatTellImagesApart) {
    Job job = read(sequence("output: {path: \"o/{scene}/{aov}/{frame:04}.{ext}\"}\n"));
    redirectOutput(job, "/new");
    EXPECT_EQ(outputPath(job, "beauty", 1, "png"), "/new/beauty/0001.png");
}

}  // namespace
}  // namespace umbrage
