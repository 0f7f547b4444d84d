// SPDX-License-Identifier: Apache-2.0
// Bench files say what is meant, or where they are wrong.
#include "bench/bench_file.h"

#include <gmock/gmock.h>

#include <filesystem>

#include "bench/bench_scene.h"
#include "error.h"
#include "job/names.h"

namespace umbrage {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Bench read(const std::string& yaml) {
    return parseBench(yaml, "b.yaml", "/somewhere/bench");
}

void expectRefused(const std::string& yaml, const std::string& place, const std::string& message) {
    SCOPED_TRACE(yaml);
    try {
        read(yaml);
        ADD_FAILURE() << "accepted";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::Input);
        EXPECT_THAT(error.what(), HasSubstr(place));
        EXPECT_THAT(error.what(), HasSubstr(message));
    }
}

TEST(BenchFile, NamesSequencesByTheirFilesAndFindsThemFromItsFolder) {
    const Bench bench = read("bench: 1\nsequences: [{file: ../a.yaml}, {file: b.yaml, name: other, measure: []}]\n");
    ASSERT_EQ(bench.sequences.size(), 2u);
    EXPECT_EQ(bench.sequences[0].name, "a");
    EXPECT_EQ(bench.sequences[0].file.value, "/somewhere/a.yaml");
    EXPECT_EQ(bench.sequences[1].file.value, "/somewhere/bench/b.yaml");
    EXPECT_THAT(bench.measureOf(bench.sequences[0]), ElementsAre("times"));
    EXPECT_TRUE(bench.measureOf(bench.sequences[1]).empty());
}

TEST(BenchFile, ReadsTechniquesPlanesAndPictures) {
    const Bench bench = read(
        "bench: 1\n"
        "sequences: [{file: a.yaml, casters: [/A, /B], together: true, splitPlane: point-point-light, frames: 1-9x2}]\n"
        "techniques: [\"cpu:z-fail\", \"compute:z-pass\"]\n"
        "pictures: [{name: p, frame: 3, panels: [{sequence: a, method: SPSV}, {sequence: a, method: best, frame: "
        "4}]}]\n"
        "curves: [{name: c, sequence: a}]\n");
    ASSERT_EQ(bench.techniques.size(), 2u);
    EXPECT_EQ(bench.techniques[0].name(), "cpu:z-fail");
    EXPECT_EQ(bench.sequences[0].splitPlane.kind, SplitPlaneKind::PointPointLight);
    EXPECT_EQ(bench.sequences[0].frames->frames().size(), 5u);
    ASSERT_EQ(bench.pictures.size(), 1u);
    EXPECT_EQ(bench.pictures[0].panels[1].frame, 4);
    EXPECT_FALSE(bench.pictures[0].panels[0].frame.has_value());
}

TEST(BenchFile, PlainTechniquesHaveNoSkips) {
    const Bench bench = read("bench: 1\nsequences: [{file: a.yaml}]\ntechniques: [plain cpu:z-fail, compute:z-pass]\n");
    ASSERT_EQ(bench.techniques.size(), 2u);
    EXPECT_EQ(bench.techniques[0].name(), "plain cpu:z-fail");
    const Job plain = bench.techniques[0].of({}), usual = bench.techniques[1].of({});
    EXPECT_EQ(plain.shadow.silhouette, "cpu");
    EXPECT_EQ(plain.shadow.count, "z-fail");
    for (const NameAndMeaning& skip : kSkips) EXPECT_FALSE(plain.shadow.skips.at(std::string(skip.name)));
    EXPECT_TRUE(usual.shadow.skips.empty());
}

TEST(BenchFile, WhatASequenceLeavesOpenIsChosenForTheDevice) {
    const Bench bench = parseBench(
        "bench: 1\nsequences: [{file: knight.yaml}, {file: knight.yaml, name: own, set: "
        "[shadow.silhouette=geometry-shader]}]\n",
        "b.yaml", UMBRAGE_SOURCE_DIR "/configs");
    for (const bool software : {true, false}) {
        gpu::DeviceInfo device;
        device.software = software;
        const Technique rendered = techniqueOf(chosenFor(bench.jobOf(bench.sequences[0]), device));
        const BenchScene scene(bench, bench.sequences[0], false, device), own(bench, bench.sequences[1], false, device);
        EXPECT_EQ(techniqueOf(scene.job).name(), rendered.name());
        EXPECT_EQ(own.job.shadow.silhouette, "geometry-shader");
    }
}

