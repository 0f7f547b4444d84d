// SPDX-License-Identifier: Apache-2.0
// What grows how is told from costs alone.
#include "bench/bench_growth.h"

#include <gtest/gtest.h>

#include <cmath>

namespace umbrage {
namespace {

using Points = std::vector<std::pair<double, double>>;

TEST(Growth, TheExponentIsThatOfTheCostliestHalf) {
    Points points;
    for (double x = 1.0; x < 2e6; x *= 10.0) points.emplace_back(x, x < 1e3 ? 7.0 : 0.01 * std::pow(x, 1.5));
    EXPECT_NEAR(growthExponent(points).value(), 1.5, 1e-12);
}

TEST(Growth, TheExponentIsThatOfTheLineNearestInLogarithms) {
    // Logarithms (1, 1), (2, 3), (3, 2) to base e: slope 1/2.
    const Points points{{std::exp(1.0), std::exp(1.0)}, {std::exp(2.0), std::exp(3.0)}, {std::exp(3.0), std::exp(2.0)}};
    EXPECT_NEAR(growthExponent({points[1], points[2]}).value(), -1.0, 1e-12);
    EXPECT_NEAR(growthExponent(points).value(), -1.0, 1e-12) << "the first is in the lower half";
}

TEST(Growth, CostsOfNothingAreNoPoints) {
    EXPECT_FALSE(growthExponent({}).has_value());
    EXPECT_FALSE(growthExponent({{1.0, 5.0}}).has_value());
    EXPECT_FALSE(growthExponent({{1.0, 5.0}, {2.0, -1.0}, {0.0, 3.0}}).has_value());
    EXPECT_NEAR(growthExponent({{100.0, 2.0}, {150.0, 0.0}, {110.0, 2.0}}).value_or(7.0), 7.0, 0.0)
        << "one point is left in the upper half";
}

}  // namespace
}  // namespace umbrage
