// SPDX-License-Identifier: Apache-2.0
#include "shadow/ledge.h"

#include <gtest/gtest.h>

#include <array>

#include "shadow/bounds.h"

namespace umbrage {
namespace {

/// Window depth of a point at a distance, for a projection to [n, f] between planes at N and F.
double depthOf(const DepthRange& range, double distance) {
    const auto& [n, f, N, F] = range;
    return n + (f - n) * F * (distance - N) / (distance * (F - N));
}

/// The formula as it is printed: the term with `nearest` has the other sign.
double asPrinted(const DepthRange& scene, double nearest) {
    const auto& [n, f, N, F] = scene;
    return -(f - n) * F * N / (n * N - f * F - nearest * (F - N));
}

constexpr DepthRange kScene{0.1, 1.0, 0.5, 80.0};

TEST(Ledge, WithoutOneTheNearPlaneStaysWhereAsPrintedItDoesNot) {
    EXPECT_NEAR(nearPlaneWithLedge(kScene, kScene.n), kScene.N, 1e-12);
    EXPECT_GT(std::abs(asPrinted(kScene, kScene.n) - kScene.N), 1e-3);
}

TEST(Ledge, DepthsOfBothProjectionsAgreeAtEveryDistance) {
    const DepthRange ledge{0.0, kScene.f, nearPlaneWithLedge(kScene, 0.0), kScene.F};
    EXPECT_LT(ledge.N, kScene.N);
    for (const double distance : {0.5, 0.51, 1.0, 7.0, 79.0, 80.0}) {
        EXPECT_NEAR(depthOf(ledge, distance), depthOf(kScene, distance), 1e-12) << distance;
    }
}

TEST(Ledge, ReversedAndInfiniteItIsAShareOfTheNearPlane) {
    // Forward depth 1 - (1 - share) N / e with F without end, seen the other way round.
    const DepthRange scene{0.25, 1.0, 0.5, 1e12};
    EXPECT_NEAR(nearPlaneWithLedge(scene, 0.0), nearPlaneWithLedge(0.5, 0.25), 1e-9);
}

TEST(Ledge, CapsAreInItsMiddle) {
    Eye eye;
    eye.znear = 0.3;
    eye.ledge = 0.5;
    EXPECT_NEAR(nearPlaneWithLedge(eye.znear, eye.ledge) / capDistance(eye), 0.75, 1e-12);
    EXPECT_LT(capDistance(eye), eye.znear);
    eye.perspective = false;
    eye.znear = 0.0;
    eye.zfar = 20.0;
    EXPECT_NEAR(0.5 * (eye.zfar - capDistance(eye)) / (eye.zfar - eye.znear), 0.75, 1e-12);
    EXPECT_LT(capDistance(eye), 0.0);
}

TEST(Ledge, WithoutOneCountsCannotBeginBeforeTheNearPlane) {
    Eye eye;
    eye.znear = 0.3;
    EXPECT_DOUBLE_EQ(capDistance(eye), 0.3);
}

class Reach : public testing::Test {
protected:
    static bool mayReachFrom(const glm::dvec4& light, const glm::dvec3& at, bool perspective = true) {
        Eye eye;
        eye.perspective = perspective;
        std::array<glm::dvec3, 8> corners;
        for (std::size_t k = 0; k < 8; ++k) {
            corners[k] = at + 0.1 * glm::dvec3(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1);
        }
        return mayReach({eye, 1.0}, corners, light);
    }
};

TEST_F(Reach, WhatIsBetweenLightAndRectangleMay) {
    EXPECT_TRUE(mayReachFrom({0, 0, 5, 1}, {0, 0, 2}));
    EXPECT_TRUE(mayReachFrom({0, 0, -9, 1}, {0.2, 0.3, -4}));
    EXPECT_TRUE(mayReachFrom({0, 1, 1, 0}, {0.5, 3, 2}));
    EXPECT_TRUE(mayReachFrom({3, 0, -1, 1}, {1.5, 0, -1}));  // the light in the plane
    EXPECT_TRUE(mayReachFrom({0, 0, 5, 1}, {0, 0, -1}));     // cut by it
    EXPECT_TRUE(mayReachFrom({0, 0, 5, 1}, {0, 0, 5}));      // around the light
}

TEST_F(Reach, WhatIsBehindTheLightBeyondThePlaneOrAsideMayNot) {
    EXPECT_FALSE(mayReachFrom({0, 0, 5, 1}, {0, 0, 6}));
    EXPECT_FALSE(mayReachFrom({0, 0, 5, 1}, {0, 0, -3}));
    EXPECT_FALSE(mayReachFrom({0, 0, 5, 1}, {2, 0, 2}));
    EXPECT_FALSE(mayReachFrom({0, 0, 1, 0}, {2, 0, 2}));
    EXPECT_FALSE(mayReachFrom({0, 0, 1, 0}, {0, 0, -3}, false));
}

}  // namespace
}  // namespace umbrage