TEST(BenchFile, TheTracerTakesPartWhereItIsWanted) {
    const Bench bench = read(
        "bench: 1\ntracer: true\nmeasure: [error]\noffsets: [1.0e-3, 0]\n"
        "sequences: [{file: a.yaml}, {file: b.yaml, tracer: false}]\n");
    EXPECT_TRUE(bench.tracerFor(bench.sequences[0]));
    EXPECT_FALSE(bench.tracerFor(bench.sequences[1]));
    EXPECT_THAT(bench.offsets, ElementsAre(1e-3, 0.0));
    EXPECT_FALSE(read("bench: 1\nsequences: [{file: a.yaml}]\n").tracer);
    expectRefused("bench: 1\nsequences: [{file: a.yaml}]\noffsets: [-1]\n", "b.yaml:3:11", "-1");
    expectRefused("bench: 1\nsequences: [{file: a.yaml}]\noffsets: []\n", "b.yaml:3:10", "is empty");
}

TEST(BenchFile, RefusesWithThePlaceAndAHint) {
    expectRefused("", "b.yaml", "a bench begins with bench: 1");
    expectRefused("umbrage: 1\nscene: []\n", "b.yaml", "this is a sequence file");
    expectRefused("bench: 2\nsequences: [{file: a.yaml}]\n", "b.yaml:1:8", "1");
    expectRefused("bench: 1\n", "b.yaml", "lacks the key \"sequences\"");
    expectRefused("bench: 1\nsequences: []\n", "b.yaml:2:12", "is empty");
    expectRefused("bench: 1\nsequences: [{file: a.yaml}]\nround: 3\n", "b.yaml:3:1", "rounds");
    expectRefused("bench: 1\nsequences: [{file: a.yaml, method: x}]\n", "b.yaml:2:28", "unknown key");
    expectRefused("bench: 1\nsequences: [{file: a.yaml}]\ntechniques: [z-pass]\n", "b.yaml:3:14", "z-pass");
    expectRefused("bench: 1\nsequences: [{file: a.yaml, together: true}]\n", "b.yaml:2:38", "casters: [GLOB]");
    expectRefused("bench: 1\nsequences: [{file: a.yaml}, {file: x/a.yaml}]\n", "b.yaml:2:12", "\"a\"");
    expectRefused("bench: 1\nsequences: [{file: a.yaml}]\ncurves: [{name: c, sequence: b}]\n", "b.yaml:3:30",
                  "there is no sequence \"b\"");
    expectRefused("bench: 1\nsequences: [{file: a.yaml}]\ncurves: [{name: x/c, sequence: a}]\n", "b.yaml:3:17",
                  "slashes");
    expectRefused("bench: 1\nsequences: [{file: a.yaml}]\npictures: [{name: p, panels: []}]\n", "b.yaml:3:30",
                  "is empty");
}

TEST(BenchFile, SequencesTakeTheBenchsSizeAndTheirOwnChanges) {
    const std::filesystem::path configs = std::filesystem::path(UMBRAGE_SOURCE_DIR) / "configs";
    const Bench bench =
        parseBench("bench: 1\nsize: [32, 16]\nsequences: [{file: pole.yaml, frames: 5, set: [shadow.count=z-fail]}]\n",
                   "b.yaml", configs);
    const Job job = bench.jobOf(bench.sequences[0]);
    EXPECT_EQ(job.image.width, 32);
    EXPECT_EQ(job.image.height, 16);
    EXPECT_EQ(job.shadow.count, "z-fail");
    EXPECT_THAT(job.time.frames.frames(), ElementsAre(5));
}

TEST(BenchFile, OursAreRight) {
    std::size_t files = 0;
    for (const auto& entry :
         std::filesystem::directory_iterator(std::filesystem::path(UMBRAGE_SOURCE_DIR) / "configs/bench")) {
        const Bench bench = readBench(entry.path());
        for (const BenchSequence& sequence : bench.sequences) EXPECT_NO_THROW(bench.jobOf(sequence)) << entry.path();
        ++files;
    }
    EXPECT_GE(files, 2u);
}

}  // namespace
}  // namespace umbrage
