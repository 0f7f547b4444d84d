// SPDX-License-Identifier: Apache-2.0
// The page as text, and the pictures in it; what it does in a browser is tests/cli/comparison_page_test.cpp's.
#include <gmock/gmock.h>

#include <bit>

#include "comparisons.h"
#include "golden/comparison_page.h"
#include "golden/packed_picture.h"
#include "golden/page_view.h"

namespace umbrage {
namespace {

using testing::HasSubstr;
using testing::Not;

/// Every half there is, by its definition (IEEE 754, binary16).
float valueOfHalf(std::uint32_t bits) {
    const int exponent = int(bits >> 10 & 31);
    const double fraction = double(bits & 1023) / 1024.0;
    const double size = exponent == 0 ? std::ldexp(fraction, -14) : std::ldexp(1.0 + fraction, exponent - 15);
    return float(bits & 0x8000 ? -size : size);
}

TEST(PackedPicture, FindsEveryHalfAndNothingBetween) {
    for (std::uint32_t bits = 0; bits < 0x10000; ++bits) {
        if ((bits >> 10 & 31) == 31) continue;
        const float value = valueOfHalf(bits);
        ASSERT_EQ(exactHalf(value), bits);
        ASSERT_FALSE(exactHalf(std::nextafter(value, INFINITY))) << bits;
    }
    EXPECT_EQ(exactHalf(INFINITY), 0x7c00);
    EXPECT_EQ(exactHalf(-INFINITY), 0xfc00);
    EXPECT_EQ(*exactHalf(NAN) & 0x7fff, 0x7e00);
    EXPECT_FALSE(exactHalf(65520.0f));
    EXPECT_FALSE(exactHalf(1e30f));
}

TEST(PackedPicture, TakesTheSmallestTypeThatIsExact) {
    std::vector<float> bytes, scaled, words;
    for (int k = 0; k < 256; ++k) bytes.push_back(float(k) / 255.0f);
    for (int k = 0; k < 256; ++k) scaled.push_back(float(k) * (1.0f / 255.0f));
    for (int k = 0; k < 65536; k += 7) words.push_back(float(k) / 65535.0f);
    EXPECT_EQ(packedType(bytes, true), PackedType::UInt8);
    EXPECT_EQ(packedType(scaled, true), PackedType::UInt8);
    EXPECT_EQ(packedType(bytes, false), PackedType::Float) << "linear values need not be codes";
    EXPECT_EQ(packedType(words, true), PackedType::UInt16);
    EXPECT_EQ(packedType({0.5f, 2048.0f, INFINITY, NAN}, false), PackedType::Half);
    EXPECT_EQ(packedType({2049.0f}, false), PackedType::Float);
    EXPECT_EQ(packedType({0.5f, NAN}, true), PackedType::Half);
}

TEST(PackedPicture, AnOutputLikeItsGoldenIsSmall) {
    ImageResult image = sequence(16).images[15];
    ASSERT_EQ(image.outcome, Outcome::Fail);
    const PackedPictures values = packed(picturesOf(image, 128, 96));
    EXPECT_EQ(values.output->head["from"], "golden");
    EXPECT_EQ(values.golden->head["from"], "left");
    EXPECT_LT(values.output->text.size() * 20, values.golden->text.size());
    const PackedPictures other = packed({pictureOf(image, 128, 96, false), pictureOf(image, 127, 96, true)});
    EXPECT_EQ(other.output->head["from"], "left");
}

TEST(PageView, ShowsColourAsItIsAndStretchesTheRest) {
    const PagePicture color{1, 1, {"A", "B", "G", "R"}, {0.5f, 0.1f, 0.2f, 0.214041f}, false};
    const PageView view = viewOf(color);
    EXPECT_EQ(view.shown, (std::array{3, 2, 1}));
    const std::vector<float> rgba = displayRgba(color, view);
    EXPECT_NEAR(rgba[0], 0.5f, 1e-4f) << "0.214 is the linear value of sRGB's 0.5";
    EXPECT_EQ(rgba[3], 0.5f);

    const PagePicture depth{2, 2, {"Z"}, {2.0f, 4.0f, INFINITY, NAN}, false};
    EXPECT_EQ(displayRgba(depth, viewOf(depth)), (std::vector<float>{0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 0, 1, 1}));
    const PagePicture same{1, 2, {"Z"}, {3.0f, 3.0f}, false};
    EXPECT_EQ(displayRgba(same, viewOf(same))[0], 1.0f);
    const PagePicture png{1, 1, {"Y"}, {0.25f}, true};
    EXPECT_EQ(displayRgba(png, viewOf(png)), (std::vector<float>{0.25f, 0.25f, 0.25f, 1.0f}));
}

TEST(ComparisonPage, AsksForNothingOutside) {
    const std::string page =
        comparisonPage(everyOutcome(), [](const ImageResult& image) { return picturesOf(image, 64, 48); });
    EXPECT_THAT(page, testing::StartsWith("<!DOCTYPE html>"));
    std::string withoutNamespace = page;
    const std::string svg = "http://www.w3.org/2000/svg";
    while (withoutNamespace.find(svg) != std::string::npos) {
        withoutNamespace.replace(withoutNamespace.find(svg), svg.size(), "");
    }
    EXPECT_EQ(withoutNamespace.find("://"), std::string::npos);
    EXPECT_THAT(page, HasSubstr("default-src 'none'"));
    EXPECT_THAT(page, HasSubstr("<title>Golden frames: fail</title>"));
    EXPECT_THAT(page, Not(HasSubstr("<a> & \\\"b")));
    EXPECT_THAT(page, HasSubstr("id=\"golden-4\""));
    EXPECT_THAT(page, HasSubstr("id=\"output-1\"")) << "what warns";
    EXPECT_THAT(page, Not(HasSubstr("id=\"golden-0\""))) << "what passes";
}

TEST(ComparisonPage, WorksWithoutPictures) {
    const auto none = [](const ImageResult&) { return std::nullopt; };
    EXPECT_THAT(comparisonPage({}, none), HasSubstr("nothing was compared"));
    EXPECT_THAT(comparisonPage(everyOutcome(), none), HasSubstr("beauty/fail.0001.png"));
    EXPECT_THAT(comparisonPage(everyOutcome(), [](const ImageResult&) { return PagePictures{}; }), HasSubstr("1 warn"));
}

TEST(ComparisonPage, SaysFailOfABrokenBudgetAlone) {
    const std::string page = comparisonPage(overBudget(), [](const ImageResult&) { return std::nullopt; });
    EXPECT_THAT(page, HasSubstr("<title>Golden frames: fail</title>"));
    EXPECT_THAT(page, HasSubstr("\"verdict\":\"1 fail, 61 pass\""));
    EXPECT_THAT(page, HasSubstr("\"name\":\"overdraw.p95\",\"max\":6,\"value\":7.25"));
    EXPECT_LT(page.find("id=\"budgets-part\""), page.find("id=\"images\""));
}

TEST(ComparisonPage, SaysWhatWasLeftOutOfALargePage) {
    Comparison comparison = sequence(3);
    comparison.images[0].outcome = Outcome::Warn;
    for (std::size_t i = 1; i < 12; ++i) comparison.images[i].outcome = Outcome::Fail;
    const auto pictures = [](const ImageResult& image) { return picturesOf(image, 64, 48); };
    EXPECT_THAT(comparisonPage(comparison, pictures), HasSubstr("\"leftOut\":0"));
    const std::string page = comparisonPage(comparison, pictures, 1);
    EXPECT_THAT(page, HasSubstr("\"leftOut\":11"));
    EXPECT_THAT(page, HasSubstr("id=\"golden-1\"")) << "the first failure";
    EXPECT_THAT(page, Not(HasSubstr("id=\"golden-0\""))) << "what only warns waits";
}

}  // namespace
}  // namespace umbrage
