// SPDX-License-Identifier: Apache-2.0
// Pictures of what is wrong: colours that everybody can tell apart, the worst place found, any size of frame.
#include "report/error_picture.h"

#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <map>

#include "verdicts.h"

namespace umbrage {
namespace {

constexpr SampleVerdict kWrong[] = {SampleVerdict::Primary, SampleVerdict::Grazing, SampleVerdict::Boundary,
                                    SampleVerdict::FalseDark, SampleVerdict::FalseLit};

using Matrix = std::array<std::array<double, 3>, 3>;

/// What eyes without one kind of cones see, in linear RGB (Machado, Oliveira and Fernandes 2009, severity 1).
const std::map<std::string, Matrix> kEyes = {
    {"all cones", {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}},
    {"no long ones",
     {{{0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998}}}},
    {"no medium ones",
     {{{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}}}},
    {"no short ones",
     {{{1.255528, -0.076749, -0.178779}, {-0.078411, 0.930809, 0.147602}, {0.004733, 0.691367, 0.303900}}}}};

/// CIE Lab of a display colour as seen by such an eye.
std::array<double, 3> labOf(const Rgb8& color, const Matrix& eye) {
    std::array<double, 3> linear{}, seen{};
    for (std::size_t c = 0; c < 3; ++c) {
        const double v = color[c] / 255.0;
        linear[c] = v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
    }
    for (std::size_t c = 0; c < 3; ++c) {
        const double v = eye[c][0] * linear[0] + eye[c][1] * linear[1] + eye[c][2] * linear[2];
        seen[c] = std::clamp(v, 0.0, 1.0);
    }
    const auto f = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116.0; };
    const double x = f((0.4124 * seen[0] + 0.3576 * seen[1] + 0.1805 * seen[2]) / 0.9505);
    const double y = f(0.2126 * seen[0] + 0.7152 * seen[1] + 0.0722 * seen[2]);
    const double z = f((0.0193 * seen[0] + 0.1192 * seen[1] + 0.9505 * seen[2]) / 1.089);
    return {116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)};
}

