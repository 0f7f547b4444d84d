// SPDX-License-Identifier: Apache-2.0
// What right files mean.
#include <filesystem>
#include <fstream>
#include <numbers>

#include "expect_error.h"
#include "job/output_path.h"

namespace umbrage {
namespace {

using testing::ElementsAre;
using testing::Pair;

const char* const kEverything = R"(umbrage: 1
scene:
  - gltf: ../scenes/courtyard.gltf
  - gltf: ../scenes/knight.glb
    scene: 1
    at: /Courtyard/Knights
    translate: [1, 0, -2.5]
    rotate: [0, 90, 0]
    scale: 2
  - over:
      "/Courtyard/Lamp*": {light: {intensity: 40}}
      "/Courtyard/Torch": {light: {intensity: {0: 0, 1: 60, 2: 0}, interpolation: step, outerConeAngle: 30}}
lights:
  - {type: point, name: key, color: [1, .9, .8], intensity: 120, position: {0: [0,3,0], 2: [4,3,0]}}
  - {type: spot, name: rim, position: [0, 5, 0], target: {2: [1, 0, 0], -1: [0, 0, 0]}, innerConeAngle: 10}
camera: /Courtyard/Cam
animations: [0, walk]
time: {fps: 24, frames: 1-48}
image: {size: [800, 600], samples: 4, background: [.1, .2, .3], ambient: {sky: [1, 1, 1], ground: [0, 0.5, 0]}}
displace:
  "/Courtyard/Orb": {kind: noise, amplitude: .1, frequency: 2, speed: -1}
shadow: {count: z-pass, silhouette: cpu, enabled: true, eyeConstant: off, skips: {range: no}}
color: {config: ../colour/config.ocio, display: Rec.1886, view: Untonemapped, exposure: -1.5}
diagnostics: {overlays: [stencil, overdraw], profile: yes}
output:
  path: ../out/courtyard/{aov}.{frame:04}.{ext}
  aovs: {beauty: png, depth: exr, shadow: exr, overdraw: exr}
  pngBits: 16
  exrHalf: false
statistics: {path: ../out/courtyard/statistics.json}
)";

TEST(Job, ReadsTheSceneAndItsLayers) {
    const Job job = read(kEverything);
    ASSERT_EQ(job.gltfLayers.size(), 2u);
    EXPECT_EQ(job.gltfLayers[0].file.value, "/scenes/courtyard.gltf");
    EXPECT_EQ(job.gltfLayers[0].at.value, "");
    EXPECT_EQ(job.gltfLayers[0].transform.scale, (std::array{1.0, 1.0, 1.0}));
    const GltfLayer& knight = job.gltfLayers[1];
    EXPECT_EQ(knight.file.value, "/scenes/knight.glb");
    EXPECT_EQ(knight.file.place.text(), "s.yaml:4:11");
    EXPECT_EQ(knight.scene.value, "1");
    EXPECT_EQ(knight.at.value, "/Courtyard/Knights");
    EXPECT_EQ(knight.at.place.text(), "s.yaml:6:9");
    EXPECT_EQ(knight.transform.translate, (std::array{1.0, 0.0, -2.5}));
    EXPECT_EQ(knight.transform.rotateDegrees, (std::array{0.0, 90.0, 0.0}));
    EXPECT_EQ(knight.transform.scale, (std::array{2.0, 2.0, 2.0}));

    ASSERT_EQ(job.overLayers.size(), 2u);
    EXPECT_EQ(job.overLayers[0].glob.value, "/Courtyard/Lamp*");
    EXPECT_EQ(job.overLayers[0].glob.place.text(), "s.yaml:11:7");
    EXPECT_FALSE(job.overLayers[0].light.intensity->animated());
    EXPECT_FALSE(job.overLayers[0].light.color.has_value());
    const LightOpinion& torch = job.overLayers[1].light;
    EXPECT_THAT(torch.intensity->timesSeconds, ElementsAre(0, 1, 2));
    EXPECT_THAT(torch.intensity->values, ElementsAre(ElementsAre(0), ElementsAre(60), ElementsAre(0)));
    EXPECT_EQ(torch.intensity->place.text(), "s.yaml:12:47");
    EXPECT_EQ(torch.interpolation, KeyInterpolation::Step);
    EXPECT_NEAR(torch.outerConeAngle->values[0][0], std::numbers::pi / 6, 1e-15);
}

TEST(Job, ReadsLightsAndCamera) {
    const Job job = read(kEverything);
    ASSERT_EQ(job.lights.size(), 2u);
    const JobLight& key = job.lights[0];
    EXPECT_EQ(key.type, JobLightType::Point);
    EXPECT_EQ(key.name.value, "key");
    EXPECT_THAT(key.light.color->values, ElementsAre(ElementsAre(1, .9, .8)));
    EXPECT_THAT(key.position.timesSeconds, ElementsAre(0, 2));
    EXPECT_THAT(key.position.values, ElementsAre(ElementsAre(0, 3, 0), ElementsAre(4, 3, 0)));
    const JobLight& rim = job.lights[1];
    EXPECT_EQ(rim.type, JobLightType::Spot);
    EXPECT_THAT(rim.position.values, ElementsAre(ElementsAre(0, 5, 0)));
    EXPECT_THAT(rim.target.timesSeconds, ElementsAre(-1, 2)) << "a mapping has no order, time has";
    EXPECT_THAT(rim.target.values, ElementsAre(ElementsAre(0, 0, 0), ElementsAre(1, 0, 0)));
    EXPECT_EQ(job.camera.node.value, "/Courtyard/Cam");
    EXPECT_FALSE(job.camera.described);
}

TEST(Job, ReadsSettings) {
    const Job job = read(kEverything);
    ASSERT_TRUE(job.animations.has_value());
    ASSERT_EQ(job.animations->size(), 2u);
    EXPECT_EQ((*job.animations)[0].value, "0");
    EXPECT_EQ((*job.animations)[1].value, "walk");
    EXPECT_EQ(job.time.framesPerSecond, 24);
    EXPECT_EQ(job.time.frames.text(), "1-48");
    EXPECT_EQ(job.image.width, 800);
    EXPECT_EQ(job.image.height, 600);
    EXPECT_EQ(job.image.samples, 4);
    EXPECT_THAT(job.image.background, ElementsAre(.1, .2, .3));
    EXPECT_THAT(job.image.ambientSky, ElementsAre(1, 1, 1));
    EXPECT_THAT(job.image.ambientGround, ElementsAre(0, .5, 0));
    ASSERT_EQ(job.displacements.size(), 1u);
    EXPECT_EQ(job.displacements[0].glob.value, "/Courtyard/Orb");
    EXPECT_EQ(job.displacements[0].amplitude.values[0][0], .1);
    EXPECT_EQ(job.displacements[0].frequency, 2);
    EXPECT_EQ(job.displacements[0].speed, -1);
    EXPECT_EQ(job.shadow.count, "z-pass");
    EXPECT_EQ(job.shadow.silhouette, "cpu");
    EXPECT_FALSE(job.shadow.eyeConstant);
    EXPECT_THAT(job.shadow.skips, ElementsAre(Pair("range", false)));
    EXPECT_EQ(job.color.config, "/colour/config.ocio");
    EXPECT_EQ(job.color.display, "Rec.1886");
    EXPECT_EQ(job.color.view, "Untonemapped");
    EXPECT_EQ(job.color.exposureStops, -1.5);
    EXPECT_THAT(job.diagnostics.overlays, ElementsAre("stencil", "overdraw"));
    EXPECT_TRUE(job.diagnostics.profile);
    EXPECT_THAT(job.output.aovs, ElementsAre(Pair("beauty", "png"), Pair("depth", "exr"), Pair("overdraw", "exr"),
                                             Pair("shadow", "exr")));
    EXPECT_EQ(job.output.pngBits, 16);
    EXPECT_FALSE(job.output.exrHalf);
    EXPECT_EQ(job.statistics.path, "/out/courtyard/statistics.json");
    EXPECT_EQ(outputPath(job, "shadow", 7, "exr"), "/out/courtyard/shadow.0007.exr");
}

TEST(Job, TheSmallestFileHasTheDefaultsOfTheStruct) {
    const Job job = read(sequence(""));
    const Job plain;
    EXPECT_EQ(job.time.frames.text(), "1");
    EXPECT_EQ(job.image.width, plain.image.width);
    EXPECT_EQ(job.shadow.count, "auto");
    EXPECT_FALSE(job.animations.has_value());
    EXPECT_TRUE(job.camera.node.value.empty());
    EXPECT_FALSE(job.camera.described);
    EXPECT_TRUE(job.lights.empty());
    EXPECT_EQ(outputPath(job, "beauty", 1, "png"), "/seq/beauty.0001.png");
    EXPECT_EQ(job.file, "s.yaml");
}

TEST(Job, DefaultsOfSampledPositionsAreOnePoint) {
    const Job job = read(sequence("lights: [{type: directional, name: sun}]\ncamera: {}\n"));
    EXPECT_THAT(job.lights[0].position.values, ElementsAre(ElementsAre(0, 0, 0)));
    EXPECT_THAT(job.lights[0].target.values, ElementsAre(ElementsAre(0, 0, -1)));
    EXPECT_TRUE(job.camera.described);
    EXPECT_THAT(job.camera.position.values, ElementsAre(ElementsAre(0, 0, 5)));
}

TEST(Job, AnEmptyListOfAnimationsMeansNone) {
    const Job job = read(sequence("animations: []\n"));
    ASSERT_TRUE(job.animations.has_value());
    EXPECT_TRUE(job.animations->empty());
}

TEST(Job, ACameraCanBeAnIndexOrDescribed) {
    EXPECT_EQ(read(sequence("camera: 1\n")).camera.node.value, "1");
    const Job job =
        read(sequence("camera: {type: orthographic, position: {0: [0, 0, 1], 1: [0, 0, 2]}, ymag: 3, zfar: 50, "
                      "interpolation: step}\n"));
    EXPECT_TRUE(job.camera.described);
    EXPECT_FALSE(job.camera.perspective);
    EXPECT_TRUE(job.camera.position.animated());
    EXPECT_EQ(job.camera.ymag, 3);
    EXPECT_EQ(job.camera.zfar, 50);
    EXPECT_EQ(job.camera.interpolation, KeyInterpolation::Step);
}

TEST(Job, ACameraByItsNumericNameIsQuoted) {
    EXPECT_EQ(read(sequence("camera: \"0010\"\n")).camera.node.value, "0010");
}

TEST(Job, AnAmbientColourIsTheSameFromEverywhere) {
    const Job job = read(sequence("image: {ambient: [.1, .2, .3]}\n"));
    EXPECT_EQ(job.image.ambientSky, job.image.ambientGround);
    EXPECT_THAT(job.image.ambientSky, ElementsAre(.1, .2, .3));
}

TEST(Job, FramesAreDecimalAndMayBeAList) {
    EXPECT_EQ(read(sequence("time: {frames: 0010}\n")).time.frames.text(), "10");
    EXPECT_EQ(read(sequence("time: {frames: 0008-0019}\n")).time.frames.text(), "8-19");
    EXPECT_EQ(read(sequence("time: {frames: -5--2}\n")).time.frames.text(), "-5--2");
    EXPECT_EQ(read(sequence("time:\n  frames: 1-3,10\n")).time.frames.text(), "1-3,10");
    EXPECT_EQ(read(sequence("time: {frames: [1-3, 0010, \"20-30x5\"]}\n")).time.frames.text(), "1-3,10,20-30x5");
}

TEST(Job, AliasesStandForWhatTheyName) {
    const Job job = read(sequence("image: {background: &grey [.5, .5, .5], ambient: *grey}\n"));
    EXPECT_EQ(job.image.background, job.image.ambientSky);
}

TEST(Job, AFileIsReadFromItsFolder) {
    const auto folder = std::filesystem::temp_directory_path() / "umbrage job test";
    std::filesystem::create_directories(folder);
    std::ofstream(folder / "a.yaml") << sequence("output: {path: \"o/{scene}.{frame}.png\"}\n");
    const Job job = readJob(folder / "a.yaml");
    EXPECT_EQ(job.file, folder / "a.yaml");
    EXPECT_EQ(job.gltfLayers[0].file.value, folder / "a.glb");
    EXPECT_EQ(outputPath(job, "beauty", -3, "png"), folder / "o/a.-3.png");
    std::filesystem::remove_all(folder);
}

TEST(Job, AFileThatIsNotThereAndAFolderAreRefused) {
    expectError([] { readJob("/nowhere/s.yaml"); }, {"/nowhere/s.yaml", "No such file", ""});
    expectError([] { readJob("/"); }, {"/", "folder", ""});
}

TEST(JobForScene, RendersFrameOneIntoTheWorkingDirectory) {
    const Job job = jobForScene("models/knight.glb");
    ASSERT_EQ(job.gltfLayers.size(), 1u);
    EXPECT_EQ(job.gltfLayers[0].file.value, "models/knight.glb");
    EXPECT_EQ(job.file, "models/knight.glb");
    EXPECT_EQ(job.time.frames.text(), "1");
    EXPECT_EQ(outputPath(job, "beauty", 1, "png"), "out/knight/beauty.0001.png");
}

TEST(JobForScene, TakesOverrides) {
    const Job job = jobForScene("123", {{"image.size=[64, 48]", "time.frames=1-3", "scene.0.at=/Figures"}});
    EXPECT_EQ(job.gltfLayers[0].file.value, "123") << "a file name is a string even if it looks like a number";
    EXPECT_EQ(job.image.width, 64);
    EXPECT_EQ(job.time.frames.text(), "1-3");
    EXPECT_EQ(job.gltfLayers[0].at.value, "/Figures");
    expectError([] { jobForScene("a.glb", {{"image.sice=1"}}); }, {"--set image.sice", "unknown key", "\"size\""});
}

}  // namespace
}  // namespace umbrage
