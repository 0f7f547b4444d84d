// SPDX-License-Identifier: Apache-2.0
// Guesses of what a split plane costs: where shadows are, and which samples cost something.
#include "shadow/split_estimate.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace umbrage {
namespace {

Eye eyeAtZ(double z, bool perspective) {
    PlacedCamera placed;
    placed.worldFromCamera = glm::translate(glm::dmat4(1.0), glm::dvec3(0.0, 0.0, z));
    placed.camera = {.name = {}, .perspective = perspective, .yfov = 0.9, .ymag = 6.0, .znear = 0.1, .zfar = 50.0};
    return makeEye(placed, 300, 300);
}

std::vector<glm::dvec3> cube(double half) {
    std::vector<glm::dvec3> corners;
    for (int i = 0; i < 8; ++i) {
        corners.push_back(half * glm::dvec3(i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, i & 4 ? 1.0 : -1.0));
    }
    return corners;
}

DepthSample seen(const Eye& eye, const glm::dvec3& p) {
    const glm::dvec4 clip = eye.clipFromView * (eye.viewFromWorld * glm::dvec4(p, 1.0));
    return {VIEWPORT_SCALE * glm::dvec2(clip) / clip.w, clip.z / clip.w};
}

bool holds(const std::vector<glm::dvec4>& shadow, const DepthSample& s) {
    return std::all_of(shadow.begin(), shadow.end(),
                       [&](const glm::dvec4& p) { return glm::dot(p, glm::dvec4(s.ndc, s.depth, 1.0)) >= 0.0; });
}

TEST(SplitEstimate, TheShadowOfACubeIsBehindItAsTheLightSeesIt) {
    for (const bool perspective : {true, false}) {
        const Eye eye = eyeAtZ(12.0, perspective);
        for (const Homogeneous& light : {Homogeneous(0.0, 10.0, 0.0, 1.0), Homogeneous(0.0, 1.0, 0.0, 0.0)}) {
            double perimeter = 0.0;
            const std::vector<glm::dvec4> shadow = shadowOnScreen(cube(1.0), light, eye, perimeter);
            ASSERT_FALSE(shadow.empty());
            EXPECT_TRUE(holds(shadow, seen(eye, {0.0, -3.0, 0.0})));
            EXPECT_TRUE(holds(shadow, seen(eye, {0.9, -3.0, 0.9})));
            EXPECT_FALSE(holds(shadow, seen(eye, {2.5, -3.0, 0.0})));
            EXPECT_FALSE(holds(shadow, seen(eye, {0.0, -3.0, -2.5})));
            EXPECT_FALSE(holds(shadow, seen(eye, {0.0, 3.0, 0.0}))) << "between light and cube";
            EXPECT_GT(perimeter, 7.0);
            EXPECT_LT(perimeter, 10.0);
        }
    }
}

TEST(SplitEstimate, ALightInTheHullShadowsAnything) {
    double perimeter = 0.0;
    EXPECT_TRUE(shadowOnScreen(cube(1.0), {0.1, 0.2, 0.0, 1.0}, eyeAtZ(12.0, true), perimeter).empty());
}

TEST(SplitEstimate, WhatIsSeenBeforeOrBehindAVolumeIsFreeWithASplitPlaneAndNotWithout) {
    const Eye eye = eyeAtZ(12.0, true);
    const Homogeneous light(0.0, 10.0, 0.0, 1.0);
    const PartOutline part{cube(1.0), 0.0};
    const SplitPoints through{{glm::dvec3(0.0), glm::dvec3(0.0)}, SplitPoints::Kind::PointCameraLight};
    const SplitPoints nowhere{{}, SplitPoints::Kind::Nowhere};
    const std::vector<DepthSample> before = {seen(eye, {0.0, -3.0, 4.0})};
    const std::vector<DepthSample> behind = {seen(eye, {0.0, -3.0, -4.0})};
    const auto cost = [&](const SplitPoints& made, const std::vector<DepthSample>& samples) {
        return expectedUpdates(part, screenPlane(made, light, eye), light, eye, samples);
    };
    EXPECT_EQ(cost(through, before), 0.0);
    EXPECT_EQ(cost(through, behind), 0.0);
    EXPECT_EQ(cost(nowhere, before), 0.0);
    EXPECT_EQ(cost(nowhere, behind), 2.0) << "the ray enters and leaves";
}

TEST(SplitEstimate, CapsCostSomethingWhereTheyAreCounted) {
    const Eye eye = eyeAtZ(12.0, true);
    const Homogeneous light(0.0, 10.0, 0.0, 1.0);
    const ScreenPlane everywhereByFail;  // an eye in the plane
    const auto cost = [&](const glm::dvec3& p) {
        const std::vector<DepthSample> samples = {seen(eye, p)};
        return expectedUpdates({cube(1.0), 0.0}, everywhereByFail, light, eye, samples);
    };
    EXPECT_EQ(cost({0.0, -6.0, -8.0}), 0.0) << "behind the volume, below the cube";
    EXPECT_EQ(cost({0.0, 0.0, -8.0}), 2.0) << "behind the cube";
}

TEST(SplitEstimate, LongerEdgesMakeMoreLayers) {
    const Eye eye = eyeAtZ(12.0, true);
    const Homogeneous light(0.0, 10.0, 0.0, 1.0);
    const ScreenPlane nowhere = screenPlane(SplitPoints{{}, SplitPoints::Kind::Nowhere}, light, eye);
    const std::vector<DepthSample> behind = {seen(eye, {0.0, -3.0, -4.0})};
    EXPECT_GT(expectedUpdates({cube(1.0), 80.0}, nowhere, light, eye, behind), 15.0);
}

}  // namespace
}  // namespace umbrage
