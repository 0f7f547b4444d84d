// SPDX-License-Identifier: Apache-2.0
// The page of a comparison around its viewer: the list of images, what filters and sorts it, budgets, colours.
#include "comparison_page.h"

#include <algorithm>
#include <map>

namespace umbrage::cli {
namespace {

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
