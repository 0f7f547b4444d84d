// SPDX-License-Identifier: Apache-2.0
// Ways of counting beside z-pass and z-fail: right where they claim it, and what becomes of a light where they do not.
#include <gmock/gmock.h>

#include "counter_checks.h"
#include "error.h"
#include "shadow/ledge.h"
#include "techniques.h"

namespace umbrage::test {
namespace {

using testing::HasSubstr;

struct Outcome {
    FramePixels pixels;
    Statistics statistics;
    int wrong = 0, judged = 0;  // of the first light

    double value(const Counter& counter, const StatisticsPlace& place = {}) const {
        return statistics.file({}).frames.at(7).at(place).values.at(counter.index());
    }
};

Outcome outcomeOf(const TestScene& test, const std::string& count, WhenInexact whenInexact = WhenInexact::FallBack,
                  double extrusionMetres = 0.0) {
    FrameSettings settings;
    settings.width = kWidth;
    settings.height = kHeight;
    settings.count = count;
    settings.whenInexact = whenInexact;
    settings.extrusionMetres = extrusionMetres;
    const Moment moment = evaluate(test.scene, {}, 0.0);
    FrameRenderer renderer(test.scene, moment, settings, context());
    FrameOutputs outputs;
    outputs.shadows = outputs.geometry = outputs.figures = true;
    Outcome outcome;
    outcome.pixels = renderer.render(moment, test.placedCamera(), outputs, 7, outcome.statistics);
    const BruteForce bruteForce(test, moment, moment.lights[0], kWidth, kHeight);
    const auto mismatches = bruteForce.compare(outcome.pixels.lights[0].shadow, outcome.pixels.normalAndDepth);
    outcome.wrong = mismatches.wrong;
    outcome.judged = mismatches.judged;
    return outcome;
}

/// The light behind the viewer, a ball between them: its shadow holds the eye.
TestScene eyeInShadow() {
    TestScene test;
    test.add(ground(9.0f));
    test.add(sphere(2)).translation = {0.0, 2.6, 11.0};
    test.add(box({-0.5f, 0.0f, -0.5f}, {0.5f, 1.0f, 0.5f}));
    test.addLight(LightType::Point, {0.1, 3.7, 15.0});
    return test;
}

/// A card and a light close above it.
TestScene lightCloseToACard() {
    TestScene test;
    test.add(ground(6.0f));
    test.add(quad({-1, 1, 1}, {1, 1, 1}, {1, 1, -1}, {-1, 1, -1}), true);
    test.addLight(LightType::Point, {0.1, 1.01, 0.1});
    return test;
}

TEST(Counting, NearCapAndZPassPlusAreRightWithTheEyeInAVolume) {
    const TestScene test = eyeInShadow();
    for (const char* count : {"near-cap", "z-pass-plus"}) {
        const Outcome outcome = outcomeOf(test, count);
        EXPECT_EQ(outcome.wrong, 0) << count;
        EXPECT_GT(outcome.judged, kWidth);
        EXPECT_EQ(outcome.value("lights.fellBack"), 0.0);
    }
}

TEST(Counting, NearCapIsRightForCardsBeforeTheNearPlane) {
    for (const double at : {7.93, 7.96, 7.995}) {  // before and behind the plane of caps
        TestScene test;
        test.add(ground(9.0f));
        test.eye = {0.0, 2.0, 8.0};
        test.target = {0.0, 2.0, 0.0};
        test.add(quad({-.05f, 1.9f, 0}, {.02f, 1.9f, 0.02f}, {.02f, 2.05f, 0}, {-.05f, 2.05f, -0.02f}), true)
            .translation = {0.0, 0.0, at};
        test.addLight(LightType::Point, {0.3, 3.0, 8.5});
        test.addLight(LightType::Directional, {0.0, 0.4, 1.0});
        EXPECT_EQ(outcomeOf(test, "near-cap").wrong, 0) << at;
    }
}

TEST(FillOfNearCaps, CasesAreThoseOfASearchOverTriangles) {
    TestScene test;
    const Triangles ball = transformed(sphere(2), glm::translate(glm::mat4(1.0f), {0.0f, 2.4f, 9.0f}));
    test.add(ball);
    const Eye eye = [&] {
        Eye made = makeEye(test.placedCamera(), kWidth, kHeight);
        made.ledge = LEDGE;
        return made;
    }();
    for (const glm::dvec3& at : {glm::dvec3(0.1, 3.0, 12.0), glm::dvec3(0.3, 6.0, 8.9), glm::dvec3(0.1, 2.5, 9.1)}) {
        TestScene lit = test;
        lit.addLight(LightType::Point, at);
        const auto beyond = [&](const glm::dvec4& p) {
            const glm::dvec4 v = eye.viewFromWorld * p;
            return -v.z - double(float(capDistance(eye))) * v.w >= 0.0;
        };
        double trivial = 0, easy = 0, hard = 0;
        for (const auto& corners : ball) {
            int rays = 0, nearer = 0;
            for (const glm::vec3& corner : corners) {
                const glm::dvec4 p(corner, 1.0);
                rays += beyond(p) != beyond(p - glm::dvec4(at, 1.0));
                nearer += !beyond(p);
            }
            ++(rays == 3 ? easy : rays == 0 && nearer % 3 == 0 ? trivial : hard);
        }
        const Outcome outcome = outcomeOf(lit, "near-cap");
        const StatisticsPlace place{.light = outcome.pixels.lights[0].id};
        expectCounter("caps.near.trivial", "a search over triangles", outcome.value("caps.near.trivial", place),
                      trivial);
        expectCounter("caps.near.easy", "a search over triangles", outcome.value("caps.near.easy", place), easy);
        expectCounter("caps.near.hard", "a search over triangles", outcome.value("caps.near.hard", place), hard);
        EXPECT_GT(easy + hard, 0.0);
    }
}

TEST(Counting, VolumesThatEndCollapseNearALightWhereInfiniteOnesDoNot) {
    const TestScene test = lightCloseToACard();
    EXPECT_EQ(outcomeOf(test, "z-fail").wrong, 0);
    const double beyondAll = 30.0;  // more than from the light to any corner of the ground
    const Outcome forced = outcomeOf(test, "z-fail-finite", WhenInexact::Allow, beyondAll);
    EXPECT_GT(forced.wrong, 1000);
    EXPECT_TRUE(forced.pixels.notes.empty());
    const Outcome fellBack = outcomeOf(test, "z-fail-finite", WhenInexact::FallBack, beyondAll);
    EXPECT_EQ(fellBack.wrong, 0);
    EXPECT_EQ(fellBack.value("lights.fellBack"), 1.0);
    const Outcome clipped = outcomeOf(test, "z-fail-finite");
    EXPECT_EQ(clipped.wrong, 0);
    EXPECT_EQ(clipped.value("lights.fellBack"), 0.0);
}

TEST(Counting, VolumesThatEndBeyondWhatIsLitAreRight) {
    TestScene test;
    test.add(sphere(2)).translation = {0.0, 2.0, 0.0};
    test.add(box({-0.5f, -1.5f, -0.5f}, {0.5f, -0.5f, 0.5f}));
    test.addLight(LightType::Point, {0.5, 6.0, 0.5});
    test.addLight(LightType::Directional, {0.5, 2.0, 0.5});
    for (const bool perspective : {true, false}) {
        test.camera.perspective = perspective;
        test.camera.ymag = 4.0;
        test.camera.zfar = perspective ? 0.0 : 40.0;
        for (const double extrusion : {0.0, 40.0}) {
            const Outcome outcome = outcomeOf(test, "z-fail-finite", WhenInexact::FallBack, extrusion);
            EXPECT_EQ(outcome.wrong, 0);
            EXPECT_EQ(outcome.value("lights.fellBack"), 0.0);
            EXPECT_EQ(outcome.value("casters.ended", {.light = outcome.pixels.lights[0].id}) > 0.0, extrusion == 0.0);
        }
    }
}

TEST(Counting, ParityIsRightWhereNoVolumesOverlap) {
    TestScene test;
    test.add(sphere(2)).translation = {-1.5, 1.5, 0.0};
    test.add(sphere(2)).translation = {1.5, 1.5, 0.0};
    test.add(box({-5.0f, -0.1f, -5.0f}, {5.0f, 0.0f, 5.0f}));
    test.addLight(LightType::Point, {0.0, 7.0, 0.0});
    const Outcome outcome = outcomeOf(test, "invert", WhenInexact::Refuse);
    EXPECT_EQ(outcome.wrong, 0);
}

TEST(Counting, LightsThatAreNotCountedExactlyFallBackAndSaySoOnce) {
    TestScene test;
    test.add(ground(6.0f));
    test.add(sphere(2)).translation = {0.0, 1.5, 0.0};
    test.add(sphere(2)).translation = {0.0, 4.0, 0.0};
    test.addLight(LightType::Point, {0.0, 9.0, 0.0});
    EXPECT_GT(outcomeOf(test, "invert", WhenInexact::Allow).wrong, 20);
    const Outcome outcome = outcomeOf(test, "invert");
    EXPECT_EQ(outcome.wrong, 0);
    EXPECT_EQ(outcome.value("lights.fellBack"), 1.0);
    ASSERT_EQ(outcome.pixels.notes.size(), 1u);
    EXPECT_THAT(outcome.pixels.notes[0], HasSubstr("counted by z-pass where invert is not exact: some count is even"));

    FrameSettings settings;
    settings.count = "invert";
    settings.width = kWidth;
    settings.height = kHeight;
    const Moment moment = evaluate(test.scene, {}, 0.0);
    FrameRenderer renderer(test.scene, moment, settings, context());
    Statistics statistics;
    EXPECT_EQ(renderer.render(moment, test.placedCamera(), {}, 1, statistics).notes.size(), 1u);
    EXPECT_TRUE(renderer.render(moment, test.placedCamera(), {}, 2, statistics).notes.empty());
}

TEST(Counting, CountersTellHowManyLightsFellBack) {
    TestScene test;
    test.add(sphere(2)).translation = {0.0, 1.5, 0.0};
    test.add(sphere(2)).translation = {0.0, 4.0, 0.0};
    double overlapping = 0;
    for (const glm::dvec3& at : {glm::dvec3(0.0, 9.0, 0.0), glm::dvec3(0.3, 8.0, 0.0), glm::dvec3(9.0, 2.5, 0.0)}) {
        test.addLight(LightType::Point, at);
        overlapping += at.y > 5.0;  // one ball in the other's shadow
    }
    const Outcome outcome = outcomeOf(test, "invert");
    expectCounter("lights.fellBack", "balls in line with the light", outcome.value("lights.fellBack"), overlapping);
}

TEST(Counting, WhatIsRefusedNamesFrameLightAndRemedy) {
    TestScene test = lightCloseToACard();
    try {
        outcomeOf(test, "z-fail-finite", WhenInexact::Refuse, 30.0);
        FAIL() << "was not refused";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::Input);
        const Moment moment = evaluate(test.scene, {}, 0.0);
        EXPECT_EQ(error.where(), "frame 7, light " + moment.lights[0].id);
        EXPECT_THAT(error.message(), HasSubstr("end before what it shades"));
        EXPECT_THAT(error.hint(), HasSubstr("shadow.whenInexact"));
    }
}

TEST(Counting, ALightInTheNearPlaneIsLeftToZPass) {
    TestScene test = eyeInShadow();
    test.target = test.eye - glm::dvec3(0.0, 0.0, 1.0);
    test.scene.nodes.back().translation = {2.0, 3.0, 7.9};  // the near plane is at 0.1
    const Outcome outcome = outcomeOf(test, "z-pass-plus");
    EXPECT_EQ(outcome.wrong, 0);
    EXPECT_EQ(outcome.value("lights.fellBack"), 1.0);
}

TEST(Counting, DepthsOnTheLedgeLeavePicturesAsTheyAre) {
    const TestScene test = eyeInShadow();
    const Outcome ledge = outcomeOf(test, "near-cap"), plain = outcomeOf(test, "z-pass");
    EXPECT_EQ(ledge.pixels.normalAndDepth, plain.pixels.normalAndDepth);
}

}  // namespace
}  // namespace umbrage::test
