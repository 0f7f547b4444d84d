// SPDX-License-Identifier: Apache-2.0
#include "scene/aim.h"

#include <gtest/gtest.h>

namespace umbrage {
namespace {

TEST(LookRotation, TurnsMinusZAndKeepsUpUp) {
    for (const glm::dvec3 direction : {glm::dvec3(0, 0, -1), glm::dvec3(0, 0, 3), glm::dvec3(1, 2, 3),
                                       glm::dvec3(0, 1, 0), glm::dvec3(0, -7, 0), glm::dvec3(1e-12, -1, 0)}) {
        const glm::dquat rotation = lookRotation(direction);
        EXPECT_LT(glm::length(rotation * glm::dvec3(0, 0, -1) - glm::normalize(direction)), 1e-6);
        EXPECT_NEAR(glm::length(rotation), 1.0, 1e-12);
        EXPECT_GE((rotation * glm::dvec3(0, 1, 0)).y, -1e-9);
        EXPECT_NEAR((rotation * glm::dvec3(1, 0, 0)).y, 0.0, 1e-9) << "the horizon is level";
    }
}

}  // namespace
}  // namespace umbrage
