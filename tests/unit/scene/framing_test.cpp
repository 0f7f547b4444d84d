// SPDX-License-Identifier: Apache-2.0
#include "scene/framing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace umbrage {
namespace {

/// Largest distances from the picture's middle, as shares of its half extents: left, right, below, above.
std::array<double, 4> room(const std::vector<glm::dvec3>& points, const glm::dvec3& eye, const glm::dvec2& half) {
    std::array<double, 4> most{-1e9, -1e9, -1e9, -1e9};
    for (const glm::dvec3& point : points) {
        const glm::dvec2 at = glm::dvec2(point - eye) / (half * (eye.z - point.z));
        most = {std::max(most[0], -at.x), std::max(most[1], at.x), std::max(most[2], -at.y), std::max(most[3], at.y)};
    }
    return most;
}

TEST(Framing, FillsTheTighterAxisAndCentresBothWhateverTheSize) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> value(-1.0, 1.0);
    for (const glm::dvec3 shape : {glm::dvec3(1, 1, 1), glm::dvec3(5, 0.1, 5), glm::dvec3(0.1, 3, 0.1),
                                   glm::dvec3(1e-6, 2e-6, 1e-6), glm::dvec3(1e5, 1, 1e5)}) {
        for (const glm::dvec2 half : {glm::dvec2(0.5, 0.4), glm::dvec2(0.2, 0.9)}) {
            Framing framing;
            std::vector<glm::dvec3> points;
            for (int i = 0; i < 5000; ++i) {  // more than are kept at a time
                points.push_back(shape *
                                 (glm::dvec3(value(random), value(random), value(random)) + glm::dvec3(9, -4, 2)));
                framing.add(points.back());
            }
            const Framing::Eye eye = framing.eye(half);
            const std::array<double, 4> is = room(points, eye.position, half);
            EXPECT_NEAR(std::max(is[1], is[3]), 1.0, 1e-9);
            EXPECT_NEAR(is[0], is[1], 1e-6);
            EXPECT_NEAR(is[2], is[3], 1e-6);
            double nearest = 1e300;
            for (const glm::dvec3& point : points) nearest = std::min(nearest, eye.position.z - point.z);
            EXPECT_NEAR(eye.nearestDistance, nearest, 1e-9 * nearest);
            EXPECT_GT(nearest, 0.0);
        }
    }
}

TEST(Framing, NothingAPointAndALineAlongTheViewAreLookedAtFromOutside) {
    const glm::dvec2 half(0.4, 0.3);
    EXPECT_GT(Framing().eye(half).nearestDistance, 0.0);
    Framing point;
    point.add({3, 4, 5});
    EXPECT_NEAR(point.eye(half).position.x, 3.0, 1e-12);
    EXPECT_NEAR(point.eye(half).position.y, 4.0, 1e-12);
    EXPECT_GT(point.eye(half).position.z, 5.0);
    Framing line;
    line.add({0, 0, -1});
    line.add({0, 0, 1});
    EXPECT_GT(line.eye(half).position.z, 1.0);
}

}  // namespace
}  // namespace umbrage
