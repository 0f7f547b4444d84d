// SPDX-License-Identifier: Apache-2.0
#include "golden/comparison_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "golden/packed_picture.h"
#include "golden/page/page_text.h"
#include "golden/page_view.h"
#include "golden/reports.h"
#include "golden/result_text.h"
#include "image/thumbnail.h"
#include "report/markup.h"
#include "report/page/page_text.h"
#include "report/plot.h"

namespace umbrage {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kThumbnailsWide = 96;  // pixels: 192 of them are 2 to 3 MB

std::string thumbnailUrl(const PagePicture& picture, const PageView& view) {
    const std::vector<float> rgba = displayRgba(picture, view);
    return "data:image/png;base64," + base64(thumbnailOf(picture.width, picture.height, rgba, kThumbnailsWide).png());
}

Json jsonOf(const PageView& view) {
    return {{"shown", view.shown},
            {"alpha", view.alpha},
            {"low", view.low},
            {"high", view.high},
            {"encoded", view.isEncoded}};
}

/// What the page knows of each image beside the comparison, and the elements that hold the values.
struct Pictures {
    Json heads = Json::array();
    std::string elements;
    std::size_t leftOut = 0;
};

Pictures gathered(const Comparison& comparison,
                  const std::function<std::optional<PagePictures>(const ImageResult&)>& pictures,
                  std::size_t mostBytes) {
    Pictures all;
    all.heads = std::vector<Json>(comparison.images.size(), Json::object());
    std::vector<std::size_t> order;  // failures first
    for (const bool passing : {false, true}) {
        for (std::size_t i = 0; i < comparison.images.size(); ++i) {
            if (infoOf(comparison.images[i].outcome).passes == passing) order.push_back(i);
        }
    }
    for (const std::size_t i : order) {
        const ImageResult& image = comparison.images[i];
        const auto found = pictures(image);
        if (!found || (!found->golden && !found->output)) continue;
        const PageView view = viewOf(found->golden ? *found->golden : *found->output);
        Json& head = all.heads[i];
        const PagePicture& shown = found->output ? *found->output : *found->golden;
        head["thumbnail"] = thumbnailUrl(shown, viewOf(shown));
        if (image.outcome == Outcome::Pass || image.outcome == Outcome::Skipped) continue;
        if (all.elements.size() >= mostBytes) {
            ++all.leftOut;
            continue;
        }
        head["view"] = jsonOf(view);
        const PackedPictures values = packed(*found);
        for (const auto& [name, picture] : {std::pair{"golden", &values.golden}, std::pair{"output", &values.output}}) {
            if (!*picture) continue;
            head[name] = (*picture)->head;
            all.elements +=
                fmt::format("<script type=\"text/plain\" id=\"{}-{}\">{}</script>\n", name, i, (*picture)->text);
        }
    }
    return all;
}

/// Each metric's curves over the frames, a line an AOV, as SVG; metrics of single frames have none.
Json curvesOf(const Comparison& comparison) {
    Json curves = Json::array();
    for (const std::string& metric : metricsIn(comparison)) {
        std::map<std::string, std::map<int, double>> worst;  // of the images of an AOV's frame
        for (const ImageResult& image : comparison.images) {
            for (const Figure& figure : image.figures) {
                if (image.frame <= 0 || figure.metric != metric || !std::isfinite(figure.value)) continue;
                const auto [place, isNew] = worst[image.aov].try_emplace(image.frame, figure.value);
                if (!isNew && (figure.value < place->second) == isWorseBelow(metric)) place->second = figure.value;
            }
        }
        Plot plot{metric + " of each frame", "frame", metric, {}};
        for (const auto& [aov, values] : worst)
            plot.series.push_back({aov.empty() ? "images" : aov, {values.begin(), values.end()}});
        const bool isSequence =
            std::any_of(worst.begin(), worst.end(), [](const auto& aov) { return aov.second.size() > 1; });
        if (isSequence) curves.push_back({{"metric", metric}, {"svg", svgOf(layOut(plot))}});
    }
    return curves;
}

Json paletteOf() {
    const FalseColor colors(255.0f);
    Json palette = Json::array();
    for (int i = 0; i < 256; ++i) palette.push_back(colors.at(float(i), 1, 0));
    return palette;
}

}  // namespace

std::string comparisonPage(const Comparison& comparison,
                           const std::function<std::optional<PagePictures>(const ImageResult&)>& pictures,
                           std::size_t mostBytes) {
    Pictures all = gathered(comparison, pictures, mostBytes);
    Json data = {{"comparison", Json::parse(comparisonJson(comparison))},
                 {"verdict", countsText(comparison)},
                 {"pictures", std::move(all.heads)},
                 {"leftOut", all.leftOut},
                 {"curves", curvesOf(comparison)},
                 {"palette", paletteOf()},
                 {"outcomes", Json::array()}};
    for (const OutcomeInfo& info : kOutcomes) {
        data["outcomes"].push_back({{"name", info.name}, {"meaning", info.meaning}, {"passes", info.passes}});
    }
    data["explanations"] = Json::array();
    for (const ImageResult& image : comparison.images) data["explanations"].push_back(explanation(image));
    const std::string title = fmt::format("Golden frames: {}", comparison.passes() ? "pass" : "fail");
    return wholePage({title, kComparisonStyle, kComparisonHtml, kComparisonScript,
                      data.dump(-1, ' ', false, Json::error_handler_t::replace), all.elements});
}

}  // namespace umbrage
