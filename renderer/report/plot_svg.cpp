// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "report/markup.h"
#include "report/plot.h"

namespace umbrage {
namespace {

const char* anchorName(Anchor anchor) {
    return anchor == Anchor::Start ? "start" : anchor == Anchor::Middle ? "middle" : "end";
}

}  // namespace

std::string svgOf(const Drawing& drawing) {
    std::string svg = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" "
        "font-family=\"sans-serif\" font-size=\"13\" fill=\"none\">\n<rect width=\"{0}\" height=\"{1}\" "
        "fill=\"#fff\"/>\n",
        drawing.width, drawing.height);
    for (const PlotLine& line : drawing.lines) {
        svg += "<polyline points=\"";
        for (std::size_t i = 0; i < line.points.size(); ++i) {
            svg += fmt::format("{}{:.2f},{:.2f}", i > 0 ? " " : "", line.points[i].x, line.points[i].y);
        }
        svg += fmt::format("\" stroke=\"{}\" stroke-width=\"{:g}\"", cssColor(line.color), line.width);
        if (line.dash > 0.0) svg += fmt::format(" stroke-dasharray=\"{:g}\"", line.dash);
        svg += "/>\n";
    }
    for (const PlotText& text : drawing.texts) {
        svg += fmt::format("<text x=\"{:.2f}\" y=\"{:.2f}\" text-anchor=\"{}\" fill=\"#222\"{}>{}</text>\n", text.at.x,
                           text.at.y, anchorName(text.anchor), text.isStrong ? " font-weight=\"bold\"" : "",
                           escapedMarkup(text.text));
    }
    return svg + "</svg>\n";
}

}  // namespace umbrage
