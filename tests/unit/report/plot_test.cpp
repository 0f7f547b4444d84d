// SPDX-License-Identifier: Apache-2.0
#include "report/plot.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "../diagnostics/runs.h"
#include "error.h"
#include "report/line_style.h"
#include "report/statistics_plot.h"

namespace umbrage {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

Plot twoCurves() {
    return {"title", "frame", "things (count)", {{"Lamp", {{1, 0}, {2, 10}, {3, 5}}}, {"S<n", {{1, 4}, {3, 4}}}}};
}

std::size_t countOf(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
    return count;
}

const PlotLine* lineOf(const Drawing& drawing, const Rgb8& color, std::size_t points) {
    for (const PlotLine& line : drawing.lines) {
        if (line.color == color && line.points.size() == points) return &line;
    }
    return nullptr;
}

TEST(Ticks, CoverTheRangeInRoundSteps) {
    EXPECT_THAT(ticksOf(0, 10, 5), ElementsAre(0, 2, 4, 6, 8, 10));
    EXPECT_THAT(ticksOf(0, 1, 1), ElementsAre(0, 1));
    EXPECT_THAT(ticksOf(-3, 4, 4), ElementsAre(-4, -2, 0, 2, 4));
    EXPECT_THAT(ticksOf(0, 0.7, 4), ElementsAre(0, testing::DoubleEq(0.2), testing::DoubleEq(0.4),
                                                testing::DoubleEq(0.6), testing::DoubleEq(0.8)));
}

TEST(PlotLayout, PutsValuesWhereTheAxesSay) {
    const Drawing drawing = layOut(twoCurves());
    const PlotLine* curve = lineOf(drawing, categoryColor(0), 3);
    ASSERT_NE(curve, nullptr);
    const double zero = curve->points[0].y, ten = curve->points[1].y;
    EXPECT_DOUBLE_EQ(curve->points[2].y, (zero + ten) / 2);
    EXPECT_DOUBLE_EQ(curve->points[1].x, (curve->points[0].x + curve->points[2].x) / 2);
    const auto label = std::find_if(drawing.texts.begin(), drawing.texts.end(),
                                    [](const PlotText& text) { return text.text == "10"; });
    ASSERT_NE(label, drawing.texts.end());
    EXPECT_NEAR(label->at.y, ten, 6.0);
}

TEST(PlotLayout, EverythingIsInside) {
    Plot plot = twoCurves();
    for (int i = 0; i < 30; ++i) plot.series.push_back({"light number " + std::to_string(i), {{1, -1e9}, {3, i}}});
    const Drawing drawing = layOut(plot);
    for (const PlotLine& line : drawing.lines) {
        for (const PlotPoint& point : line.points) {
            EXPECT_TRUE(point.x >= 0 && point.x <= drawing.width && point.y >= 0 && point.y <= drawing.height);
        }
    }
    for (const PlotText& text : drawing.texts) {
        EXPECT_TRUE(text.at.x >= 0 && text.at.x <= drawing.width && text.at.y >= 10 && text.at.y <= drawing.height)
            << text.text;
    }
}

TEST(PlotLayout, ColoursComeAgainWithDashes) {
    EXPECT_EQ(lineDash(0), 0.0);
    EXPECT_EQ(categoryColor(kCategoryColors.size()), categoryColor(0));
    EXPECT_NE(lineDash(kCategoryColors.size()), 0.0);
    EXPECT_NE(lineDash(2 * kCategoryColors.size()), lineDash(kCategoryColors.size()));
}

TEST(PlotLayout, OneCurveHasNoLegendAndOnePointIsSeen) {
    const Drawing one = layOut({"t", "frame", "y", {{"whole", {{7, 3}}}}});
    EXPECT_EQ(std::count_if(one.texts.begin(), one.texts.end(), [](const auto& t) { return t.text == "whole"; }), 0);
    const PlotLine* dash = lineOf(one, categoryColor(0), 2);
    ASSERT_NE(dash, nullptr);
    EXPECT_GT(dash->points[1].x, dash->points[0].x);
}

TEST(PlotLayout, LogarithmicAxesHaveDecadesAndRoomForZero) {
    const Plot plot{
        "t", "ms", "wrong", {{"a", {{1, 10}}, true}, {"b", {{10, 100}, {100, 0}}, true}}, PlotScale::Logarithmic};
    const Drawing drawing = layOut(plot);
    std::vector<PlotPoint> marks;  // their middles
    for (const PlotLine& line : drawing.lines) {
        if (line.points.size() != 5 || line.points[0].y > drawing.height - 60) continue;  // one of the legend's
        marks.push_back({(line.points[0].x + line.points[2].x) / 2, line.points[0].y});
    }
    ASSERT_EQ(marks.size(), 3u);
    EXPECT_NEAR(marks[1].x - marks[0].x, marks[2].x - marks[1].x, 1e-9);
    EXPECT_NEAR(marks[0].y - marks[1].y, marks[2].y - marks[0].y, 1e-9);  // zero is a decade below the least
    const auto zero = std::ranges::find(drawing.texts, std::string("0"), &PlotText::text);
    ASSERT_NE(zero, drawing.texts.end());
    EXPECT_NEAR(zero->at.y, marks[2].y, 6.0);
}

TEST(PlotLayout, MarksHaveOtherShapesWhenColoursComeAgain) {
    Plot plot{"t", "x", "y", {}};
    for (int i = 0; i <= int(kCategoryColors.size()); ++i) plot.series.push_back({"s", {{i, i}}, true});
    const Drawing drawing = layOut(plot);
    std::vector<const PlotLine*> first;
    for (const PlotLine& line : drawing.lines) {
        if (line.color == categoryColor(0) && line.points.size() == 5) first.push_back(&line);
    }
    ASSERT_GE(first.size(), 2u);
    EXPECT_EQ(first[0]->points[1].x, (first[0]->points[0].x + first[0]->points[2].x) / 2);  // a lozenge
    EXPECT_NE(first[1]->points[1].x, (first[1]->points[0].x + first[1]->points[2].x) / 2);
}

TEST(PlotSvg, HasAxesLegendAndEscapedNames) {
    const std::string svg = svgOf(layOut(twoCurves()));
    EXPECT_THAT(svg, testing::StartsWith("<svg xmlns=\"http://www.w3.org/2000/svg\""));
    for (const char* word : {">title<", ">frame<", ">things (count)<", ">Lamp<", ">S&lt;n<", ">10<"}) {
        EXPECT_THAT(svg, HasSubstr(word));
    }
    EXPECT_THAT(svg, Not(HasSubstr("nan")));
    EXPECT_EQ(countOf(svg, "<text"), countOf(svg, "</text>"));
}

TEST(PlotPicture, DrawsTheSameLinesAtTwiceTheSize) {
    const Drawing drawing = layOut(twoCurves());
    const RgbPicture picture = pictureOf(drawing);
    ASSERT_EQ(picture.width, 2 * drawing.width);
    ASSERT_EQ(picture.height, 2 * drawing.height);
    const auto at = [&](double x, double y) {
        const std::size_t i = (std::size_t(y) * std::size_t(picture.width) + std::size_t(x)) * 3;
        return Rgb8{picture.rgb[i], picture.rgb[i + 1], picture.rgb[i + 2]};
    };
    const PlotPoint corner = lineOf(drawing, categoryColor(0), 3)->points[1];
    EXPECT_EQ(at(2 * corner.x, 2 * corner.y), categoryColor(0));
    EXPECT_EQ(at(2, 2), (Rgb8{255, 255, 255}));
    const PlotPoint start = lineOf(drawing, categoryColor(1), 2)->points[0];
    EXPECT_EQ(at(2 * start.x + 40, 2 * start.y), categoryColor(1));
}

TEST(PlotPicture, DashesLeaveGaps) {
    Drawing drawing{40, 10, {{{{0, 5}, {40, 5}}, {0, 0, 0}, 2.0, 8.0}}, {}};
    const RgbPicture picture = pictureOf(drawing);
    const auto isDark = [&](int x) { return picture.rgb[(10 * 80 + std::size_t(x)) * 3] < 128; };
    EXPECT_TRUE(isDark(8));
    EXPECT_FALSE(isDark(24));
    EXPECT_TRUE(isDark(40));
    EXPECT_FALSE(isDark(56));
}

TEST(StatisticsPlot, HasALineForEachLight) {
    const Plot plot = statisticsPlot(twoFramesFile(), "overdraw.fragments");
    EXPECT_EQ(plot.title, "courtyard.yaml: overdraw.fragments");
    EXPECT_EQ(plot.yLabel, "fragments of shadow volumes (count)");
    ASSERT_EQ(plot.series.size(), 2u);
    EXPECT_EQ(plot.series[0].name, "Lamp");
    EXPECT_THAT(plot.series[0].points, ElementsAre(std::pair(1.0, 1010.0), std::pair(2.0, 2010.0)));
    EXPECT_EQ(plot.series[1].name, "Sun");
}

TEST(StatisticsPlot, OfTheFrameIsOneLine) {
    const Plot plot = statisticsPlot(twoFramesFile(), "time.frame");
    ASSERT_EQ(plot.series.size(), 1u);
    EXPECT_THAT(plot.series[0].points, ElementsAre(std::pair(1.0, 12.25), std::pair(2.0, 24.5)));
}

TEST(StatisticsPlot, SaysTheNearestNameOfOneThatIsNotThere) {
    try {
        statisticsPlot(twoFramesFile(), "overdraw.fragment");
        ADD_FAILURE() << "plotted";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::Usage);
        EXPECT_THAT(std::string(error.what()), HasSubstr("did you mean \"overdraw.fragments\"?"));
    }
}

}  // namespace
}  // namespace umbrage
