// SPDX-License-Identifier: Apache-2.0
#include "report/plot_axis.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace umbrage {
namespace {

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

PlotAxis PlotAxis::linear(double low, double high, const std::vector<double>& ticks) {
    PlotAxis axis;
    axis.low_ = low;
    axis.high_ = high;
    for (const double tick : ticks) axis.ticks_.push_back({tick, shortNumber(tick)});
    return axis;
}

/// Of whole decades, with room for zero where it is needed.
PlotAxis PlotAxis::logarithmic(const Plot& plot, Coordinate coordinate) {
    double least = INFINITY, most = -INFINITY;
    bool zero = false;
    for (const PlotSeries& series : plot.series) {
        for (const auto& point : series.points) {
            const double value = point.*coordinate;
            zero = zero || !(value > 0.0);
            if (!(value > 0.0)) continue;
            least = std::min(least, value);
            most = std::max(most, value);
        }
    }
    if (least > most) least = most = 1.0;
    PlotAxis made;
    made.isLogarithmic_ = true;
    made.low_ = std::floor(std::log10(least));
    made.high_ = std::ceil(std::log10(most));
    if (made.low_ == made.high_) made.high_ += 1.0;
    const bool few = made.high_ - made.low_ <= 2.0;
    for (double decade = made.low_; decade <= made.high_; ++decade) {
        for (const double factor : {1.0, 2.0, 5.0}) {
            if (factor > 1.0 && (!few || decade == made.high_)) continue;
            const double tick = factor * std::pow(10.0, decade);
            made.ticks_.push_back({tick, shortNumber(tick)});
        }
    }
    if (zero) {
        made.low_ -= 1.0;
        made.ticks_.insert(made.ticks_.begin(), {0.0, "0"});
    }
    return made;
}

PlotAxis PlotAxis::across(const Plot& plot) {
    if (plot.scale == PlotScale::Logarithmic) return logarithmic(plot, &std::pair<double, double>::first);
    const Range range = rangeOf(plot, &std::pair<double, double>::first, false);
    std::vector<double> ticks = ticksOf(range.low, range.high, 12);
    std::erase_if(ticks,
                  [&](double tick) { return tick < range.low || tick > range.high || tick != std::floor(tick); });
    return linear(range.low, range.high, ticks);
}

PlotAxis PlotAxis::up(const Plot& plot) {
    if (plot.scale == PlotScale::Logarithmic) return logarithmic(plot, &std::pair<double, double>::second);
    const Range range = rangeOf(plot, &std::pair<double, double>::second, true);
    const std::vector<double> ticks = ticksOf(range.low, range.high, 6);
    return linear(ticks.front(), ticks.back(), ticks);
}

double PlotAxis::share(double value) const {
    if (isLogarithmic_) value = value > 0.0 ? std::log10(value) : low_;
    return (value - low_) / (high_ - low_);
}

}  // namespace umbrage
