// SPDX-License-Identifier: Apache-2.0
// Plots of curves: what is plotted, laid out once as lines and words, then written as SVG or drawn as pixels.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "image/canvas.h"

namespace umbrage {

struct PlotSeries {
    std::string name;
    std::vector<std::pair<double, double>> points;  // ascending in x, unless they are marks
    bool areMarks = false;                          // each by itself, not joined by a curve
};

enum class PlotScale { Linear, Logarithmic };

struct Plot {
    std::string title, xLabel, yLabel;  // labels with units
    std::vector<PlotSeries> series;
    /// Of both axes. On a logarithmic one what is not above zero stands at the foot, marked 0, below all else.
    PlotScale scale = PlotScale::Linear;
};

/// Positions in pixels from the upper left corner.
struct PlotPoint {
    double x = 0.0, y = 0.0;
};

struct PlotLine {
    std::vector<PlotPoint> points;
    Rgb8 color{};
    double width = 1.0;
    double dash = 0.0;  // length drawn and left out; 0: all drawn
};

enum class Anchor { Start, Middle, End };

/// Its baseline begins, has its middle or ends at `at`.
struct PlotText {
    PlotPoint at;
    Anchor anchor = Anchor::Start;
    std::string text;
    bool isStrong = false;
};

/// Black on white, behind later ones.
struct Drawing {
    int width = 0, height = 0;
    std::vector<PlotLine> lines;
    std::vector<PlotText> texts;
};

/// Axes with ticks, the series, and a legend below where there are several. A series of one point is a short dash.
Drawing layOut(const Plot& plot);

std::string svgOf(const Drawing& drawing);

/// Two pixels for one of the drawing's, lines smoothed.
RgbPicture pictureOf(const Drawing& drawing);

/// Ticks at 1, 2 or 5 times a power of ten that cover [low, high], about `count` of them; at least two.
std::vector<double> ticksOf(double low, double high, int count);

}  // namespace umbrage
