// SPDX-License-Identifier: Apache-2.0
#include "image/overlay.h"

#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <limits>
#include <set>

#include "image/bitmap_font.h"

namespace umbrage {
namespace {

using Rgb = std::array<int, 3>;

constexpr Rgb kBlack{0, 0, 0}, kInk{235, 235, 235};

struct Picture {
    int width, height;
    std::vector<std::uint8_t> rgb;

    Rgb at(int x, int y) const {
        const std::size_t i = 3 * (std::size_t(y) * width + x);
        return {rgb[i], rgb[i + 1], rgb[i + 2]};
    }
};

Picture draw(int width, int height, const std::vector<float>& counts, const OverlayStyle& style,
             const std::vector<std::uint8_t>& beauty = {}) {
    return {width, height, drawOverlay(width, height, counts, beauty, style).rgb};
}

/// The colour of one count, from a picture too small for a legend.
Rgb colorOf(float count, float scaleMaximum = 8.0f) {
    return draw(2, 2, {count, count, count, count}, {"", scaleMaximum}).at(1, 1);
}

double luminance(const Rgb& color) {
    const auto linear = [](int code) { return std::pow(code / 255.0, 2.2); };
    return 0.2126 * linear(color[0]) + 0.7152 * linear(color[1]) + 0.0722 * linear(color[2]);
}

/// Whether the text stands at (x, y) at this scale: ink where the glyphs are and none between.
bool textStandsAt(const Picture& picture, std::string_view text, int x, int y, int scale) {
    if (x + textWidth(text) * scale > picture.width || y + kGlyphHeight * scale > picture.height) return false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        for (int py = 0; py < kGlyphHeight * scale; ++py) {
            for (int px = 0; px < kGlyphWidth * scale; ++px) {
                const bool ink = picture.at(x + static_cast<int>(i) * kGlyphAdvance * scale + px, y + py) == kInk;
                if (ink != glyphCovers(text[i], px / scale, py / scale)) return false;
            }
        }
    }
    return true;
}

int countOfText(const Picture& picture, std::string_view text, int scale) {
    int found = 0;
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) found += textStandsAt(picture, text, x, y, scale);
    }
    return found;
}

TEST(FalseColour, NothingCountedAndNoDataAreBlackWithoutABeautyPicture) {
    EXPECT_EQ(colorOf(0.0f), kBlack);
    EXPECT_EQ(colorOf(std::numeric_limits<float>::quiet_NaN()), kBlack);
}

TEST(FalseColour, GrowsLighterWithEveryCountFromVioletToYellow) {
    double before = 0.0;
    for (int count = 1; count <= 32; ++count) {
        const double now = luminance(colorOf(static_cast<float>(count), 32.0f));
        EXPECT_GT(now, before * 1.02) << count;
        before = now;
    }
    const Rgb first = colorOf(0.01f), last = colorOf(8.0f);
    EXPECT_GT(first[2], first[0]);
    EXPECT_GT(first[0], first[1]);
    EXPECT_GT(last[0], 220);
    EXPECT_GT(last[1], 200);
    EXPECT_LT(last[2], 140);
}

TEST(FalseColour, HangsOnTheScaleAlone) {
    EXPECT_EQ(colorOf(2.0f, 8.0f), colorOf(4.0f, 16.0f));
    EXPECT_NE(colorOf(2.0f, 8.0f), colorOf(2.0f, 16.0f));
}

TEST(FalseColour, OffTheScaleIsStripedInColoursTheScaleDoesNotHave) {
    std::set<Rgb> scale;
    for (int i = 1; i <= 255; ++i) scale.insert(colorOf(static_cast<float>(i), 255.0f));
    for (const float count : {-1.0f, 8.5f}) {
        const Picture picture = draw(8, 8, std::vector<float>(64, count), {"", 8.0f});
        std::set<Rgb> seen;
        for (int y = 0; y < 8; ++y) {
            for (int x = 0; x < 8; ++x) seen.insert(picture.at(x, y));
        }
        EXPECT_EQ(seen.size(), 2u) << count;
        for (const Rgb& color : seen) EXPECT_FALSE(scale.contains(color)) << count;
    }
    EXPECT_NE(colorOf(-1.0f), colorOf(9.0f));
}

TEST(Overlay, BeautyShowsDimmedAndGreyWhereNothingIsCounted) {
    const std::vector<std::uint8_t> beauty{255, 0, 0, 200, 200, 200};
    const Picture picture = draw(2, 1, {0.0f, 0.0f}, {"", 8.0f}, beauty);
    EXPECT_EQ(picture.at(0, 0), (Rgb{19, 19, 19}));
    EXPECT_EQ(picture.at(1, 0), (Rgb{70, 70, 70}));
}

