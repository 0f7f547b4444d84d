// SPDX-License-Identifier: Apache-2.0
// Gates and limits: what becomes of two pictures, and which rule says so.
#include "golden/compare_images.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "golden/result_text.h"
#include "stored.h"

namespace umbrage {
namespace {

using test::Floats;
using test::Integers;
using test::stored;
using testing::HasSubstr;

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN(), kInfinity = std::numeric_limits<float>::infinity();

/// 16 x 16, one channel, zero but for some pixels.
StoredImage grey(const std::vector<std::pair<std::size_t, float>>& pixels = {}) {
    Floats values(256, 0.0f);
    for (const auto& [at, value] : pixels) values[at] = value;
    return stored(16, 16, {{"Y", values}});
}

GoldenRule rule(const std::string& pattern, std::vector<GoldenLimit> all, std::vector<GoldenLimit> any = {}) {
    GoldenRule made;
    made.pattern = pattern;
    if (!all.empty()) made.all = std::move(all);
    if (!any.empty()) made.any = std::move(any);
    return made;
}

double figure(const ImageResult& result, const std::string& metric) {
    for (const Figure& figure : result.figures) {
        if (figure.metric == metric) return figure.value;
    }
    ADD_FAILURE() << "no " << metric;
    return -1.0;
}

TEST(CompareImages, WithoutRulesEqualIsEqual) {
    const ImageResult equal = compareImages(grey(), grey(), {});
    EXPECT_EQ(equal.outcome, Outcome::Pass);
    EXPECT_EQ(equal.worst, std::pair(-1, -1));
    EXPECT_EQ(figure(equal, "psnr"), double(kInfinity));
    const ImageResult other = compareImages(grey(), grey({{37, 1e-6f}}), {});
    EXPECT_EQ(other.outcome, Outcome::Fail);
    EXPECT_EQ(other.worst, std::pair(5, 2));
    ASSERT_TRUE(other.decision);
    EXPECT_EQ(other.decision->rule, "equal");
    EXPECT_EQ(explanation(other), "equal: max-abs 1e-06 is over 0");
}

TEST(CompareImages, GatesCloseBeforeAnythingIsMeasured) {
    StoredImage larger = stored(16, 17, {{"Y", Floats(272, 0.0f)}}), elsewhere = grey(), half = grey();
    elsewhere.data.x = 1;
    half.channels[0].type = PixelType::Half;
    const StoredImage named = stored(16, 16, {{"Z", Floats(256, 0.0f)}});
    GoldenLimit generous{"any", "fraction", 1.0, {}};
    ImageRules rules;
    rules.all = {generous};
    const auto outcome = [&](const StoredImage& output) {
        const ImageResult result = compareImages(grey(), output, rules);
        EXPECT_TRUE(result.figures.empty());
        EXPECT_FALSE(result.reason.empty());
        return result.outcome;
    };
    EXPECT_EQ(outcome(larger), Outcome::SizeMismatch);
    EXPECT_EQ(outcome(elsewhere), Outcome::SizeMismatch);
    EXPECT_EQ(outcome(named), Outcome::ChannelMismatch);
    EXPECT_EQ(outcome(half), Outcome::ChannelMismatch);
    EXPECT_EQ(outcome(grey({{3, kNaN}})), Outcome::NonFinite);
    EXPECT_EQ(outcome(grey({{3, kInfinity}})), Outcome::NonFinite);
}

TEST(CompareImages, ANaNIsNoNumberInEitherPictureNorInBoth) {
    const StoredImage bad = grey({{18, kNaN}, {19, kNaN}});
    const ImageResult both = compareImages(bad, bad, {}, true);
    EXPECT_EQ(both.outcome, Outcome::NonFinite);
    EXPECT_EQ(both.reason, "2 values of channel Y are no number, first at (2, 1)");
    const ImageResult golden = compareImages(grey({{18, kNaN}}), grey(), {});
    EXPECT_EQ(golden.reason, "1 value of channel Y is no number in the golden, first at (2, 1)");
}

TEST(CompareImages, InfinitelyFarInBothIsEqual) {
    const StoredImage sky = grey({{0, kInfinity}, {7, -kInfinity}});
    EXPECT_EQ(compareImages(sky, sky, {}).outcome, Outcome::Pass);
    EXPECT_EQ(compareImages(sky, grey({{0, -kInfinity}, {7, -kInfinity}}), {}).outcome, Outcome::NonFinite);
}

TEST(CompareImages, AllMustHoldAndOfAnyOneSuffices) {
    const StoredImage output = grey({{0, 0.5f}, {1, 0.5f}});
    const GoldenLimit few{"few", "fraction", 0.01, {}}, small{"small", "max-abs", 0.1, {}};
    ImageRules rules;
    rules.all = {few};
    EXPECT_EQ(compareImages(grey(), output, rules).outcome, Outcome::Pass);
    EXPECT_EQ(compareImages(grey(), output, rules).decision->rule, "few");
    rules.all = {few, small};
    const ImageResult failed = compareImages(grey(), output, rules);
    EXPECT_EQ(failed.outcome, Outcome::Fail);
    EXPECT_EQ(failed.decision->rule, "small");
    EXPECT_EQ(failed.decision->value, 0.5);
    EXPECT_EQ(failed.decision->limit, 0.1);
    rules.all.clear();
    rules.any = {few, small};
    EXPECT_EQ(compareImages(grey(), output, rules).outcome, Outcome::Pass);
    rules.any = {{"fewer", "fraction", 0.001, {}}, small};
    EXPECT_EQ(compareImages(grey(), output, rules).outcome, Outcome::Fail);
}

TEST(CompareImages, AHoleThatAFractionForgivesIsSeenByTheDensestWindow) {
    std::vector<std::pair<std::size_t, float>> hole;
    for (std::size_t y = 4; y < 7; ++y) {
        for (std::size_t x = 4; x < 7; ++x) hole.emplace_back(16 * y + x, 1.0f);
    }
    ImageRules rules;
    rules.measure.window = 3;
    rules.all = {{"few", "fraction", 0.05, {}}, {"no hole", "densest", 0.5, {}}};
    const ImageResult result = compareImages(grey(), grey(hole), rules);
    EXPECT_EQ(result.outcome, Outcome::Fail);
    EXPECT_EQ(result.decision->rule, "no hole");
    EXPECT_EQ(result.decision->value, 1.0);
}

TEST(CompareImages, WarningsPassAndLimitsOfPsnrAreTheLeastAllowed) {
    const StoredImage output = grey({{0, 0.16f}});  // rmse 0.01: 40 dB
    ImageRules rules;
    rules.all = {{"close", "max-abs", 0.5, 0.1}};
    EXPECT_EQ(compareImages(grey(), output, rules).outcome, Outcome::Warn);
    rules.all = {{"quiet", "psnr", 30.0, {}}};
    EXPECT_EQ(compareImages(grey(), output, rules).outcome, Outcome::Pass);
    rules.all = {{"quiet", "psnr", 50.0, {}}};
    const ImageResult loud = compareImages(grey(), output, rules);
    EXPECT_EQ(loud.outcome, Outcome::Fail);
    EXPECT_EQ(explanation(loud), "quiet: psnr 40 is under 50");
}

TEST(CompareImages, IntegersAreExactUnlessALimitOnThemSaysOtherwise) {
    const auto ids = [](std::uint32_t last) { return stored(2, 1, {{"id", Integers{7, last}}}); };
    ImageRules rules;
    rules.all = {{"generous", "fraction", 1.0, {}}};
    EXPECT_EQ(compareImages(ids(4), ids(4), rules).outcome, Outcome::Pass);
    const ImageResult other = compareImages(ids(4), ids(5), rules);
    EXPECT_EQ(other.outcome, Outcome::Fail);
    EXPECT_EQ(other.decision->rule, "integers");
    EXPECT_EQ(other.decision->value, 1.0);
    rules.all.push_back({"some", "uint-different", 1.0, {}});
    EXPECT_EQ(compareImages(ids(4), ids(5), rules).outcome, Outcome::Pass);
}

TEST(CompareImages, ALimitOnWhatAPictureLacksDoesNotLetItPass) {
    ImageRules rules;
    rules.all = {{"colours", "flip", 1.0, {}}};
    const StoredImage depth = stored(2, 1, {{"Z", Floats{1.0f, 2.0f}}}, false);
    EXPECT_EQ(compareImages(depth, stored(2, 1, {{"Z", Floats{1.0f, 3.0f}}}, false), rules).outcome, Outcome::Fail);
}

TEST(CompareImages, WhatIsSkippedOrExpectedSaysWhy) {
    ImageRules rules;
    rules.skip = "flickers";
    EXPECT_EQ(compareImages(grey(), grey({{0, 1.0f}}), rules).outcome, Outcome::Skipped);
    EXPECT_EQ(compareImages(grey(), grey({{0, 1.0f}}), rules).reason, "flickers");
    rules = {};
    rules.expectFailure = "issue 12";
    const ImageResult expected = compareImages(grey(), grey({{0, 1.0f}}), rules);
    EXPECT_EQ(expected.outcome, Outcome::ExpectedFailure);
    EXPECT_THAT(expected.reason, HasSubstr("issue 12"));
    EXPECT_EQ(compareImages(grey(), grey(), rules).outcome, Outcome::UnexpectedPass);
}

TEST(RulesFor, LaterOnesWinKeyByKey) {
    GoldenRule byDefault = rule("default", {{"few", "fraction", 0.1, {}}}), beauty = rule("beauty", {});
    byDefault.tolerance = 0.25;
    byDefault.window = 5;
    beauty.tolerance = 0.5;
    GoldenRule frame = rule("beauty.0007.*", {{"equal", "max-abs", 0.0, {}}});
    const std::vector<GoldenRule> rules{byDefault, beauty, frame};
    const ImageRules depth = rulesFor(rules, "a/depth.0001.exr", "depth");
    EXPECT_EQ(depth.measure.tolerance, 0.25);
    EXPECT_EQ(depth.all.front().name, "few");
    const ImageRules seventh = rulesFor(rules, "a/beauty.0007.png", "beauty");
    EXPECT_EQ(seventh.measure.tolerance, 0.5);
    EXPECT_EQ(seventh.measure.window, 5);
    EXPECT_EQ(seventh.all.front().name, "equal");
}

}  // namespace
}  // namespace umbrage
