// SPDX-License-Identifier: Apache-2.0
// An axis of a plot: from values to places along it.
#pragma once

#include <string>
#include <vector>

#include "report/plot.h"

namespace umbrage {

class PlotAxis {
public:
    static PlotAxis across(const Plot& plot);
    /// Linear ones begin at zero, so that heights compare.
    static PlotAxis up(const Plot& plot);

    /// Where a value stands, in parts of the axis's length.
    double share(double value) const;

    struct Tick {
        double value;
        std::string label;
    };
    const std::vector<Tick>& ticks() const { return ticks_; }

private:
    using Coordinate = double std::pair<double, double>::*;
    static PlotAxis linear(double low, double high, const std::vector<double>& ticks);
    static PlotAxis logarithmic(const Plot& plot, Coordinate coordinate);

    double low_ = 0.0, high_ = 1.0;  // logarithmic: powers of ten
    bool isLogarithmic_ = false;
    std::vector<Tick> ticks_;
};

}  // namespace umbrage
