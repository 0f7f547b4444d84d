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
    Points points;
    for (const auto& [x, y] : {std::pair(0.0, 9.0), {3.0, 1.0}, {4.0, 3.0}, {5.0, 2.0}}) {
        points.emplace_back(std::exp(x), std::exp(y));
    }
    EXPECT_NEAR(growthExponent(points).value(), 0.5, 1e-12);
}

TEST(Growth, CostsOfNothingAreNoPoints) {
    EXPECT_FALSE(growthExponent({}).has_value());
    EXPECT_FALSE(growthExponent({{1.0, 5.0}}).has_value());
    EXPECT_FALSE(growthExponent({{1.0, 5.0}, {2.0, -1.0}, {0.0, 3.0}}).has_value());
    EXPECT_FALSE(growthExponent({{100.0, 2.0}, {150.0, 0.0}, {110.0, 2.0}}).has_value())
        << "one point is left in the upper half";
}

}  // namespace
}  // namespace umbrage
