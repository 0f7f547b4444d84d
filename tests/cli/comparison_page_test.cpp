// SPDX-License-Identifier: Apache-2.0
// The page of a comparison in a real browser, without a network.
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "../unit/golden/comparisons.h"
#include "browser.h"
#include "image/false_color.h"
#include "workspace.h"

namespace umbrage::cli {
namespace {

using Json = nlohmann::json;

constexpr int kWidth = 64, kHeight = 48;

class ComparisonPage : public Workspace {
protected:
    void SetUp() override {
        Workspace::SetUp();
        if (Browser::program().empty()) GTEST_SKIP() << "there is no chromium here";
        browser_ = std::make_unique<Browser>(folder() / "profile");
        show(sequence(32), [](const ImageResult& image) { return picturesOf(image, kWidth, kHeight); });
    }

    void TearDown() override {
        if (browser_) expectQuietAndOffline(*browser_);
        browser_.reset();
        Workspace::TearDown();
    }

    void show(const Comparison& comparison,
              const std::function<std::optional<PagePictures>(const ImageResult&)>& pictures) {
        writeFile("compare.html", comparisonPage(comparison, pictures));
        browser().open("file://" + (folder() / "compare.html").string());
        settle();
    }

    Browser& browser() { return *browser_; }

    Json evaluate(const std::string& expression) { return browser().evaluate(expression); }

    /// Waits until the chosen image is unpacked and drawn.
    void settle() {
        const Json ready =
            browser().call("Runtime.evaluate", {{"expression",
                                                 "new Promise((done, fail) => { let tries = 0; const look = () => "
                                                 "document.getElementById('viewer').dataset.ready !== undefined ? "
                                                 "done(true) : ++tries > 600 ? fail('never "
                                                 "ready') : setTimeout(look, 10); look(); })"},
                                                {"awaitPromise", true},
                                                {"returnByValue", true}});
        ASSERT_EQ(ready["result"]["value"], true) << ready.dump();
    }

    void press(const std::string& key) {
        browser().press(key);
        settle();
    }

    void pressWithShift(const std::string& key) {
        browser().call("Input.dispatchKeyEvent", {{"type", "keyDown"}, {"key", key}, {"modifiers", 8}});
        browser().call("Input.dispatchKeyEvent", {{"type", "keyUp"}, {"key", key}, {"modifiers", 8}});
    }

    void click(const std::string& selector) {
        const auto [x, y] = placeOf(selector, 0.5, 0.5);
        browser().click(x, y);
        settle();
    }

    std::string textOf(const std::string& selector) {
        return evaluate("document.querySelector('" + selector + "').textContent");
    }

    /// Where a part of an element's width and height is, after it has been scrolled into view.
    std::pair<double, double> placeOf(const std::string& selector, double across, double down) {
        const Json box = evaluate("(() => { const e = document.querySelector('" + selector +
                                  "'); e.scrollIntoView({block: 'center', inline: 'center'}); const b = "
                                  "e.getBoundingClientRect(); return [b.x, b.y, b.width, b.height]; })()");
        return {box[0].get<double>() + across * box[2].get<double>(),
                box[1].get<double>() + down * box[3].get<double>()};
    }

    /// Points at a pixel of a picture that fills its pane.
    void pointAt(const std::string& pane, int x, int y) {
        const auto [atX, atY] = placeOf("#pane-" + pane, (x + 0.5) / kWidth, (y + 0.5) / kHeight);
        browser().movePointer(atX, atY);
    }

    /// A row of the read-out.
    std::vector<std::string> valuesOf(const std::string& row) {
        return evaluate("[...document.querySelectorAll('#readout tr[data-row=\"" + row +
                        "\"] td')].map(cell => cell.textContent)")
            .get<std::vector<std::string>>();
    }

    std::vector<std::string> shownNames() {
        return evaluate(
                   "[...document.querySelectorAll('#images tbody tr')].filter(row => !row.hidden).map(row => "
                   "row.cells[0].dataset.value)")
            .get<std::vector<std::string>>();
    }

