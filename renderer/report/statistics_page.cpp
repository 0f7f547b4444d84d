// SPDX-License-Identifier: Apache-2.0
#include "report/statistics_page.h"

#include <nlohmann/json.hpp>

#include "diagnostics/statistics_format.h"
#include "diagnostics/statistics_summary.h"
#include "report/line_style.h"
#include "report/markup.h"
#include "report/page/page_text.h"

namespace umbrage {
namespace {

using Json = nlohmann::ordered_json;

/// With what parts add up to, and without parts of parts, of which the page shows nothing.
StatisticsFile shownOf(const StatisticsFile& file) {
    StatisticsFile shown = file;
    for (auto& [frame, figures] : shown.frames) {
        figures = withWholes(file, figures);
        std::erase_if(figures, [](const auto& entry) { return dimensionsOf(entry.first) > 1; });
    }
    return shown;
}

std::string dataOf(const StatisticsFile& file, const std::map<int, std::string>& thumbnails) {
    Json data = {{"file", Json::parse(shownOf(file).json())}, {"thumbnails", Json::object()}};
    for (const auto& [frame, png] : thumbnails) {
        data["thumbnails"][std::to_string(frame)] = "data:image/png;base64," + base64(png);
    }
    data["colors"] = Json::array();
    for (const Rgb8& color : kCategoryColors) data["colors"].push_back(cssColor(color));
    data["dashes"] = kLineDashes;
    return data.dump();
}

}  // namespace

std::string statisticsPage(const StatisticsFile& file, const std::map<int, std::string>& thumbnails) {
    std::string title = "Statistics";
    for (const auto& [key, value] : file.header) {
        if (key == "sequence") title = "Statistics of " + value;
    }
    return wholePage({title, kPageStyle, kPageHtml, kPageScript, dataOf(file, thumbnails)});
}

}  // namespace umbrage
