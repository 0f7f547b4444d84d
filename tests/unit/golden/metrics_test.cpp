// SPDX-License-Identifier: Apache-2.0
// Every figure against values worked out by hand.
#include "golden/metrics.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "error.h"
#include "stored.h"

namespace umbrage {
namespace {

using test::Floats;
using test::Integers;
using test::stored;
using testing::HasSubstr;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

Measured all(const StoredImage& golden, const StoredImage& output, const MeasureSettings& settings = {}) {
    std::vector<std::string> names;
    for (const MetricInfo& metric : kMetrics) names.emplace_back(metric.name);
    return measure(golden, output, settings, names);
}

double figure(const Measured& measured, std::string_view name) {
    for (const Figure& each : measured.figures) {
        if (each.metric == name) return each.value;
    }
    ADD_FAILURE() << "no figure " << name;
    return std::numeric_limits<double>::quiet_NaN();
}

bool has(const Measured& measured, std::string_view name) {
    return std::any_of(measured.figures.begin(), measured.figures.end(),
                       [&](const Figure& each) { return each.metric == name; });
}

TEST(Metrics, OfEqualPicturesAreNone) {
    const StoredImage image = stored(2, 1, {{"B", Floats{0, 1}}, {"G", Floats{.5f, 1}}, {"R", Floats{.25f, 0}}});
    const Measured measured = all(image, image);
    EXPECT_EQ(measured.worst, (std::pair{-1, -1}));
    EXPECT_EQ(measured.figures.size(), 12u);  // neither uint-different nor hdr-flip
    for (const Figure& each : measured.figures) {
        EXPECT_EQ(each.value, each.metric == "psnr" ? double(kInfinity) : 0.0) << each.metric;
    }
}

TEST(Metrics, AreThoseOfTheSamples) {
    // Four samples that differ by 0, 0.25, 0, 0.5.
    const StoredImage golden = stored(2, 1, {{"A", Floats{1, .5f}}, {"Y", Floats{0, .25f}}});
    const StoredImage output = stored(2, 1, {{"A", Floats{1, .75f}}, {"Y", Floats{0, .75f}}});
    const Measured measured = all(golden, output, {.tolerance = 0.3});
    EXPECT_EQ(figure(measured, "max-abs"), 0.5);
    EXPECT_EQ(figure(measured, "mean-abs"), 0.75 / 4);
    EXPECT_DOUBLE_EQ(figure(measured, "rmse"), std::sqrt(0.3125 / 4));
    EXPECT_DOUBLE_EQ(figure(measured, "psnr"), -10.0 * std::log10(0.3125 / 4));
    EXPECT_EQ(figure(measured, "max-relative"), 2.0);
    EXPECT_EQ(figure(measured, "mean-relative"), (0.5 + 2.0) / 4);
    EXPECT_EQ(figure(measured, "fraction"), 0.5);
    EXPECT_EQ(measured.worst, (std::pair{1, 0}));
}

TEST(Metrics, RelativeDifferencesOfTheDarkAreToTheFloor) {
    const StoredImage golden = stored(1, 1, {{"Z", Floats{0.001f}}}, false);
    const StoredImage output = stored(1, 1, {{"Z", Floats{0.126f}}}, false);
    EXPECT_NEAR(figure(all(golden, output, {.relativeFloor = 0.25}), "max-relative"), 0.5, 1e-7);
}

TEST(Metrics, ADifferenceOfTheToleranceIsWithinIt) {
    const StoredImage golden = stored(2, 1, {{"Y", Floats{0, 0}}}), output = stored(2, 1, {{"Y", Floats{.25f, .5f}}});
    EXPECT_EQ(figure(all(golden, output, {.tolerance = 0.25}), "fraction"), 0.5);
    EXPECT_EQ(figure(all(golden, output, {.tolerance = 0.5}), "fraction"), 0.0);
}

TEST(Metrics, AStepOfAByteIsOneStepWhereverItLies) {
    Floats values, next;
    for (int i = 0; i < 255; ++i) values.push_back(float(i) / 255.0f), next.push_back(float(i + 1) / 255.0f);
    StoredImage golden = stored(255, 1, {{"Y", values}}), output = stored(255, 1, {{"Y", next}});
    for (StoredImage* image : {&golden, &output}) image->channels[0].type = PixelType::UInt8;
    const Measured measured = all(golden, output, {.tolerance = 1.0 / 255.0});
    EXPECT_EQ(figure(measured, "max-abs"), 1.0 / 255.0);
    EXPECT_EQ(figure(measured, "fraction"), 0.0);
    EXPECT_EQ(measured.worst, (std::pair{0, 0}));
}

TEST(Metrics, ThePeakOfLinearPicturesIsTheGoldens) {
    const StoredImage golden = stored(2, 1, {{"Z", Floats{-8, 2}}}, false);
    const StoredImage output = stored(2, 1, {{"Z", Floats{-8, 3}}}, false);
    EXPECT_DOUBLE_EQ(figure(all(golden, output), "psnr"), 20.0 * std::log10(8.0 / std::sqrt(0.5)));
    const StoredImage dark = stored(1, 1, {{"Z", Floats{.25f}}}, false),
                      bright = stored(1, 1, {{"Z", Floats{1000}}}, false);
    EXPECT_DOUBLE_EQ(figure(all(dark, bright), "psnr"), -20.0 * std::log10(999.75));
}

TEST(Metrics, IntegersCountExactly) {
    // As floats the last two would be one number.
    const StoredImage golden = stored(3, 1, {{"id", Integers{1, 7, 4294967295u}}, {"Z", Floats{0, 0, 0}}}, false);
    const StoredImage output = stored(3, 1, {{"id", Integers{1, 9, 4294967294u}}, {"Z", Floats{0, 0, 0}}}, false);
    const Measured measured = all(golden, output, {.tolerance = 100});
    EXPECT_EQ(figure(measured, "uint-different"), 2.0);
    EXPECT_EQ(figure(measured, "max-abs"), 2.0);
    EXPECT_EQ(figure(measured, "mean-abs"), 0.5);
    EXPECT_DOUBLE_EQ(figure(measured, "fraction"), 2.0 / 3);  // whatever the tolerance
    EXPECT_EQ(figure(measured, "psnr"), double(kInfinity));   // of the float channel
    EXPECT_EQ(measured.worst, (std::pair{1, 0}));
}

/// The same by counting in every window.
double densestByCounting(const std::vector<int>& marked, int width, int height, int across, int down) {
    int most = 0;
    for (int y = 0; y + down <= height; ++y) {
        for (int x = 0; x + across <= width; ++x) {
            int sum = 0;
            for (int j = 0; j < down; ++j) {
                for (int i = 0; i < across; ++i) sum += marked[(y + j) * width + x + i];
            }
            most = std::max(most, sum);
        }
    }
    return double(most) / (across * down);
}

TEST(Metrics, DensestIsTheWindowWithMost) {
    constexpr int kWidth = 23, kHeight = 9;
    std::mt19937 random(7);
    for (int round = 0; round < 20; ++round) {
        std::vector<int> marked(kWidth * kHeight);
        Floats values(marked.size());
        for (std::size_t i = 0; i < marked.size(); ++i) values[i] = float(marked[i] = random() % 8 == 0);
        const StoredImage golden = stored(kWidth, kHeight, {{"Z", Floats(values.size())}}, false);
        const StoredImage output = stored(kWidth, kHeight, {{"Z", values}}, false);
        for (const int window : {1, 2, 5, 9, 16, 100}) {
            const std::vector<std::string> wanted{"densest"};
            const Measured measured = measure(golden, output, {.window = window}, wanted);
            EXPECT_EQ(figure(measured, "densest"),
                      densestByCounting(marked, kWidth, kHeight, std::min(window, kWidth), std::min(window, kHeight)))
                << window;
        }
    }
}

TEST(Metrics, ASmallHoleIsDense) {
    constexpr int kSide = 256;
    const Floats black(kSide * kSide);
    Floats hole = black;
    for (int y = 100; y < 108; ++y) std::fill_n(hole.begin() + y * kSide + 31, 8, 1.0f);
    const Measured measured =
        all(stored(kSide, kSide, {{"Z", black}}), stored(kSide, kSide, {{"Z", hole}}), {.window = 8});
    EXPECT_EQ(figure(measured, "densest"), 1.0);
    EXPECT_EQ(figure(measured, "fraction"), 64.0 / (kSide * kSide));
    EXPECT_EQ(measured.worst, (std::pair{31, 100}));
}

TEST(Metrics, ANanIsNoNumber) {
    const StoredImage golden = stored(4, 1, {{"Y", Floats{kNan, kInfinity, 0.5f, 0.5f}}}, false);
    EXPECT_EQ(figure(all(golden, golden), "max-abs"), 0.0);
    EXPECT_EQ(figure(all(golden, golden), "hdr-flip-max"), 0.0);
    for (const float bad : {kNan, kInfinity, -kInfinity}) {
        const StoredImage output = stored(4, 1, {{"Y", Floats{kNan, kInfinity, 0.5f, bad}}}, false);
        for (const auto& measured :
             {all(golden, output, {.tolerance = 1e30}), all(output, golden, {.tolerance = 1e30})}) {
            for (const char* name : {"max-abs", "mean-abs", "rmse", "max-relative", "mean-relative"}) {
                EXPECT_EQ(figure(measured, name), double(kInfinity)) << name;
            }
            EXPECT_EQ(figure(measured, "psnr"), -double(kInfinity));
            EXPECT_EQ(figure(measured, "fraction"), 0.25);
            EXPECT_EQ(figure(measured, "flip-max"), 1.0);
            EXPECT_EQ(figure(measured, "hdr-flip"), 0.25);
            EXPECT_EQ(figure(measured, "yee"), 0.25);
            EXPECT_EQ(measured.worst, (std::pair{3, 0}));
        }
    }
}

TEST(Metrics, ComeInTheOrderWanted) {
    const StoredImage image = stored(1, 1, {{"Z", Floats{1}}}, false);
    const std::vector<std::string> wanted{"rmse", "flip", "fraction", "max-abs"};
    std::vector<std::string> names;
    for (const Figure& each : measure(image, image, {}, wanted).figures) names.push_back(each.metric);
    EXPECT_THAT(names, testing::ElementsAre("rmse", "fraction", "max-abs"));  // a Z has no colour
}

TEST(Metrics, ApplyToWhatTheyAreAbout) {
    const StoredImage png = stored(1, 1, {{"B", Floats{1}}, {"G", Floats{1}}, {"R", Floats{1}}});
    const StoredImage exr = stored(1, 1, {{"B", Floats{1}}, {"G", Floats{1}}, {"R", Floats{1}}}, false);
    const StoredImage ids = stored(1, 1, {{"id", Integers{1}}}, false);
    EXPECT_TRUE(applies("flip", png) && applies("flip", exr) && !applies("flip", ids));
    EXPECT_TRUE(!applies("hdr-flip", png) && applies("hdr-flip", exr) && !applies("hdr-flip-max", ids));
    EXPECT_TRUE(applies("yee", png) && applies("yee", exr) && !applies("yee", ids));
    EXPECT_TRUE(!applies("uint-different", png) && applies("uint-different", ids));
    EXPECT_TRUE(applies("psnr", png) && !applies("psnr", ids) && !applies("max-relative", ids));
    EXPECT_TRUE(applies("max-abs", ids) && applies("densest", ids));
    EXPECT_FALSE(applies("ssim", png));
    EXPECT_EQ(findMetric("ssim"), nullptr);
    EXPECT_FALSE(findMetric("psnr")->largerIsWorse);
    EXPECT_FALSE(has(all(ids, ids), "flip"));
}

void expectRefused(const StoredImage& golden, const StoredImage& output, const std::string& wanted,
                   const std::string& part) {
    try {
        measure(golden, output, {}, std::vector{wanted});
        ADD_FAILURE() << "was measured";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::Input);
        EXPECT_THAT(error.what(), HasSubstr(part));
    }
}

TEST(Metrics, WhatCannotBeComparedIsRefused) {
    const StoredImage image = stored(2, 1, {{"Z", Floats{1, 1}}});
    expectRefused(image, stored(1, 2, {{"Z", Floats{1, 1}}}), "rmse", "2x1 against 1x2");
    expectRefused(image, stored(2, 1, {{"Y", Floats{1, 1}}}), "rmse", "channel Z");
    expectRefused(image, stored(2, 1, {{"Z", Integers{1, 1}}}), "rmse", "channel Z");
    expectRefused(image, stored(2, 1, {{"Z", Floats{1, 1}}, {"Y", Floats{1, 1}}}), "rmse", "other channels");
    expectRefused(image, image, "ssim", "no metric");
}

}  // namespace
}  // namespace umbrage
