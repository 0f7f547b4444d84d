// SPDX-License-Identifier: Apache-2.0
// The statistics page in a real browser, without a network.
#include <cmath>
#include <nlohmann/json.hpp>

#include "browser.h"
#include "workspace.h"

namespace umbrage::cli {
namespace {

using Json = nlohmann::json;

class Page : public Workspace {
protected:
    void SetUp() override {
        Workspace::SetUp();
        if (Browser::program().empty()) GTEST_SKIP() << "there is no chromium here";
        writeSequence(
            "statistics: {path: out/numbers.json, page: out/numbers.html}\ndiagnostics: {profile: true}\n"
            "output: {path: \"out/{aov}.{frame:04}.{ext}\"}\n");
        const Result rendered = umbrage({"render", "seq.yaml"});
        ASSERT_EQ(rendered.exitCode, 0) << rendered.err;
        numbers_ = Json::parse(contentsOf(folder() / "out/numbers.json"));
        browser_ = std::make_unique<Browser>(folder() / "profile");
        browser_->open("file://" + (folder() / "out/numbers.html").string());
    }

    void TearDown() override {
        if (browser_) expectQuietAndOffline(*browser_);
        browser_.reset();
        Workspace::TearDown();
    }

    Browser& browser() { return *browser_; }
    const Json& numbers() const { return numbers_; }

    Json textOf(const std::string& selector) {
        return browser().evaluate("document.querySelector('" + selector + "').textContent");
    }

    /// The middle of an element, or another part of its width, after it has been scrolled into view.
    std::pair<double, double> placeOf(const std::string& selector, double part = 0.5) {
        const Json box = browser().evaluate("(() => { const e = document.querySelector('" + selector +
                                            "'); e.scrollIntoView({block: 'center', inline: 'center'}); const b = "
                                            "e.getBoundingClientRect(); return [b.x, b.y, b.width, b.height]; })()");
        return {box[0].get<double>() + part * box[2].get<double>(), box[1].get<double>() + 0.5 * box[3].get<double>()};
    }

    /// The exact numbers of a table's column, from above.
    std::vector<double> columnOf(const std::string& table, int column) {
        const Json values =
            browser().evaluate("[...document.querySelectorAll('" + table + " tbody tr')].map(row => Number(row.cells[" +
                               std::to_string(column) + "].dataset.value))");
        return values.get<std::vector<double>>();
    }

