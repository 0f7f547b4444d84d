// SPDX-License-Identifier: Apache-2.0
// What verdicts add up to, and which runs pass.
#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "verdicts.h"

namespace umbrage {
namespace {

TEST(VerifySums, AreOneForEachSequenceAndTechniqueInTheirOrder) {
    const std::vector<VerifySum> sums = twoSequences().sums();
    ASSERT_EQ(sums.size(), 4u);
    const auto expect = [&](std::size_t i, const char* sequence, const char* technique, std::size_t frames) {
        EXPECT_EQ(sums[i].sequence, sequence);
        EXPECT_EQ(sums[i].technique, technique);
        EXPECT_EQ(sums[i].frames, frames);
    };
    expect(0, "A1", "compute:z-pass", 3);
    expect(1, "A1", "cpu:z-fail", 1);
    expect(2, "B1", "compute:z-pass", 3);
    expect(3, "B1", "cpu:z-fail", 1);
}

TEST(VerifySums, AddFiguresAndTakeTheLargestExtent) {
    VerifyReport report(header());
    LightVerdict first = light("Key", 4), second = light("Fill");
    first.hardFalseLit = 2;
    first.largestExtent = 9;
    second.excessToggles = 5;
    second.countsJudged = 1000;
    second.countErrors = 7;
    second.hardCountErrors = 3;
    second.largestCountError = 12;
    report.add("A1", true, frame(1, "compute:z-pass", {first, second}));
    report.add("A1", true, frame(2, "compute:z-pass", {light("Key"), light("Fill")}));
    const std::vector<VerifySum> sums = report.sums();
    ASSERT_EQ(sums.size(), 1u);
    const LightVerdict& all = sums[0].lights;
    EXPECT_EQ(all.litFacing, 4000u);
    EXPECT_EQ(all.exactDark, 1600u);
    EXPECT_EQ(all.hardFalseDark, 4u);
    EXPECT_EQ(all.hardFalseLit, 2u);
    EXPECT_EQ(all.band(), 8u);
    EXPECT_EQ(all.bandPopulation, 200u);
    EXPECT_EQ(all.largestComponent, 6u);
    EXPECT_EQ(all.largestExtent, 9);
    EXPECT_EQ(all.excessToggles, 5u);
    EXPECT_EQ(all.countsJudged, 1000u);
    EXPECT_EQ(all.countErrors, 7u);
    EXPECT_EQ(all.hardCountErrors, 3u);
    EXPECT_EQ(all.largestCountError, 12u);
    // Four lights' frames of two dark ones each, four hard dark and two hard lit ones; four outlines of 200 px.
    EXPECT_DOUBLE_EQ(all.signedBias(), (8.0 + 4.0 - 2.0) / 800.0);
}

TEST(VerifySums, TakeTheLargestRadianceErrorAndTheRootOfTheMeanSquare) {
    VerifyReport report(header());
    FrameVerdict quiet = frame(1, "compute:z-pass", {light("Key")}), loud = quiet;
    quiet.radiance = {0.0, 0.0, 0, 0.0};
    loud.radiance = {2.0, 0.5, 30, 4.0};
    report.add("A1", true, loud);
    report.add("A1", true, quiet);
    const RadianceError radiance = report.sums()[0].radiance;
    EXPECT_EQ(radiance.largest, 2.0);
    EXPECT_EQ(radiance.largestCode, 30);
    EXPECT_DOUBLE_EQ(radiance.rms, 0.5 / std::sqrt(2.0));
    EXPECT_DOUBLE_EQ(radiance.rmsCode, 4.0 / std::sqrt(2.0));
}

TEST(VerifySums, AnErrorThatIsNotANumberIsTheLargest) {
    for (const bool first : {true, false}) {
        VerifyReport report(header());
        FrameVerdict sound = frame(1, "compute:z-pass", {light("Key")}), broken = sound;
        broken.radiance.largest = std::numeric_limits<double>::quiet_NaN();
        report.add("A1", true, first ? broken : sound);
        report.add("A1", true, first ? sound : broken);
        EXPECT_TRUE(std::isnan(report.sums()[0].radiance.largest));
    }
}

TEST(VerifySums, TimesAreMedians) {
    VerifyReport report(header());
    for (const int number : {1, 9, 2}) report.add("A1", true, frame(number, "compute:z-pass", {light("Key")}));
    EXPECT_EQ(report.sums()[0].medianRenderMilliseconds, 20.0);
    report.add("A1", true, frame(4, "compute:z-pass", {light("Key")}));
    EXPECT_EQ(report.sums()[0].medianRenderMilliseconds, 30.0);
}

TEST(VerifySums, CanBeOneForEachFrameOrLight) {
    const VerifyReport report = twoSequences();
    const std::vector<VerifySum> frames = report.sums({.frames = true});
    ASSERT_EQ(frames.size(), 8u);
    EXPECT_EQ(frames[2].frame, 3);
    EXPECT_EQ(frames[2].frames, 1u);
    EXPECT_EQ(frames[2].lights.litFacing, 2000u);
    const std::vector<VerifySum> lights = report.sums({.lights = true});
    ASSERT_EQ(lights.size(), 8u);
    EXPECT_EQ(lights[0].light, "Key");
    EXPECT_EQ(lights[1].light, "Fill");
    EXPECT_EQ(lights[0].frames, 3u);
    EXPECT_EQ(lights[0].lights.litFacing, 3000u);
    EXPECT_EQ(report.sums({.frames = true, .lights = true}).size(), 16u);
}

TEST(VerifySums, OfTechniquesGoOverAllSequences) {
    const std::vector<VerifySum> sums = twoSequences().techniqueSums();
    ASSERT_EQ(sums.size(), 2u);
    EXPECT_EQ(sums[0].technique, "compute:z-pass");
    EXPECT_EQ(sums[0].frames, 6u);
    EXPECT_EQ(sums[0].lights.hard(), 0u);
    EXPECT_EQ(sums[1].frames, 2u);
    EXPECT_EQ(sums[1].lights.hard(), 1u);
}

TEST(VerifySums, AFrameWithoutLightsIsAFrame) {
    VerifyReport report(header());
    report.add("A1", true, frame(1, "compute:z-pass", {}));
    ASSERT_EQ(report.sums().size(), 1u);
    EXPECT_EQ(report.sums()[0].frames, 1u);
    EXPECT_TRUE(report.sums({.lights = true}).empty());
}

TEST(VerifyOutcome, HardErrorsOfMasksAndCountsFailWhoeverClaimsExactness) {
    VerifyReport clean(header());
    clean.add("A1", true, frame(1, "compute:z-pass", {light("Key")}));
    EXPECT_TRUE(clean.passed());

    EXPECT_EQ(twoSequences().errors(), 1u);
    EXPECT_FALSE(twoSequences().passed());

    VerifyReport counts(header());
    LightVerdict wrong = light("Key");
    wrong.hardCountErrors = 1;
    counts.add("A1", true, frame(1, "compute:z-pass", {wrong}));
    EXPECT_FALSE(counts.passed());
}

TEST(VerifyOutcome, WhoClaimsNothingFailsNothing) {
    VerifyReport report(header());
    report.add("B1", false, frame(1, "compute:z-pass", {light("Key", 70000)}));
    EXPECT_EQ(report.errors(), 0u);
    EXPECT_TRUE(report.passed());
    report.add("B1", true, frame(1, "compute:z-fail", {light("Key")}));
    EXPECT_TRUE(report.passed());
    EXPECT_FALSE(report.sums()[0].claimsExact);
}

TEST(VerifyOutcome, AsManyErrorsAsAllowedPassInAll) {
    VerifyHeader lenient = header();
    lenient.maxHard = 5;
    VerifyReport report(lenient);
    report.add("A1", true, frame(1, "compute:z-pass", {light("Key", 3), light("Fill", 2)}));
    EXPECT_TRUE(report.passed());
    report.add("B1", true, frame(1, "compute:z-fail", {light("Key", 1)}));
    EXPECT_FALSE(report.passed());
}

TEST(VerifyOutcome, WhatWasNotJudgedDidNotPass) {
    VerifyReport report(header());
    EXPECT_FALSE(report.anyProblem());
    report.addProblem("A1", "there is no such file");
    EXPECT_TRUE(report.anyProblem());
    EXPECT_FALSE(report.passed());
}

}  // namespace
}  // namespace umbrage
