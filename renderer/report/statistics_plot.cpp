// SPDX-License-Identifier: Apache-2.0
#include "report/statistics_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "diagnostics/statistics_summary.h"
#include "error.h"
#include "job/nearest.h"

namespace umbrage {
namespace {

/// Counters that some place has.
std::vector<std::string> countersIn(const StatisticsFile& file) {
    std::set<std::size_t> indices;
    for (const auto& [frame, places] : file.frames) {
        for (const auto& [place, figures] : places) {
            for (const auto& [index, value] : figures.values) indices.insert(index);
        }
    }
    std::vector<std::string> names;
    for (const std::size_t index : indices) names.push_back(file.counters[index].name);
    return names;
}

}  // namespace

Plot statisticsPlot(const StatisticsFile& file, const std::string& counter) {
    std::map<std::string, PlotSeries> lights;
    PlotSeries whole;
    std::string unit, doc;
    for (const auto& [frame, places] : file.frames) {
        for (const auto& [place, figures] : withWholes(file, places)) {
            if (!place.caster.empty() || !place.material.empty()) continue;
            for (const auto& [index, value] : figures.values) {
                if (file.counters[index].name != counter) continue;
                unit = file.counters[index].unit;
                doc = file.counters[index].doc;
                PlotSeries& series = place.light.empty() ? whole : lights[place.light];
                series.points.emplace_back(frame, value);
            }
        }
    }
    if (unit.empty()) {
        throw Error(ErrorKind::Usage, "--counter", fmt::format("there is no number of \"{}\" to plot", counter),
                    hintForName(counter, countersIn(file)));
    }
    std::string sequence;
    for (const auto& [key, value] : file.header) {
        if (key == "sequence") sequence = fmt::format("{}: ", value);
    }
    Plot plot{fmt::format("{}{}", sequence, counter), "frame", fmt::format("{} ({})", doc, unit), {}};
    for (auto& [light, series] : lights) {
        series.name = light;
        plot.series.push_back(std::move(series));
    }
    if (plot.series.empty()) plot.series.push_back(std::move(whole));
    return plot;
}

}  // namespace umbrage