    /// Where a column with this title is.
    int indexOf(const std::string& table, const std::string& title) {
        return browser().evaluate("[...document.querySelectorAll('" + table +
                                  " thead th')].findIndex(th => th.textContent === '" + title + "')");
    }

private:
    Json numbers_;
    std::unique_ptr<Browser> browser_;
};

TEST_F(Page, ShowsTheFirstFrameAndAllItsParts) {
    EXPECT_EQ(textOf("h1"), "Statistics of seq.yaml");
    EXPECT_EQ(textOf("#frame-title"), "Frame 1");
    for (const char* part :
         {"#chart-time polygon", "#chart-overdraw-fragments polyline", "#chart-overdraw-updates polyline",
          "#chart-edges-silhouette polyline", "#lights table", "#frames table", "#terms dt"}) {
        EXPECT_GT(browser().evaluate("document.querySelectorAll('" + std::string(part) + "').length"), 0) << part;
    }
    EXPECT_EQ(browser().evaluate("document.querySelectorAll('#chart-overdraw-fragments polyline').length"), 2)
        << "a line for each light";
}

TEST_F(Page, TablesHaveTheNumbersOfTheJson) {
    const Json& frames = numbers()["frames"];
    for (const char* counter : {"triangles", "time.frame"}) {
        const std::vector<double> shown = columnOf("#frames", indexOf("#frames", counter));
        ASSERT_EQ(shown.size(), frames.size());
        for (std::size_t f = 0; f < frames.size(); ++f) EXPECT_EQ(shown[f], frames[f]["values"][counter]) << counter;
    }
    const Json names =
        browser().evaluate("[...document.querySelectorAll('#lights tbody tr')].map(row => row.cells[0].dataset.value)");
    const std::vector<double> edges = columnOf("#lights", indexOf("#lights", "edges.silhouette"));
    ASSERT_EQ(names.size(), 2u);
    for (std::size_t l = 0; l < names.size(); ++l) {
        double sum = 0.0;
        for (const Json& frame : frames) {
            sum += frame["lights"][names[l].get<std::string>()]["values"]["edges.silhouette"].get<double>();
        }
        EXPECT_EQ(edges[l], sum);
    }
}

TEST_F(Page, PointingAtAFrameShowsItsThumbnailAndValues) {
    const auto [x, y] = placeOf("#chart-edges-silhouette", 0.99);
    browser().movePointer(x, y);
    EXPECT_EQ(textOf("#frame-title"), "Frame 3");
    EXPECT_EQ(browser().evaluate("document.getElementById('thumbnail').hidden"), false);
    EXPECT_EQ(browser().evaluate("document.getElementById('thumbnail').decode().then(() => 0), "
                                 "document.getElementById('thumbnail').src.slice(0, 22)"),
              "data:image/png;base64,");
    EXPECT_EQ(browser().evaluate("document.getElementById('thumbnail').naturalWidth"), 64);
    EXPECT_EQ(browser().evaluate("document.getElementById('thumbnail').naturalHeight"), 48);
    EXPECT_EQ(browser().evaluate("Number(document.querySelector('[data-counter=triangles]').dataset.value)"),
              numbers()["frames"][2]["values"]["triangles"]);
    const auto [middleX, middleY] = placeOf("#chart-time", 0.53);
    browser().movePointer(middleX, middleY);
    EXPECT_EQ(textOf("#frame-title"), "Frame 2");
}

TEST_F(Page, KeysChooseFrames) {
    browser().evaluate("document.getElementById('chart-time').focus()");
    browser().press("End");
    EXPECT_EQ(textOf("#frame-title"), "Frame 3");
    browser().press("ArrowLeft");
    EXPECT_EQ(textOf("#frame-title"), "Frame 2");
    browser().press("Home");
    browser().press("ArrowLeft");
    EXPECT_EQ(textOf("#frame-title"), "Frame 1");
    browser().press("Tab");
    EXPECT_EQ(browser().evaluate("document.activeElement.id"), "chart-overdraw-fragments");
}

TEST_F(Page, TablesAreSortedByClickAndByKey) {
    const int column = indexOf("#frames", "time.frame");
    const std::string head = "#frames th:nth-child(" + std::to_string(column + 1) + ")";
    const auto [x, y] = placeOf(head + " button");
    browser().click(x, y);
    std::vector<double> times = columnOf("#frames", column);
    EXPECT_TRUE(std::is_sorted(times.rbegin(), times.rend()));
    EXPECT_EQ(browser().evaluate("document.querySelector('" + head + "').getAttribute('aria-sort')"), "descending");
    browser().evaluate("document.querySelector('" + head + " button').focus()");
    browser().press("Enter");
    times = columnOf("#frames", column);
    EXPECT_TRUE(std::is_sorted(times.begin(), times.end()));
    EXPECT_EQ(browser().evaluate("document.querySelector('" + head + "').getAttribute('aria-sort')"), "ascending");

    const auto [lightX, lightY] = placeOf("#lights th button");
    browser().click(lightX, lightY);
    EXPECT_EQ(browser().evaluate("document.querySelector('#lights tbody td').textContent"), "Box_BoxLight");
    browser().click(lightX, lightY);
    EXPECT_EQ(browser().evaluate("document.querySelector('#lights tbody td').textContent"), "Cage_CageLight");
}

TEST_F(Page, ShowsBudgetsAndGoesToTheirFrames) {
    EXPECT_EQ(browser().evaluate("document.getElementById('budgets-part').hidden"), true) << "there are none";
    ASSERT_EQ(umbrage({"stats", "out/numbers.json", "--html", "over.html", "--budget", "edges.silhouette=10",
                       "--budget", "triangles={min: 456}", "--budget", "caps.near.hard={min: 1, max: 2}"})
                  .exitCode,
              1);
    browser().open("file://" + (folder() / "over.html").string());
    const auto cells = [&](int row) {
        return browser().evaluate("[...document.querySelectorAll('#budgets tbody tr')[" + std::to_string(row) +
                                  "].cells].map(c => c.textContent)");
    };
    const Json over = cells(0);
    double most = 0.0;
    int worst = 0;
    for (const Json& frame : numbers()["frames"]) {
        double edges = 0.0;
        for (const Json& light : frame["lights"]) edges += light["values"]["edges.silhouette"].get<double>();
        if (edges > most) most = edges, worst = frame["frame"];
    }
    EXPECT_EQ(over[0], "edges.silhouette");
    EXPECT_EQ(over[1], "at most 10");
    EXPECT_EQ(over[2], std::to_string(int(most)));
    EXPECT_EQ(over[3], std::to_string(worst));
    EXPECT_THAT(over[5].get<std::string>(), testing::StartsWith("\u2717 over by " + std::to_string(int(most) - 10)));
    EXPECT_EQ(cells(1), Json::parse("[\"triangles\", \"at least 456\", \"456\", \"1\", \"\", \"\u2713 held\", "
                                    "\"count\"]"));
    browser().evaluate("document.querySelector('#budgets button').focus()");
    browser().press("End");
    browser().press("Enter");
    EXPECT_EQ(textOf("#frame-title"), "Frame " + std::to_string(worst));
    EXPECT_NE(browser().evaluate("getComputedStyle(document.querySelector('#budgets .exceeded .verdict')).color"),
              browser().evaluate("getComputedStyle(document.body).color"));
}

TEST_F(Page, HasADarkAndALightScheme) {
    const auto paper = [&](const char* scheme) {
        browser().call("Emulation.setEmulatedMedia",
                       {{"features", Json::array({{{"name", "prefers-color-scheme"}, {"value", scheme}}})}});
        return browser().evaluate("getComputedStyle(document.body).backgroundColor");
    };
    EXPECT_EQ(paper("light"), "rgb(255, 255, 255)");
    EXPECT_EQ(paper("dark"), "rgb(22, 24, 27)");
}

TEST_F(Page, OfTheStatsCommandHasTheSameNumbersAndTakesPicturesBesideIt) {
    ASSERT_EQ(umbrage({"stats", "out/numbers.json", "--html", "out/again.html"}).exitCode, 0);
    const std::vector<double> before = columnOf("#frames", indexOf("#frames", "triangles"));
    browser().open("file://" + (folder() / "out/again.html").string());
    EXPECT_EQ(columnOf("#frames", indexOf("#frames", "triangles")), before);
    EXPECT_EQ(browser().evaluate("document.getElementById('thumbnail').hidden"), false);

    ASSERT_EQ(umbrage({"stats", "out/numbers.json", "--html", "alone.html", "--frames", "2"}).exitCode, 0);
    std::filesystem::rename(folder() / "out/beauty.0002.png", folder() / "out/elsewhere.png");
    ASSERT_EQ(umbrage({"stats", "out/numbers.json", "--html", "alone.html", "--frames", "2"}).exitCode, 0);
    browser().open("file://" + (folder() / "alone.html").string());
    EXPECT_EQ(textOf("#frame-title"), "Frame 2");
    EXPECT_EQ(browser().evaluate("document.getElementById('thumbnail').hidden"), true);
}

TEST_F(Page, ShowsAHistogramOfTheFrame) {
    const Json& frame = numbers()["frames"][0];
    if (!frame.contains("distributions") || frame["distributions"].empty()) {
        GTEST_SKIP() << "this sequence records no distribution";
    }
    EXPECT_EQ(browser().evaluate("document.getElementById('histogram-part').hidden"), false);
    const std::string chosen = browser().evaluate("document.getElementById('quantity').value");
    EXPECT_EQ(browser().evaluate("document.querySelectorAll('#histogram .bar').length"),
              frame["distributions"][chosen]["histogram"].size());
}

}  // namespace
}  // namespace umbrage::cli