TEST(Overlay, CountsKeepTheirColourOverTheBeautyPicture) {
    const std::vector<std::uint8_t> dark(3, 0), light(3, 255);
    const Rgb pure = colorOf(5.0f);
    const Rgb overDark = draw(1, 1, {5.0f}, {"", 8.0f}, dark).at(0, 0);
    const Rgb overLight = draw(1, 1, {5.0f}, {"", 8.0f}, light).at(0, 0);
    for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(overDark[c], 0.8 * pure[c], 1.0);
        EXPECT_NEAR(overLight[c], 0.8 * pure[c] + 0.2 * 255, 1.0);
    }
}

TEST(Legend, HasItsTitleAndTickNumbersAtBothSizes) {
    for (const auto& [width, height, scale] : {std::tuple{1024, 768, 2}, {256, 192, 1}}) {
        const Picture picture =
            draw(width, height, std::vector<float>(std::size_t(width) * height), {"Stencil, Lamp", 4.0f});
        EXPECT_EQ(countOfText(picture, "STENCIL, LAMP", scale), 1);
        for (const char* number : {"0", "1", "2", "3", ">4", "<0"})
            EXPECT_GE(countOfText(picture, number, scale), 1) << number;
    }
}

TEST(Legend, NumbersOfALongScaleStandClear) {
    const Picture picture = draw(256, 192, std::vector<float>(256 * 192), {"Overdraw", 1000.0f});
    EXPECT_EQ(countOfText(picture, "1000", 1), 2);  // the last tick and ">1000"
    EXPECT_EQ(countOfText(picture, "500", 1), 1);
    EXPECT_EQ(countOfText(picture, "100", 1), 2);  // only as part of 1000
}

TEST(Legend, ItsBarRunsThroughTheColoursOfTheCounts) {
    const Picture picture = draw(256, 192, std::vector<float>(256 * 192), {"Overdraw", 8.0f});
    std::set<Rgb> seen;
    for (int y = 0; y < 192; ++y) {
        for (int x = 0; x < 256; ++x) seen.insert(picture.at(x, y));
    }
    for (int count = 1; count < 8; ++count) {
        const Rgb wanted = colorOf(static_cast<float>(count));
        const bool close = std::any_of(seen.begin(), seen.end(), [&](const Rgb& color) {
            return std::abs(color[0] - wanted[0]) + std::abs(color[1] - wanted[1]) + std::abs(color[2] - wanted[2]) <
                   12;
        });
        EXPECT_TRUE(close) << count;
    }
}

TEST(Legend, ALongTitleEndsInDots) {
    const Picture picture = draw(256, 192, std::vector<float>(256 * 192), {std::string(80, 'W'), 8.0f});
    EXPECT_EQ(countOfText(picture, "WW...", 1), 1);
}

TEST(Legend, IsLeftOutOfPicturesTooSmallForIt) {
    for (const auto& [width, height] : {std::pair{64, 48}, {1, 1}, {4000, 3}, {3, 4000}}) {
        const Picture picture =
            draw(width, height, std::vector<float>(std::size_t(width) * height), {"Overdraw", 8.0f});
        EXPECT_EQ(std::count(picture.rgb.begin(), picture.rgb.end(), 0), static_cast<long>(picture.rgb.size()));
    }
}

TEST(BitmapFont, EveryPrintableCharacterHasAGlyphOfItsOwn) {
    std::set<std::string> shapes;
    int glyphs = 0;
    for (char c = ' '; c <= '_'; ++c) {
        std::string shape;
        for (int y = 0; y < kGlyphHeight; ++y) {
            for (int x = 0; x < kGlyphWidth; ++x) shape += glyphCovers(c, x, y) ? '#' : '.';
        }
        shapes.insert(shape);
        ++glyphs;
    }
    EXPECT_EQ(shapes.size(), static_cast<std::size_t>(glyphs));
}

TEST(BitmapFont, SmallLettersLookLikeCapitalsAndTheRestIsABox) {
    for (int y = 0; y < kGlyphHeight; ++y) {
        for (int x = 0; x < kGlyphWidth; ++x) {
            EXPECT_EQ(glyphCovers('q', x, y), glyphCovers('Q', x, y));
            const bool border = x == 0 || y == 0 || x == kGlyphWidth - 1 || y == kGlyphHeight - 1;
            EXPECT_EQ(glyphCovers('\xE4', x, y), border);
        }
    }
}

}  // namespace
}  // namespace umbrage
