// SPDX-License-Identifier: Apache-2.0
#include "diagnostics/distribution.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

namespace umbrage {
namespace {

using Histogram = std::vector<std::pair<double, std::uint64_t>>;

TEST(Distribution, OfNothingIsZero) {
    const Distribution none;
    EXPECT_EQ(none.pixels(), 0u);
    EXPECT_EQ(none.mean(), 0.0);
    EXPECT_EQ(none.max(), 0.0);
    EXPECT_EQ(none.percentile(95), 0.0);
    EXPECT_TRUE(none.histogram().empty());
}

TEST(Distribution, PercentileIsTheSmallestValueWithEnoughAtOrBelow) {
    Distribution d;
    for (int value = 1; value <= 100; ++value) d.add(value);
    EXPECT_EQ(d.percentile(50), 50.0);
    EXPECT_EQ(d.percentile(95), 95.0);
    EXPECT_EQ(d.percentile(99), 99.0);
    EXPECT_EQ(d.percentile(99.5), 100.0);
    EXPECT_EQ(d.percentile(100), 100.0);
    EXPECT_EQ(d.percentile(0.001), 1.0);
    EXPECT_EQ(d.mean(), 50.5);
    EXPECT_EQ(d.max(), 100.0);
}

TEST(Distribution, OneLargeValueMovesOnlyTheHighestPercentiles) {
    Distribution d;
    d.add(0, 98);
    d.add(7, 1);
    d.add(200, 1);
    EXPECT_EQ(d.percentile(95), 0.0);
    EXPECT_EQ(d.percentile(98), 0.0);
    EXPECT_EQ(d.percentile(99), 7.0);
    EXPECT_EQ(d.max(), 200.0);
    EXPECT_EQ(d.histogram(), (Histogram{{0, 98}, {7, 1}, {200, 1}}));
}

TEST(Distribution, AgreesWithSortedValuesWithinABin) {
    std::mt19937 random(7);
    std::lognormal_distribution<double> many(5.0, 2.0);
    Distribution d;
    std::vector<double> values;
    for (int i = 0; i < 20000; ++i) {
        values.push_back(std::floor(many(random)));
        d.add(values.back());
    }
    std::sort(values.begin(), values.end());
    for (const double percent : {1.0, 50.0, 95.0, 99.0, 99.9}) {
        const double exact = values[std::size_t(std::ceil(percent * double(values.size()) / 100.0)) - 1];
        const double found = d.percentile(percent);
        EXPECT_LE(found, exact) << percent;
        EXPECT_GE(found, exact < 256 ? exact : exact * (1 - 1.0 / 128)) << percent;
    }
    double sum = 0.0;
    for (const double value : values) sum += value;
    EXPECT_DOUBLE_EQ(d.mean(), sum / double(values.size()));
    EXPECT_EQ(d.max(), values.back());
}

TEST(Distribution, BinsAreOneWideBelow256AndThen128AnOctave) {
    Distribution d;
    for (const double value : {255.0, 256.0, 257.0, 258.0, 511.0, 512.0, 515.0, 516.0}) d.add(value);
    EXPECT_EQ(d.histogram(), (Histogram{{255, 1}, {256, 2}, {258, 1}, {510, 1}, {512, 2}, {516, 1}}));
    Distribution huge;
    huge.add(3e38);
    ASSERT_EQ(huge.histogram().size(), 1u);
    EXPECT_LE(huge.histogram()[0].first, 3e38);
    EXPECT_GE(huge.histogram()[0].first, 3e38 * (1 - 1.0 / 128));
}

TEST(Distribution, FractionsKeepTheirSumAndFallIntoTheBinBelow) {
    Distribution d;
    d.add(2.25, 4);
    EXPECT_EQ(d.sum(), 9.0);
    EXPECT_EQ(d.max(), 2.25);
    EXPECT_EQ(d.histogram(), (Histogram{{2, 4}}));
}

TEST(Distribution, AddingTwoIsAddingTheirValues) {
    Distribution a, b, both;
    for (int i = 0; i < 50; ++i) {
        a.add(i * 3);
        both.add(i * 3);
        b.add(i * 40, 2);
        both.add(i * 40, 2);
    }
    Distribution sum = a;
    sum.add(b);
    EXPECT_EQ(sum, both);
    b.add(a);
    EXPECT_EQ(b, both);
}

TEST(Distribution, ComesBackFromItsHistogram) {
    Distribution d;
    d.add(0, 5);
    d.add(12, 3);
    d.add(1000, 1);
    EXPECT_EQ(Distribution(d.histogram(), d.sum(), d.max()), d);
    EXPECT_EQ(Distribution({}, 0, 0), Distribution());
}

TEST(Distribution, RefusesHistogramsThatContradictThemselves) {
    const auto refused = [](const Histogram& histogram, double sum, double max) {
        EXPECT_THROW(Distribution(histogram, sum, max), std::invalid_argument);
    };
    refused({{0.5, 1}}, 0.5, 0.5);         // no bin starts there
    refused({{257, 1}}, 257, 257);         // nor there
    refused({{-1, 1}}, 0, 0);              // nor there
    refused({{2, 1}, {1, 1}}, 3, 2);       // not ascending
    refused({{1, 1}, {1, 1}}, 2, 1);       // twice
    refused({{1, 0}}, 0, 1);               // empty
    refused({{1, 1}, {2, 1}}, 3, 7);       // the largest value elsewhere
    refused({{1, 1}, {2, 1}}, 30, 2);      // too large a sum
    refused({{1, 1}}, -1, 1);              // a negative one
    refused({}, 0, 1);                     // a largest value of nothing
    refused({{1, 1}}, std::nan(""), 1.0);  // no number
}

}  // namespace
}  // namespace umbrage
