// SPDX-License-Identifier: Apache-2.0
// Split planes: what they pass through, which side is which, and what stands for a tile.
#include "shadow/split_plane.h"

#include <gtest/gtest.h>

#include <random>

namespace umbrage {
namespace {

constexpr Homogeneous kPoint{1.0, 4.0, -2.0, 1.0}, kDirection{0.3, 1.0, 0.2, 0.0};

double at(const Plane& plane, const Homogeneous& p) {
    return glm::dot(plane, p) / glm::length(glm::dvec3(plane));
}

Eye eyeAt(const glm::dvec3& position, bool perspective) {
    PlacedCamera placed;
    placed.worldFromCamera = glm::inverse(glm::lookAt(position, glm::dvec3(0.0), glm::dvec3(0.0, 1.0, 0.0)));
    placed.camera = {.name = {}, .perspective = perspective, .yfov = 0.9, .ymag = 3.0, .znear = 0.1, .zfar = 50.0};
    return makeEye(placed, 400, 300);
}

TEST(SplitPlane, PointCameraLightHoldsThePointAndTheLightOfEitherKind) {
    const glm::dvec3 p(0.5, 0.1, 0.3);
    for (const Homogeneous& light : {kPoint, kDirection}) {
        for (const Homogeneous& eye : {Homogeneous(5.0, 2.0, 7.0, 1.0), Homogeneous(0.1, 0.6, 1.0, 0.0)}) {
            const Plane plane = pointCameraLight(p, eye, light);
            EXPECT_NEAR(at(plane, {p, 1.0}), 0.0, 1e-12);
            EXPECT_NEAR(at(plane, light), 0.0, 1e-12);
        }
    }
}

TEST(SplitPlane, PointCameraLightIsTheFourthEquation) {
    const glm::dvec3 p(0.5, 0.1, 0.3), c(5.0, 2.0, 7.0), l(kPoint);
    const glm::dvec3 printed = glm::cross(glm::cross(c - l, p - l), p - l);
    const Plane plane = pointCameraLight(p, {c, 1.0}, kPoint);
    EXPECT_NEAR(glm::distance(glm::dvec3(plane), printed), 0.0, 1e-12 * glm::length(printed));
    EXPECT_NEAR(plane.w, -glm::dot(printed, l), 1e-12 * glm::length(printed) * glm::length(l));
}

TEST(SplitPlane, PointPointLightHoldsBothPointsAndTheLightOfEitherKind) {
    const glm::dvec3 p(0.5, 0.1, 0.3), q(-2.0, 3.0, 1.0);
    for (const Homogeneous& light : {kPoint, kDirection}) {
        const Plane plane = pointPointLight(p, q, light);
        EXPECT_NEAR(at(plane, {p, 1.0}), 0.0, 1e-12);
        EXPECT_NEAR(at(plane, {q, 1.0}), 0.0, 1e-12);
        EXPECT_NEAR(at(plane, light), 0.0, 1e-12);
    }
}

TEST(SplitPlane, PixelsPassWhereWhatIsSeenLiesOnTheEyesSide) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> coordinate(-2.0, 2.0);
    for (const bool perspective : {true, false}) {
        const Eye eye = eyeAt({4.0, 3.0, 6.0}, perspective);
        for (int i = 0; i < 200; ++i) {
            const glm::dvec3 seen(coordinate(random), coordinate(random), coordinate(random));
            const Plane plane(coordinate(random), coordinate(random), coordinate(random), coordinate(random));
            const glm::dvec4 clip = eye.clipFromView * (eye.viewFromWorld * glm::dvec4(seen, 1.0));
            const glm::dvec2 ndc = VIEWPORT_SCALE * glm::dvec2(clip) / clip.w;
            const bool sameSide = glm::dot(plane, glm::dvec4(seen, 1.0)) * glm::dot(plane, eye.point()) > 0.0;
            EXPECT_EQ(screenPlane(plane, eye).passes(ndc, clip.z / clip.w), sameSide);
            EXPECT_EQ(screenPlane(-plane, eye).passes(ndc, clip.z / clip.w), sameSide) << "either way round";
        }
    }
}

TEST(SplitPlane, AnEyeInThePlaneMakesEveryPixelZFail) {
    const Eye eye = eyeAt({0.0, 0.0, 6.0}, true);
    const ScreenPlane plane = screenPlane(Plane(1.0, 0.0, 0.0, 0.0), eye);
    EXPECT_FALSE(plane.passes({0.5, 0.0}, 0.01));
    EXPECT_FALSE(plane.passes({-0.5, 0.0}, 0.01));
}

TEST(SplitPlane, TheFarthestDepthOfATileFavoursZFail) {
    const Eye eye = eyeAt({0.0, 0.0, 6.0}, true);
    const ScreenPlane plane = screenPlane(Plane(0.0, 0.0, 1.0, 0.0), eye);  // z = 0, 6 metres away
    const double nearest = 0.1 / 5.0, farthest = 0.1 / 7.0;
    EXPECT_TRUE(tilePasses(plane, {0.0, 0.0}, nearest, farthest, SplitAgainst::Nearest));
    EXPECT_FALSE(tilePasses(plane, {0.0, 0.0}, nearest, farthest, SplitAgainst::Farthest));
}

TEST(SplitPlane, ThinPartsTakeTheirAxisUnlessItPointsAtTheLight) {
    std::vector<glm::dvec3> pole;
    for (int i = 0; i < 40; ++i) pole.emplace_back(0.1 * (i % 2), 0.1 * (i / 2 % 2), 0.25 * i);
    const PartShape shape = shapeOf(pole);
    EXPECT_EQ(automaticKind(shape, {9.0, 0.0, 5.0, 1.0}), SplitPlaneKind::PointPointLight);
    EXPECT_EQ(automaticKind(shape, {0.01, 0.01, 1.0, 0.0}), SplitPlaneKind::PointCameraLight);
    const PartShape cube = shapeOf(std::vector<glm::dvec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}});
    EXPECT_EQ(automaticKind(cube, {9.0, 0.0, 5.0, 1.0}), SplitPlaneKind::PointCameraLight);
}

TEST(SplitPlane, PointsGivenByHandWin) {
    SplitChoice choice;
    choice.kind = SplitPlaneKind::PointCameraLight;
    choice.points = {glm::dvec3(1.0, 0.0, 0.0), glm::dvec3(0.0, 1.0, 0.0)};
    const Plane plane = splitPlane({}, choice, {0.0, 0.0, 5.0, 1.0}, kPoint);
    EXPECT_EQ(plane, pointPointLight({1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, kPoint));
}

}  // namespace
}  // namespace umbrage
