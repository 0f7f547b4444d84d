// SPDX-License-Identifier: Apache-2.0
// The page of a comparison, open in a real browser without a network.
#pragma once

#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "../unit/golden/comparisons.h"
#include "browser.h"
#include "workspace.h"

namespace umbrage::cli {

using Json = nlohmann::json;

inline constexpr int kWidth = 64, kHeight = 48;

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

}  // namespace umbrage::cli
