// SPDX-License-Identifier: Apache-2.0
#include "report/statistics_page.h"

#include <cstdint>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string_view>

#include "diagnostics/statistics_format.h"
#include "diagnostics/statistics_summary.h"
#include "report/line_style.h"
#include "report/markup.h"
#include "report/page/page_text.h"

namespace umbrage {
namespace {

using Json = nlohmann::ordered_json;

std::string base64(std::string_view bytes) {
    constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t three = 0;
        for (std::size_t j = i; j < i + 3; ++j) three = three << 8 | (j < bytes.size() ? std::uint8_t(bytes[j]) : 0u);
        for (std::size_t j = 0; j < 4; ++j) text += i + j <= bytes.size() ? kDigits[three >> (18 - 6 * j) & 63u] : '=';
    }
    return text;
}

/// With what parts add up to, and without parts of parts, of which the page shows nothing.
StatisticsFile shownOf(const StatisticsFile& file) {
    StatisticsFile shown = file;
    for (auto& [frame, figures] : shown.frames) {
        figures = withWholes(file, figures);
        std::erase_if(figures, [](const auto& entry) { return dimensionsOf(entry.first) > 1; });
    }
    return shown;
}

/// JSON that may stand in a script element: nothing in it begins a tag.
std::string dataOf(const StatisticsFile& file, const std::map<int, std::string>& thumbnails) {
    Json data = {{"file", Json::parse(shownOf(file).json())}, {"thumbnails", Json::object()}};
    for (const auto& [frame, png] : thumbnails) {
        data["thumbnails"][std::to_string(frame)] = "data:image/png;base64," + base64(png);
    }
    data["colors"] = Json::array();
    for (const Rgb8& color : kCategoryColors) data["colors"].push_back(cssColor(color));
    data["dashes"] = kLineDashes;
    std::string text;
    for (const char c : data.dump()) text += c == '<' ? std::string("\\u003c") : std::string(1, c);
    return text;
}

}  // namespace

std::string statisticsPage(const StatisticsFile& file, const std::map<int, std::string>& thumbnails) {
    std::string title = "Statistics";
    for (const auto& [key, value] : file.header) {
        if (key == "sequence") title = "Statistics of " + value;
    }
    const std::map<std::string_view, std::string> parts{{"TITLE", escapedMarkup(title)},
                                                        {"STYLE", std::string(kPageStyle)},
                                                        {"SCRIPT", std::string(kPageScript)},
                                                        {"DATA", dataOf(file, thumbnails)}};
    std::string page;
    std::string_view rest = kPageHtml;  // text, %NAME%, text, %NAME% ... text
    for (bool isName = false; !rest.empty(); isName = !isName) {
        const std::size_t end = rest.find('%');
        const std::string_view piece = rest.substr(0, end);
        page += isName ? parts.at(piece) : std::string(piece);
        rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
    }
    return page;
}

}  // namespace umbrage