    /// The colour of a pane at a part of its width and height.
    std::vector<int> colorOf(const std::string& pane, double across, double down) {
        return evaluate("(() => { const pane = document.getElementById('pane-" + pane +
                        "'), one = document.createElement('canvas').getContext('2d', {willReadFrequently: true}); "
                        "one.drawImage(pane, -Math.floor(" +
                        std::to_string(across) + " * pane.width), -Math.floor(" + std::to_string(down) +
                        " * pane.height)); return [...one.getImageData(0, 0, 1, 1).data]; })()")
            .get<std::vector<int>>();
    }

private:
    std::unique_ptr<Browser> browser_;
};

const ImageResult& imageOf(const Comparison& comparison, const std::string& name) {
    return *std::find_if(comparison.images.begin(), comparison.images.end(),
                         [&](const ImageResult& image) { return image.name == name; });
}

TEST_F(ComparisonPage, OpensWithTheFirstFailureAndAllItsParts) {
    EXPECT_EQ(textOf("h1"), "Golden frames: fail");
    EXPECT_EQ(textOf("#image-title"), "beauty.0016.png fail");
    EXPECT_EQ(textOf("#image-why"), "default: max-abs 0.5 is over 0.004");
    EXPECT_EQ(textOf("#command-accept"), "umbrage accept tests/golden/courtyard out/courtyard");
    EXPECT_EQ(shownNames().size(), 128u);
    EXPECT_EQ(evaluate("document.querySelectorAll('figure:not([hidden])').length"), 3);
    EXPECT_EQ(evaluate("document.querySelectorAll('#images img').length"), 128);
    EXPECT_EQ(evaluate("document.querySelectorAll('#curves polyline[stroke-width=\"2\"]').length"), 4 + 4)
        << "a line and a swatch for each AOV";
    EXPECT_GT(evaluate("document.querySelectorAll('#histogram .bar').length"), 0);
    EXPECT_EQ(textOf("#histogram-figures").substr(0, 29), "3008 of 3072 pixels are equal");
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

TEST_F(ComparisonPage, FiltersByOutcomeAovAndText) {
    click("[data-outcome=fail]");
    EXPECT_EQ(shownNames(), (std::vector<std::string>{"beauty.0016.png", "beauty.0032.png", "shadow.Lamp.0016.exr",
                                                      "shadow.Lamp.0032.exr"}));
    EXPECT_EQ(textOf("#shown"), "4 of 128 images");
    EXPECT_EQ(evaluate("document.querySelector('[data-outcome=fail]').getAttribute('aria-pressed')"), "true");
    evaluate(
        "document.getElementById('aov').value = 'shadow.Lamp', document.getElementById('aov').dispatchEvent(new "
        "Event('change'))");
    EXPECT_EQ(shownNames().size(), 2u);
    evaluate("document.activeElement.blur()");
    press("/");
    EXPECT_EQ(evaluate("document.activeElement.id"), "text");
    browser().call("Input.insertText", {{"text", "0032 OVER"}});
    EXPECT_EQ(shownNames(), std::vector<std::string>{"shadow.Lamp.0032.exr"});
    press("Escape");
    press("j");
    EXPECT_EQ(textOf("#image-title"), "shadow.Lamp.0032.exr fail") << "keys step through what is shown";
    click("[data-outcome=fail]");
    evaluate(
        "document.getElementById('text').value = '', document.getElementById('text').dispatchEvent(new "
        "Event('input'))");
    EXPECT_EQ(shownNames().size(), 32u);
}

TEST_F(ComparisonPage, IsSortedByItsColumns) {
    const auto frames = [&] {
        return evaluate(
                   "[...document.querySelectorAll('#images tbody tr')].map(row => Number(row.cells[3].dataset.value))")
            .get<std::vector<int>>();
    };
    click("#images th:nth-child(4) button");
    std::vector<int> sorted = frames();
    EXPECT_TRUE(std::is_sorted(sorted.rbegin(), sorted.rend()));
    evaluate("document.querySelector('#images th:nth-child(4) button').focus()");
    press("Enter");
    sorted = frames();
    EXPECT_TRUE(std::is_sorted(sorted.begin(), sorted.end()));
    EXPECT_EQ(evaluate("document.querySelector('#images th:nth-child(4)').getAttribute('aria-sort')"), "ascending");
}

TEST_F(ComparisonPage, KeysChooseImagesAndViews) {
    press("j");
    EXPECT_EQ(textOf("#image-title"), "beauty.0032.png fail");
    press("ArrowDown");
    EXPECT_EQ(textOf("#image-title"), "shadow.Lamp.0016.exr fail");
    press("k");
    press("ArrowUp");
    press("k");
    EXPECT_EQ(textOf("#image-title"), "beauty.0016.png fail");
    EXPECT_EQ(evaluate("document.querySelector('tr[aria-current]').cells[0].dataset.value"), "beauty.0016.png");

    const auto showing = [&] { return evaluate("document.getElementById('viewer').dataset.showing"); };
    EXPECT_EQ(showing(), "all");
    press("s");
    EXPECT_EQ(showing(), "golden");
    const double x = 42.5 / kWidth, y = 33.5 / kHeight;  // in the square that differs
    const std::vector<int> golden = colorOf("output", x, y);
    press("s");
    EXPECT_EQ(showing(), "output");
    EXPECT_EQ(textOf("#caption-output"), "output");
    EXPECT_NE(colorOf("output", x, y), golden);
    press("s");
    EXPECT_EQ(colorOf("output", x, y), golden);

    press("b");
    EXPECT_EQ(evaluate("document.querySelector('[data-mode=blink]').getAttribute('aria-pressed')"), "true");
    const Json before = showing();
    const Json turned = browser().call(
        "Runtime.evaluate",
        {{"expression",
          "new Promise(done => setTimeout(() => done(document.getElementById('viewer').dataset.showing), 750))"},
         {"awaitPromise", true}});
    EXPECT_NE(turned["result"]["value"], before);
    press("b");
    EXPECT_EQ(showing(), "all");
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

TEST_F(ComparisonPage, ShowsWhatThereIsOfEveryOutcome) {
    show(everyOutcome(), [](const ImageResult& image) -> std::optional<PagePictures> {
        PagePictures pictures = picturesOf(image, image.outcome == Outcome::SizeMismatch ? 65 : 64, 48);
        if (image.outcome == Outcome::SizeMismatch) pictures.golden = pictureOf(image, 64, 48, false);
        if (image.outcome == Outcome::MissingOutput) pictures.output.reset();
        if (image.outcome == Outcome::MissingGolden) pictures.golden.reset();
        if (image.outcome == Outcome::Unreadable) return std::nullopt;
        return pictures;
    });
    std::map<std::string, int> panes;
    for (std::size_t o = 0; o < kOutcomes.size(); ++o) {
        const std::string title = textOf("#image-title");
        panes[title.substr(title.rfind(' ') + 1)] = evaluate(
            "document.getElementById('panes').hidden ? 0 : document.querySelectorAll('figure:not([hidden])').length");
        press("j");
    }
    EXPECT_EQ(panes.size(), kOutcomes.size());
    EXPECT_EQ(panes["fail"], 3);
    EXPECT_EQ(panes["size-mismatch"], 3);
    EXPECT_EQ(panes["missing-output"], 1);
    EXPECT_EQ(panes["missing-golden"], 1);
    EXPECT_EQ(panes["unreadable"], 0);
    EXPECT_EQ(panes["pass"], 0);
    EXPECT_EQ(evaluate("document.querySelectorAll('#statistics tbody tr').length"), 2);
    EXPECT_EQ(textOf("#origin tr:nth-child(3) td + td"), "4.5 <Mesa>");
}

TEST_F(ComparisonPage, ShowsBudgetsAboveTheImagesAndGoesToTheirFrames) {
    EXPECT_EQ(evaluate("document.getElementById('budgets-part').hidden"), true) << "there are none";
    show(overBudget(), [](const ImageResult& image) { return picturesOf(image, kWidth, kHeight); });
    EXPECT_EQ(textOf("h1"), "Golden frames: fail");
    EXPECT_EQ(textOf("#head").substr(0, 16), "1 fail, 61 pass.");
    const auto cells = [&](int row) {
        return evaluate("[...document.querySelectorAll('#budgets tbody tr')[" + std::to_string(row) +
                        "].cells].map(c => c.textContent)");
    };
    EXPECT_EQ(cells(0), Json::parse("[\"overdraw.p95\", \"at most 6\", \"7.25\", \"12\", \"\", \"\u2717 over by 1.25 "
                                    "(20.8 %)\", \"fragments/pixel\"]"));
    EXPECT_EQ(cells(1), Json::parse("[\"triangles\", \"at least 456\", \"456\", \"1\", \"\", \"\u2713 held\", "
                                    "\"count\"]"));
    EXPECT_EQ(evaluate("document.getElementById('budgets').getBoundingClientRect().bottom <= "
                       "document.getElementById('images').getBoundingClientRect().top"),
              true);
    EXPECT_NE(evaluate("getComputedStyle(document.querySelector('#budgets .exceeded .verdict')).color"),
              evaluate("getComputedStyle(document.body).color"));
    click("#budgets .exceeded button");
    EXPECT_EQ(textOf("#image-title"), "beauty.0012.png pass");

    show(everyOutcome(), [](const ImageResult&) { return std::nullopt; });
    EXPECT_EQ(cells(0)[3], "12");
    EXPECT_EQ(evaluate("document.querySelectorAll('#budgets tr:first-child button').length"), 0) << "no such frame";
    EXPECT_EQ(cells(2), Json::parse("[\"caps.dark\", \"at most 2.5\", \"\", \"\", \"\", \"\u2717 no value\", "
                                    "\"count\"]"));
    EXPECT_EQ(cells(3)[4], "Lamp, <left>");
}

TEST_F(ComparisonPage, CopiesItsCommands) {
    browser().call("Browser.grantPermissions", {{"permissions", {"clipboardReadWrite", "clipboardSanitizedWrite"}}});
    click("#copy-accept");
    EXPECT_EQ(evaluate("getSelection().toString()"), "umbrage accept tests/golden/courtyard out/courtyard");
}

TEST_F(ComparisonPage, HasADarkAndALightScheme) {
    const auto paper = [&](const char* scheme) {
        browser().call("Emulation.setEmulatedMedia",
                       {{"features", Json::array({{{"name", "prefers-color-scheme"}, {"value", scheme}}})}});
        return evaluate("getComputedStyle(document.body).backgroundColor");
    };
    EXPECT_EQ(paper("light"), "rgb(255, 255, 255)");
    EXPECT_EQ(paper("dark"), "rgb(22, 24, 27)");
}

}  // namespace
}  // namespace umbrage::cli