double difference(const Rgb8& a, const Rgb8& b, const Matrix& eye) {
    const std::array<double, 3> p = labOf(a, eye), q = labOf(b, eye);
    return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

/// A frame in one grey, judged right everywhere.
struct Judged {
    FrameVerdict verdict;
    VerdictPlanes planes;
    std::vector<std::uint8_t> display;

    Judged(int width, int height, std::size_t lights) {
        verdict = frame(7, "compute:z-pass", {});
        planes.width = width;
        planes.height = height;
        const std::size_t pixels = std::size_t(width) * std::size_t(height);
        display.assign(3 * pixels, 100);
        for (std::size_t l = 0; l < lights; ++l) {
            LightVerdict& made = verdict.lights.emplace_back();
            made.light = "Light" + std::to_string(l);
            made.litFacing = pixels;
            planes.verdicts.emplace_back(pixels, SampleVerdict::Right);
            planes.exact.emplace_back(pixels, std::uint8_t(1));
        }
    }

    void set(std::size_t light, int x, int y, SampleVerdict to) {
        planes.verdicts[light][std::size_t(y) * std::size_t(planes.width) + std::size_t(x)] = to;
        LightVerdict& sum = verdict.lights[light];
        ++(to == SampleVerdict::FalseDark  ? sum.hardFalseDark
           : to == SampleVerdict::FalseLit ? sum.hardFalseLit
           : to == SampleVerdict::Boundary ? sum.boundary
           : to == SampleVerdict::Grazing  ? sum.grazing
                                           : sum.primary);
    }

    RgbPicture draw() const { return drawErrors("A1", verdict, planes, display); }
};

std::size_t pixelsOf(const RgbPicture& picture, const Rgb8& color) {
    std::size_t found = 0;
    for (std::size_t i = 0; i < picture.rgb.size(); i += 3) {
        found += std::equal(color.begin(), color.end(), picture.rgb.begin() + std::ptrdiff_t(i));
    }
    return found;
}

TEST(ErrorColours, EverybodyCanTellThemApartAndFromTheFrame) {
    for (const auto& [name, eye] : kEyes) {
        for (const SampleVerdict a : kWrong) {
            for (const SampleVerdict b : kWrong) {
                if (a == b) continue;
                EXPECT_GT(difference(colorOf(a), colorOf(b), eye), 25.0) << int(a) << " " << int(b) << name;
            }
            for (int grey = 20; grey <= 162; ++grey) {  // the dimmed frame's, enlarged or not
                const auto g = std::uint8_t(grey);
                EXPECT_GT(difference(colorOf(a), {g, g, g}, eye), 20.0) << int(a) << " " << grey << " " << name;
            }
        }
    }
}

TEST(WorstPlace, HasTheErrorInItsMiddle) {
    std::vector<SampleVerdict> verdicts(100 * 80, SampleVerdict::Right);
    verdicts[40 * 100 + 60] = SampleVerdict::FalseLit;
    const PixelRectangle place = worstPlace(verdicts, 100, 80, 17, 17);
    EXPECT_EQ(place.x, 52);
    EXPECT_EQ(place.y, 32);
    EXPECT_EQ(place.width, 17);
    EXPECT_EQ(place.height, 17);
}

TEST(WorstPlace, PrefersManyHardErrorsToFewAndAnyToTheBand) {
    std::vector<SampleVerdict> verdicts(100 * 80, SampleVerdict::Right);
    for (int i = 0; i < 50; ++i) verdicts[std::size_t(10 * 100 + i)] = SampleVerdict::Boundary;
    const auto sees = [](const PixelRectangle& r, int x, int y) {
        return x >= r.x && x < r.x + r.width && y >= r.y && y < r.y + r.height;
    };
    EXPECT_TRUE(sees(worstPlace(verdicts, 100, 80, 16, 16), 8, 10));
    verdicts[70 * 100 + 5] = SampleVerdict::FalseDark;
    EXPECT_TRUE(sees(worstPlace(verdicts, 100, 80, 16, 16), 5, 70));
    verdicts[5 * 100 + 90] = verdicts[5 * 100 + 92] = SampleVerdict::FalseLit;
    const PixelRectangle two = worstPlace(verdicts, 100, 80, 16, 16);
    EXPECT_TRUE(sees(two, 90, 5) && sees(two, 92, 5));
}

TEST(WorstPlace, StaysInTheFrame) {
    for (const auto& [width, height] : {std::pair{1, 1}, {17, 13}, {8191, 3}, {40, 40}}) {
        std::vector<SampleVerdict> verdicts(std::size_t(width) * std::size_t(height), SampleVerdict::Right);
        for (const bool wrong : {false, true}) {
            if (wrong) verdicts.back() = SampleVerdict::FalseDark;
            const PixelRectangle place = worstPlace(verdicts, width, height, 16, 16);
            EXPECT_GE(place.x, 0);
            EXPECT_GE(place.y, 0);
            EXPECT_LE(place.x + place.width, width);
            EXPECT_LE(place.y + place.height, height);
            EXPECT_EQ(place.width, std::min(16, width));
            EXPECT_EQ(place.height, std::min(16, height));
        }
    }
}

TEST(ErrorPicture, ShowsEveryClassInItsColour) {
    Judged judged(64, 48, 2);
    const std::size_t legendOnly = pixelsOf(judged.draw(), colorOf(SampleVerdict::Grazing));
    EXPECT_GT(legendOnly, 0u) << "the legend";
    int x = 10;
    for (const SampleVerdict verdict : kWrong) judged.set(1, x += 8, 20, verdict);
    const RgbPicture picture = judged.draw();
    for (const SampleVerdict verdict : kWrong)
        EXPECT_GT(pixelsOf(picture, colorOf(verdict)), legendOnly) << int(verdict);
}

TEST(ErrorPicture, ShowsTheErrorsOfAllLights) {
    Judged one(64, 48, 2), both(64, 48, 2);
    one.set(0, 10, 10, SampleVerdict::FalseDark);
    one.set(0, 11, 10, SampleVerdict::FalseDark);
    both = one;
    both.set(1, 40, 30, SampleVerdict::FalseLit);
    const Rgb8 lit = colorOf(SampleVerdict::FalseLit);
    EXPECT_GT(pixelsOf(both.draw(), lit), pixelsOf(one.draw(), lit));
}

TEST(ErrorPicture, EnlargesTheWorstPlaceWithTheExactAnswerOnEachPixel) {
    Judged judged(256, 192, 1);
    judged.set(0, 100, 100, SampleVerdict::FalseDark);
    const std::size_t lit = pixelsOf(judged.draw(), kInk);
    judged.planes.exact[0].assign(judged.planes.exact[0].size(), 0);
    const std::size_t dark = pixelsOf(judged.draw(), kInk);
    EXPECT_EQ(lit - dark, 32u * 32u * 9u) << "a white dot of 3x3 on each of the 32x32 pixels";
    // One pixel in the frame at twice its size, its box, its 11x11 square less the dot, and the legend's 7x7 swatch.
    EXPECT_EQ(pixelsOf(judged.draw(), colorOf(SampleVerdict::FalseDark)), 4u + 4u * 19u + 121u - 9u + 49u);
}

TEST(ErrorPicture, TheFrameIsDimmedAndGrey) {
    Judged judged(256, 192, 1);
    for (std::size_t i = 0; i < judged.display.size(); i += 3) judged.display[i] = 255;  // reddish
    const RgbPicture picture = judged.draw();
    const std::size_t inFrame = 3 * (20 * std::size_t(picture.width) + 20);
    EXPECT_EQ(picture.rgb[inFrame], picture.rgb[inFrame + 1]);
    EXPECT_EQ(picture.rgb[inFrame], picture.rgb[inFrame + 2]);
    EXPECT_LT(picture.rgb[inFrame], 100);
}

TEST(ErrorPicture, CanBeDrawnOfAnyFrame) {
    for (const auto& [width, height] : {std::pair{1, 1}, {17, 13}, {8191, 3}, {3, 1000}, {1920, 1080}}) {
        for (const std::size_t lights : {0u, 1u, 3u}) {
            Judged judged(width, height, lights);
            if (lights > 0) judged.set(lights - 1, width - 1, height - 1, SampleVerdict::FalseLit);
            const RgbPicture picture = judged.draw();
            EXPECT_GE(picture.width, width);
            EXPECT_GE(picture.height, height);
            EXPECT_EQ(picture.rgb.size(), 3 * std::size_t(picture.width) * std::size_t(picture.height));
        }
    }
}

TEST(ErrorPicture, LongNamesAndLargeFiguresStayInside) {
    Judged judged(64, 48, 1);
    judged.verdict.lights[0].light = std::string(500, 'W');
    judged.verdict.lights[0].hardFalseDark = ~std::uint64_t{0};
    judged.verdict.lights[0].primary = ~std::uint64_t{0};
    judged.verdict.technique = std::string(500, 'T');
    EXPECT_EQ(judged.draw().width, Judged(64, 48, 1).draw().width);
}

TEST(DisplayBytes, AreRoundedClampedAndBlackWhereThereIsNoNumber) {
    const float nan = std::nanf("");
    EXPECT_THAT(rgbBytes(std::vector<float>{-1.0f, 0.0f, 0.5f, 9.0f, 1.0f, 2.0f, nan, nan}),
                testing::ElementsAre(0, 0, 128, 255, 255, 0));
}

}  // namespace
}  // namespace umbrage
