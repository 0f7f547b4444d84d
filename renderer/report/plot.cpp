// SPDX-License-Identifier: Apache-2.0
// The layout.
#include "report/plot.h"

#include "report/line_style.h"
#include "report/plot_axis.h"

namespace umbrage {
namespace {

constexpr int kWidth = 960, kPlotHeight = 360;
constexpr double kLeft = 78, kRight = 24, kTop = 66, kBelowAxis = 56, kLegendLine = 22;
constexpr double kCharacter = 7.5;  // width of one, at most nearly everywhere
constexpr double kTextDrop = 5;     // from the middle of a line of text to its baseline
constexpr double kSwatch = 24;
constexpr Rgb8 kAxisColor{90, 90, 90}, kGridColor{222, 222, 222};

/// About a point; another shape where colours begin again.
PlotLine markAt(const PlotPoint& at, std::size_t series) {
    constexpr double r = 5.0;
    const std::vector<PlotPoint> shapes[] = {{{-r, 0}, {0, -r}, {r, 0}, {0, r}, {-r, 0}},
                                             {{-r, -r}, {r, -r}, {r, r}, {-r, r}, {-r, -r}},
                                             {{-r, r}, {0, -r}, {r, r}, {-r, r}}};
    PlotLine mark{shapes[series / kCategoryColors.size() % std::size(shapes)], categoryColor(series), 2.0};
    for (PlotPoint& point : mark.points) point = {at.x + point.x, at.y + point.y};
    return mark;
}

class Layout {
public:
    explicit Layout(const Plot& plot) : plot_(plot), x_(PlotAxis::across(plot)), y_(PlotAxis::up(plot)) {
        drawing_.width = kWidth;
    }

    Drawing make() && {
        drawing_.texts.push_back({{kLeft, 24}, Anchor::Start, plot_.title, true});
        drawing_.texts.push_back({{kLeft, 48}, Anchor::Start, plot_.yLabel});
        drawing_.texts.push_back({{(kLeft + kWidth - kRight) / 2, bottom() + 44}, Anchor::Middle, plot_.xLabel});
        addAxes();
        for (std::size_t s = 0; s < plot_.series.size(); ++s) addSeries(s);
        drawing_.height = int(bottom() + kBelowAxis + addLegend());
        return std::move(drawing_);
    }

private:
    static double bottom() { return kTop + kPlotHeight; }

    PlotPoint place(double x, double y) const { return at(x_.share(x), y_.share(y)); }
    static PlotPoint at(double across, double up) {
        return {kLeft + across * (kWidth - kRight - kLeft), bottom() - up * kPlotHeight};
    }

    void addAxes() {
        for (const PlotAxis::Tick& tick : y_.ticks()) {
            const double up = y_.share(tick.value);
            const PlotPoint left = at(0.0, up);
            drawing_.lines.push_back({{left, at(1.0, up)}, tick.value == 0.0 ? kAxisColor : kGridColor});
            drawing_.texts.push_back({{left.x - 8, left.y + kTextDrop}, Anchor::End, tick.label});
        }
        for (const PlotAxis::Tick& tick : x_.ticks()) {
            const PlotPoint foot = at(x_.share(tick.value), 0.0);
            drawing_.lines.push_back({{foot, {foot.x, foot.y + 5}}, kAxisColor});
            drawing_.texts.push_back({{foot.x, foot.y + 20}, Anchor::Middle, tick.label});
        }
    }

    void addSeries(std::size_t index) {
        const PlotSeries& series = plot_.series[index];
        if (series.areMarks) {
            for (const auto& [x, y] : series.points) {
                drawing_.lines.push_back(markAt(place(x, y), index));
            }
            return;
        }
        PlotLine line{{}, categoryColor(index), 2.0, lineDash(index)};
        for (const auto& [x, y] : series.points) line.points.push_back(place(x, y));
        if (line.points.size() == 1) {
            line.points.push_back({line.points[0].x + 4, line.points[0].y});
            line.points[0].x -= 4;
            line.dash = 0.0;
        }
        drawing_.lines.push_back(std::move(line));
    }

    /// @return its height
    double addLegend() {
        if (plot_.series.size() < 2) return 0.0;
        double x = kLeft, y = bottom() + kBelowAxis + kLegendLine / 2;
        for (std::size_t s = 0; s < plot_.series.size(); ++s) {
            const std::string& name = plot_.series[s].name;
            const double width = kSwatch + 8 + kCharacter * double(name.size()) + 18;
            if (x > kLeft && x + width > kWidth - kRight) {
                x = kLeft;
                y += kLegendLine;
            }
            if (plot_.series[s].areMarks) {
                drawing_.lines.push_back(markAt({x + kSwatch / 2, y}, s));
            } else {
                drawing_.lines.push_back({{{x, y}, {x + kSwatch, y}}, categoryColor(s), 2.0, lineDash(s)});
            }
            drawing_.texts.push_back({{x + kSwatch + 8, y + kTextDrop}, Anchor::Start, name});
            x += width;
        }
        return y + kLegendLine - (bottom() + kBelowAxis);
    }

    const Plot& plot_;
    PlotAxis x_, y_;
    Drawing drawing_;
};

}  // namespace

Drawing layOut(const Plot& plot) {
    return Layout(plot).make();
}

}  // namespace umbrage
