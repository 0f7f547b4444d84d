// SPDX-License-Identifier: Apache-2.0
// The viewer on the page of a comparison: values under the pointer, slider, zoom, heat map, transparency.
#include <algorithm>
#include <cmath>
#include <set>

#include "comparison_page.h"
#include "image/false_color.h"

namespace umbrage::cli {
namespace {

const ImageResult& imageOf(const Comparison& comparison, const std::string& name) {
    return *std::find_if(comparison.images.begin(), comparison.images.end(),
                         [&](const ImageResult& image) { return image.name == name; });
}

TEST_F(ComparisonPage, ReadsTheRightValuesInEveryPane) {
    const Comparison comparison = sequence(32);
    const ImageResult& beauty = imageOf(comparison, "beauty.0016.png");
    const PagePictures pictures = picturesOf(beauty, kWidth, kHeight);
    for (const auto& [x, y] : {std::pair{0, 0}, {63, 47}, {40, 30}, {47, 37}, {48, 37}, {12, 3}}) {
        for (const char* pane : {"golden", "output", "difference"}) {
            pointAt(pane, x, y);
            ASSERT_EQ(textOf("#place"), "pixel " + std::to_string(x) + ", " + std::to_string(y)) << pane;
            const auto valueAt = [&](const PagePicture& picture, std::size_t c) {
                return double(picture.values[(std::size_t(y) * kWidth + std::size_t(x)) * 4 + c]);
            };
            const std::vector<std::string> display = valuesOf("output display"), linear = valuesOf("golden linear"),
                                           difference = valuesOf("difference");
            ASSERT_EQ(display.size(), 4u);
            for (std::size_t c = 0; c < 4; ++c) {
                EXPECT_EQ(std::stol(display[c]), std::lround(255.0 * valueAt(*pictures.output, c)));
                const double golden = valueAt(*pictures.golden, c);
                const double wanted = c == 3              ? golden
                                      : golden <= 0.04045 ? golden / 12.92
                                                          : std::pow((golden + 0.055) / 1.055, 2.4);
                EXPECT_NEAR(std::stod(linear[c]), wanted, 1e-6);
                EXPECT_NEAR(std::stod(difference[c]), valueAt(*pictures.output, c) - golden, 1e-6);
            }
        }
    }
}

TEST_F(ComparisonPage, ReadsHalvesFloatsAndWhatIsNoNumberExactly) {
    Comparison comparison;
    ImageResult& image = comparison.images.emplace_back();
    image.name = "all.exr";
    image.outcome = Outcome::NonFinite;
    const std::vector<float> halves{0.0f, -0.5f, 65504.0f, 5.9604645e-8f, 0.333251953125f, -INFINITY};
    const std::vector<float> floats{16777216.0f, 1.1754944e-38f, NAN, 0.1f, -3.4028235e38f, 7.0f};
    const PagePicture golden{6, 1, {"Z"}, halves, false}, output{6, 1, {"Z"}, floats, false};
    show(comparison, [&](const ImageResult&) { return PagePictures{golden, output}; });
    for (int x = 0; x < 6; ++x) {
        x == 0 ? evaluate("viewer.moveCursor(-9, 0)") : evaluate("viewer.moveCursor(1, 0)");
        const auto read = [&](const char* row) { return std::strtof(valuesOf(row)[0].c_str(), nullptr); };
        EXPECT_EQ(read("golden"), halves[std::size_t(x)]) << x;
        if (x == 2) {
            EXPECT_EQ(valuesOf("output")[0], "nan");
            EXPECT_EQ(valuesOf("difference")[0], "nan");
        } else {
            EXPECT_EQ(read("output"), floats[std::size_t(x)]) << x;
        }
    }
}

TEST_F(ComparisonPage, TheSliderShowsGoldenLeftAndOutputRight) {
    const double x = 42.5 / kWidth, y = 33.5 / kHeight;
    press("s");
    const std::vector<int> golden = colorOf("output", x, y);
    press("s");
    const std::vector<int> output = colorOf("output", x, y);
    press("l");
    const auto slide = [&](int percent) {
        evaluate("document.getElementById('split').value = " + std::to_string(percent) +
                 ", document.getElementById('split').dispatchEvent(new Event('input'))");
    };
    slide(80);
    EXPECT_EQ(colorOf("output", x, y), golden);
    slide(20);
    EXPECT_EQ(colorOf("output", x, y), output);
    EXPECT_NE(golden, output);
}

TEST_F(ComparisonPage, ZoomsAllPanesAtOnceAndReadsPixelsByKey) {
    EXPECT_EQ(colorOf("difference", 0.1, 0.1), (std::vector<int>{0, 0, 0, 255})) << "equal";
    press("w");
    EXPECT_EQ(textOf("#place"), "pixel 40, 30");
    const double ratio = evaluate("document.getElementById('pane-golden').clientWidth / 64");
    EXPECT_NEAR(evaluate("parseFloat(document.getElementById('zoom').textContent)").get<double>(), 8 * ratio, 0.1);
    // eight pixels fit a pane now: the square that differs begins in its middle
    EXPECT_EQ(colorOf("difference", 0.25, 0.25), (std::vector<int>{0, 0, 0, 255}));
    EXPECT_NE(colorOf("difference", 0.75, 0.75), (std::vector<int>{0, 0, 0, 255}));
    pressWithShift("ArrowRight");
    pressWithShift("ArrowDown");
    pressWithShift("ArrowDown");
    pressWithShift("ArrowLeft");
    pressWithShift("ArrowUp");
    EXPECT_EQ(textOf("#place"), "pixel 40, 31");
    press("-");
    EXPECT_NEAR(evaluate("parseFloat(document.getElementById('zoom').textContent)").get<double>(), 4 * ratio, 0.1);
    press("+");
    EXPECT_NEAR(evaluate("parseFloat(document.getElementById('zoom').textContent)").get<double>(), 8 * ratio, 0.1);
    press("0");
    EXPECT_NEAR(evaluate("parseFloat(document.getElementById('zoom').textContent)").get<double>(), ratio, 0.1);
    EXPECT_EQ(textOf("#image-title"), "beauty.0016.png fail") << "with Shift, arrows choose pixels";
}

TEST_F(ComparisonPage, TheScaleOfTheHeatMapIsFixed) {
    const double x = 42.5 / kWidth, y = 33.5 / kHeight;
    const auto colorAt = [&](const char* scale) {
        evaluate("document.getElementById('scale').value = '" + std::string(scale) +
                 "', document.getElementById('scale').dispatchEvent(new Event('change'))");
        return colorOf("difference", x, y);
    };
    const FalseColor one(1.0f), hundred(100.0f);
    const auto shown = [](const Rgb8& color) { return std::vector<int>{color[0], color[1], color[2], 255}; };
    const auto near = [](const std::vector<int>& a, const std::vector<int>& b) {
        int most = 0;
        for (std::size_t c = 0; c < 4; ++c) most = std::max(most, std::abs(a[c] - b[c]));
        return most <= 4;  // 0.5 is 127/255 or 128/255 here: one step of the table
    };
    EXPECT_TRUE(near(colorAt("1"), shown(one.at(0.5f, 42, 33))));
    EXPECT_TRUE(near(colorAt("100"), shown(hundred.at(0.5f, 42, 33))));
    EXPECT_TRUE(near(colorAt("0.1"), shown(FalseColor(0.1f).at(0.5f, 42, 33)))) << "off the scale";
    EXPECT_EQ(textOf("#legend-most"), "0.1");
}

TEST_F(ComparisonPage, AlphaLiesOnACheckerboard) {
    Comparison comparison;
    ImageResult& image = comparison.images.emplace_back();
    image.name = "clear.png";
    image.outcome = Outcome::Fail;
    const PagePicture clear{1, 1, {"R", "G", "B", "A"}, {1.0f, 0.0f, 0.0f, 0.0f}, true};
    const PagePicture solid{1, 1, {"R", "G", "B", "A"}, {1.0f, 0.0f, 0.0f, 1.0f}, true};
    show(comparison, [&](const ImageResult&) { return PagePictures{clear, solid}; });
    std::set<std::vector<int>> colors;
    for (int i = 0; i < 20; ++i) colors.insert(colorOf("golden", 0.3 + 0.01 * i, 0.5));
    EXPECT_EQ(colors, (std::set<std::vector<int>>{{255, 255, 255, 255}, {200, 200, 200, 255}}));
    EXPECT_EQ(colorOf("output", 0.5, 0.5), (std::vector<int>{255, 0, 0, 255}));
}

}  // namespace
}  // namespace umbrage::cli
