// SPDX-License-Identifier: Apache-2.0
// The layout.
#include "report/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/line_style.h"

namespace umbrage {
namespace {

constexpr int kWidth = 960, kPlotHeight = 360;
constexpr double kLeft = 78, kRight = 24, kTop = 66, kBelowAxis = 56, kLegendLine = 22;
constexpr double kCharacter = 7.5;  // width of one, at most nearly everywhere
constexpr double kTextDrop = 5;     // from the middle of a line of text to its baseline
constexpr double kSwatch = 24;
constexpr Rgb8 kAxisColor{90, 90, 90}, kGridColor{222, 222, 222};

/// 1.5M rather than 1500000.
std::string shortNumber(double value) {
    constexpr std::pair<double, const char*> kUnits[] = {{1e12, "T"}, {1e9, "G"}, {1e6, "M"}, {1e3, "k"}};
    for (const auto& [size, letter] : kUnits) {
        if (std::abs(value) >= size) return fmt::format("{:.6g}{}", value / size, letter);
    }
    return fmt::format("{:.6g}", value);
}

struct Range {
    double low = 0.0, high = 1.0;
};

/// @param withZero  starts at zero, so that heights compare
Range rangeOf(const Plot& plot, double std::pair<double, double>::*axis, bool withZero) {
    Range range{INFINITY, -INFINITY};
    for (const PlotSeries& series : plot.series) {
        for (const auto& point : series.points) {
            range.low = std::min(range.low, point.*axis);
            range.high = std::max(range.high, point.*axis);
        }
    }
    if (range.low > range.high) return {};
    if (withZero) range = {std::min(range.low, 0.0), std::max(range.high, 0.0)};
    if (range.low == range.high) range = withZero ? Range{0.0, 1.0} : Range{range.low - 1.0, range.high + 1.0};
    return range;
}

class Layout {
public:
    explicit Layout(const Plot& plot) : plot_(plot), x_(rangeOf(plot, &std::pair<double, double>::first, false)) {
        const Range values = rangeOf(plot, &std::pair<double, double>::second, true);
        yTicks_ = ticksOf(values.low, values.high, 6);
        y_ = {yTicks_.front(), yTicks_.back()};
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

    PlotPoint place(double x, double y) const {
        return {kLeft + (x - x_.low) / (x_.high - x_.low) * (kWidth - kRight - kLeft),
                bottom() - (y - y_.low) / (y_.high - y_.low) * kPlotHeight};
    }

    void addAxes() {
        for (const double tick : yTicks_) {
            const PlotPoint left = place(x_.low, tick), right = place(x_.high, tick);
            drawing_.lines.push_back({{left, right}, tick == 0.0 ? kAxisColor : kGridColor});
            drawing_.texts.push_back({{left.x - 8, left.y + kTextDrop}, Anchor::End, shortNumber(tick)});
        }
        for (const double tick : ticksOf(x_.low, x_.high, 12)) {
            if (tick < x_.low || tick > x_.high || tick != std::floor(tick)) continue;
            const PlotPoint foot = place(tick, y_.low);
            drawing_.lines.push_back({{foot, {foot.x, foot.y + 5}}, kAxisColor});
            drawing_.texts.push_back({{foot.x, foot.y + 20}, Anchor::Middle, shortNumber(tick)});
        }
    }

    void addSeries(std::size_t index) {
        PlotLine line{{}, categoryColor(index), 2.0, lineDash(index)};
        for (const auto& [x, y] : plot_.series[index].points) line.points.push_back(place(x, y));
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
            drawing_.lines.push_back({{{x, y}, {x + kSwatch, y}}, categoryColor(s), 2.0, lineDash(s)});
            drawing_.texts.push_back({{x + kSwatch + 8, y + kTextDrop}, Anchor::Start, name});
            x += width;
        }
        return y + kLegendLine - (bottom() + kBelowAxis);
    }

    const Plot& plot_;
    Range x_, y_;
    std::vector<double> yTicks_;
    Drawing drawing_;
};

}  // namespace

std::vector<double> ticksOf(double low, double high, int count) {
    const double wanted = (high - low) / count;
    const double power = std::pow(10.0, std::floor(std::log10(wanted)));
    double step = 10.0 * power;
    for (const double factor : {5.0, 2.0, 1.0}) {
        if (factor * power >= wanted) step = factor * power;
    }
    std::vector<double> ticks;
    for (double i = std::floor(low / step);; ++i) {
        ticks.push_back(i * step);
        if (ticks.back() >= high && ticks.size() > 1) return ticks;
    }
}

Drawing layOut(const Plot& plot) {
    return Layout(plot).make();
}

}  // namespace umbrage
