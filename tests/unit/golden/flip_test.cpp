// SPDX-License-Identifier: Apache-2.0
// FLIP against values that follow from the papers' formulas by hand, against their literal implementation
// (flip_reference.h), and against what must hold of any pictures.
#include "golden/flip.h"

#include <gmock/gmock.h>

#include <glm/glm.hpp>

#include "flip_reference.h"
#include "golden/flip_color.h"
#include "golden/flip_filter.h"
#include "stored.h"

namespace umbrage {
namespace {

using test::constantPicture;
using test::randomPicture;

constexpr double kUsual = 67.0;  // pixels per degree

TEST(FlipColor, WhiteAndBlackAreTheScalesEnds) {
    const glm::vec3 white = flip::ycxczOf({1, 1, 1}), black = flip::ycxczOf({0, 0, 0});
    EXPECT_NEAR(white.x, 100.0f, 1e-4f);
    EXPECT_NEAR(glm::length(glm::vec2(white.y, white.z)), 0.0f, 1e-3f);
    EXPECT_NEAR(black.x, -16.0f, 1e-6f);
    EXPECT_NEAR(flip::huntLabOf({1, 1, 1}).x, 100.0f, 1e-4f);
    EXPECT_NEAR(flip::huntLabOf({0, 0, 0}).x, 0.0f, 1e-4f);
}

TEST(FlipColor, LabIsThatOfTheTables) {
    // L*a*b* of sRGB's primaries, D65, as tables of colours print them; a* and b* times L*/100 for Hunt's effect.
    const auto expectLab = [](const glm::vec3& linear, double l, double a, double b) {
        const glm::vec3 lab = flip::huntLabOf(linear);
        EXPECT_NEAR(lab.x, l, 0.02);
        EXPECT_NEAR(lab.y, a * l / 100.0, 0.05);
        EXPECT_NEAR(lab.z, b * l / 100.0, 0.05);
    };
    expectLab({1, 0, 0}, 53.24, 80.09, 67.20);
    expectLab({0, 1, 0}, 87.73, -86.18, 83.18);
    expectLab({0, 0, 1}, 32.30, 79.19, -107.86);
}

TEST(FlipColor, YcxczIsInverted) {
    for (const glm::vec3& color : {glm::vec3(0.1f, 0.7f, 0.3f), glm::vec3(1, 0, 0), glm::vec3(0, 0.02f, 0.9f)}) {
        const glm::vec3 back = flip::linearOf(flip::ycxczOf(color));
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(back[c], color[c], 2e-6f);
    }
}

TEST(FlipColor, TheLargestDistanceIsGreenToBlueAndIsOne) {
    const float most = flip::hyab(flip::huntLabOf({0, 1, 0}), flip::huntLabOf({0, 0, 1}));
    EXPECT_NEAR(flip::redistributed(most), 1.0f, 1e-6f);
    // The bend: 0.4 of the largest power is 0.95 (section 4.1.3).
    EXPECT_NEAR(flip::redistributed(most * std::pow(0.4f, 1.0f / 0.7f)), 0.95f, 1e-5f);
    EXPECT_EQ(flip::redistributed(0.0f), 0.0f);
}

TEST(FlipFilter, WeightsAddUp) {
    for (const double ppd : {10.0, kUsual, 200.0}) {
        const flip::FeatureKernels kernels(ppd);
        const auto sumOf = [](const flip::Kernel& kernel, float sign) {
            double sum = 0.0;
            for (const float weight : kernel) sum += weight * sign > 0.0f ? weight : 0.0f;
            return sum;
        };
        EXPECT_NEAR(sumOf(kernels.gaussian, 1), 1.0, 1e-6);
        for (const flip::Kernel& kernel : {kernels.first, kernels.second}) {
            EXPECT_NEAR(sumOf(kernel, 1), 1.0, 1e-6);
            EXPECT_NEAR(sumOf(kernel, -1), -1.0, 1e-6);
        }
        const flip::Plane one{40, 30, std::vector<float>(1200, 1.0f)};
        const flip::Sensitivities sensitivities(ppd);
        for (const auto* each : {&sensitivities.achromatic, &sensitivities.redGreen, &sensitivities.blueYellow}) {
            for (const float value : each->applied(one).values) ASSERT_NEAR(value, 1.0f, 1e-5f);
        }
    }
}

TEST(Flip, OfEqualPicturesIsZero) {
    const LinearPicture picture = randomPicture(30, 20, 1);
    EXPECT_THAT(flipMap(picture, picture, kUsual), testing::Each(0.0f));
    EXPECT_THAT(hdrFlipMap(picture, picture, kUsual), testing::Each(0.0f));
    EXPECT_EQ(weightedPercentile(flipMap(picture, picture, kUsual), 0.5), 0.0);
}

TEST(Flip, OfBlackAndWhiteFollowsFromTheFormulas) {
    // Constant pictures have no features, and filters leave them alone. The distance is 100, its power 100^0.7
    // = 25.1189. The tables' green and blue, above, are 203.287 apart: power 41.274, bend 16.510. So the error is 0.95
    // + 0.05 (25.1189 - 16.510) / (41.274 - 16.510) = 0.96738.
    const auto black = constantPicture(25, 25, 0, 0, 0), white = constantPicture(25, 25, 1, 1, 1);
    for (const float error : flipMap(black, white, kUsual)) ASSERT_NEAR(error, 0.96738f, 2e-5f);
    // Linear 0.18 is L* = 49.496, whose power 15.353 lies before the bend: 0.95 * 15.353 / 16.510 = 0.8835.
    const auto grey = constantPicture(25, 25, 0.18f, 0.18f, 0.18f);
    for (const float error : flipMap(black, grey, kUsual)) ASSERT_NEAR(error, 0.8835f, 1e-4f);
    const auto green = constantPicture(25, 25, 0, 1, 0), blue = constantPicture(25, 25, 0, 0, 1);
    for (const float error : flipMap(green, blue, kUsual)) ASSERT_NEAR(error, 1.0f, 2e-5f);
}

void expectLikeReference(const LinearPicture& a, const LinearPicture& b, double ppd, double tolerance) {
    const FlipMap map = flipMap(a, b, ppd);
    const std::vector<double> expected = test::referenceFlip(a, b, ppd);
    double most = 0.0;
    for (std::size_t i = 0; i < map.size(); ++i) {
        ASSERT_NEAR(map[i], expected[i], tolerance) << i % a.width << ' ' << i / a.width;
        most = std::max(most, expected[i]);
    }
    EXPECT_GT(most, 0.05);
}

TEST(Flip, IsThatOfWholeFilters) {
    // The rest is the difference between the matrices of the two.
    for (const double ppd : {12.0, 30.0, kUsual}) {
        expectLikeReference(randomPicture(41, 33, 1), randomPicture(41, 33, 2), ppd, 2e-3);
    }
    LinearPicture edge = constantPicture(48, 40, 0.2f, 0.3f, 0.1f), moved = edge;
    for (int y = 0; y < 40; ++y) {
        for (int x = 20; x < 48; ++x) edge.rgb[3 * (y * 48 + x)] = 0.9f;
        for (int x = 21; x < 48; ++x) moved.rgb[3 * (y * 48 + x)] = 0.9f;
    }
    expectLikeReference(edge, moved, kUsual, 2e-3);
}

TEST(Flip, OfOnePixelIsThatOfWholeFiltersWhereverItLies) {
    // Here only a part of the picture is computed.
    for (const auto& [x, y] : {std::pair{0, 0}, {60, 45}, {89, 3}, {40, 69}}) {
        LinearPicture a = randomPicture(90, 70, 5), b = a;
        for (int c = 0; c < 3; ++c) b.rgb[3 * (y * 90 + x) + c] = a.rgb[3 * (y * 90 + x) + c] > 0.5f ? 0.0f : 1.0f;
        expectLikeReference(a, b, kUsual, 2e-3);
    }
}

TEST(Flip, IsSymmetricAndInRange) {
    for (unsigned seed = 0; seed < 5; ++seed) {
        const LinearPicture a = randomPicture(40, 30, seed), b = randomPicture(40, 30, seed + 100);
        const FlipMap map = flipMap(a, b, kUsual);
        EXPECT_EQ(map, flipMap(b, a, kUsual));
        EXPECT_THAT(map, testing::Each(testing::AllOf(testing::Gt(0.0f), testing::Le(1.0f))));
    }
}

TEST(Flip, ClampsToTheDisplay) {
    const LinearPicture a = randomPicture(30, 20, 3, 2.0f);
    LinearPicture clamped = a;
    for (float& value : clamped.rgb) value = std::min(value, 1.0f);
    EXPECT_THAT(flipMap(a, clamped, kUsual), testing::Each(0.0f));
}

TEST(Flip, SeesLessFromFartherAway) {
    const LinearPicture a = randomPicture(60, 60, 1), b = randomPicture(60, 60, 2);
    const auto mean = [&](double ppd) { return meanError(flipMap(a, b, ppd)); };
    EXPECT_GT(mean(20), mean(67));
    EXPECT_GT(mean(67), mean(200));
}

TEST(Flip, FeaturesAddToTheErrorOfColour) {
    // Half the pixels of a step differ in colour by as much as all of a constant picture do; only the step is a
    // feature.
    const LinearPicture plain = constantPicture(60, 60, 0.2f, 0.2f, 0.2f);
    LinearPicture step = plain;
    for (int y = 0; y < 60; ++y) std::fill_n(step.rgb.begin() + 3 * (y * 60 + 30), 90, 0.25f);
    const FlipMap flat = flipMap(plain, constantPicture(60, 60, 0.25f, 0.25f, 0.25f), kUsual);
    const FlipMap stepped = flipMap(plain, step, kUsual);
    EXPECT_GT(stepped[30 * 60 + 32], 1.2f * flat[30 * 60 + 32]);
    EXPECT_NEAR(stepped[30 * 60 + 55], flat[30 * 60 + 55], 1e-5f);
}

TEST(HdrFlip, ExposuresFollowFromTheReferencesLuminance) {
    // The tone mapper y = (0.9036 x^2 + 0.018 x) / (0.8748 x^2 + 0.354 x + 0.14) is 0.85 at x = 2.0199:
    // 0.16002 x^2 - 0.2829 x - 0.119 = 0.
    LinearPicture picture = constantPicture(8, 4, 0.5f, 0.5f, 0.5f);
    for (int i = 0; i < 3; ++i) picture.rgb[i] = 64.0f;
    const ExposureRange range = exposuresOf(picture);
    const double x = (0.2829 + std::sqrt(0.2829 * 0.2829 + 4 * 0.16002 * 0.119)) / (2 * 0.16002);
    EXPECT_NEAR(range.start, std::log2(x / 64.0), 1e-5);
    EXPECT_NEAR(range.stop, std::log2(x / 0.5), 1e-5);
    EXPECT_EQ(range.count, 7);
    EXPECT_EQ(range.stops(0), range.start);
    EXPECT_EQ(range.stops(6), range.stop);
}

TEST(HdrFlip, TheMedianIsOfAllPixelsUnlessBlack) {
    // Of eight pixels: 0 0 0 1 1 1 4 4, then 0 0 0 0 0 1 4 4.
    LinearPicture picture = constantPicture(8, 1, 0, 0, 0);
    std::fill_n(picture.rgb.begin() + 9, 9, 1.0f);
    std::fill_n(picture.rgb.begin() + 18, 6, 4.0f);
    EXPECT_NEAR(exposuresOf(picture).stop - exposuresOf(picture).start, 2.0, 1e-6);
    std::fill_n(picture.rgb.begin() + 9, 6, 0.0f);
    EXPECT_NEAR(exposuresOf(picture).stop - exposuresOf(picture).start, 0.0, 1e-6);
}

TEST(HdrFlip, ExposuresOfBlackAndOfTheNearlyBlackEnd) {
    LinearPicture picture = constantPicture(10, 10, 0, 0, 0);
    EXPECT_EQ(exposuresOf(picture).count, 1);
    EXPECT_EQ(exposuresOf(picture).stops(0), 0.0);
    for (int i = 0; i < 30; ++i) picture.rgb[i] = 2.0f;
    EXPECT_NEAR(exposuresOf(picture).start, exposuresOf(picture).stop, 1e-9);
    std::fill_n(picture.rgb.begin() + 30, 200, 1e-38f);
    EXPECT_EQ(exposuresOf(picture).count, int(kMaximumExposureStops));
}

TEST(HdrFlip, IsTheLargestOverExposures) {
    const LinearPicture a = randomPicture(20, 20, 8, 40.0f), b = randomPicture(20, 20, 9, 40.0f);
    const FlipMap map = hdrFlipMap(a, b, kUsual);
    const ExposureRange range = exposuresOf(a);
    std::vector<double> expected(map.size());
    for (int e = 0; e < range.count; ++e) {
        LinearPicture mapped[2] = {a, b};
        for (LinearPicture& picture : mapped) {
            for (float& value : picture.rgb) {
                const double v = 0.6 * value * std::exp2(range.stops(e));  // Narkowicz 2015, scaled by 0.6
                value = float(std::clamp(v * (2.51 * v + 0.03) / (v * (2.43 * v + 0.59) + 0.14), 0.0, 1.0));
            }
        }
        const std::vector<double> one = test::referenceFlip(mapped[0], mapped[1], kUsual);
        for (std::size_t i = 0; i < one.size(); ++i) expected[i] = std::max(expected[i], one[i]);
    }
    for (std::size_t i = 0; i < map.size(); ++i) ASSERT_NEAR(map[i], expected[i], 2e-3);
}

TEST(HdrFlip, SeesWhatTheDisplayClamps) {
    // Lights of 30 and 60 are one white at exposure 0.
    LinearPicture a = constantPicture(40, 40, 0.5f, 0.5f, 0.5f), b = a;
    for (int y = 10; y < 30; ++y) {
        std::fill_n(a.rgb.begin() + 3 * (y * 40 + 10), 60, 60.0f);
        std::fill_n(b.rgb.begin() + 3 * (y * 40 + 10), 60, 30.0f);
    }
    EXPECT_THAT(flipMap(a, b, kUsual), testing::Each(0.0f));
    EXPECT_GT(largestError(hdrFlipMap(a, b, kUsual)), 0.2);
}

TEST(FlipMap, PercentilesAreWeighted) {
    // All error is 2: half of it lies at or below 0.5 only with the third value.
    const FlipMap map{0.0f, 0.25f, 1.0f, 0.25f, 0.5f, 0.0f, 0.0f, 0.0f};
    EXPECT_EQ(meanError(map), 0.25);
    EXPECT_EQ(largestError(map), 1.0);
    EXPECT_EQ(weightedPercentile(map, 0.5), 0.5);
    EXPECT_EQ(weightedPercentile(map, 0.25), 0.25);
    EXPECT_EQ(weightedPercentile(map, 0.51), 1.0);
    EXPECT_EQ(weightedPercentile(map, 1.0), 1.0);
}

}  // namespace
}  // namespace umbrage
