// SPDX-License-Identifier: Apache-2.0
#include "report/statistics_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "diagnostics/statistics_format.h"
#include "diagnostics/statistics_summary.h"
#include "job/frame_range.h"
#include "report/budget_table.h"
#include "report/text_table.h"

namespace umbrage {
namespace {

using Rows = std::vector<std::vector<std::string>>;

const std::vector<bool> kIsText{true, false, false, false, false, true};

void addHeading(Rows& rows, const std::string& title) {
    if (!rows.empty()) rows.push_back(std::vector<std::string>(kIsText.size()));
    rows.push_back({title, "total", "mean", "largest", "in frame", "unit"});
}

void addCounters(const StatisticsFile& file, const PlaceSummary& place, const std::string& group, Rows& rows) {
    for (const auto& [index, sum] : place.values) {
        const StatisticsFile::CounterEntry& counter = file.counters[index];
        if (!group.empty() && counter.group != group) continue;
        rows.push_back({fmt::format("  {}", counter.name),
                        counter.combine == Combine::Sum ? readableNumber(sum.total) : "", readableNumber(sum.mean),
                        readableNumber(sum.max), std::to_string(sum.maxFrame), counter.unit});
    }
}

void addGroups(const StatisticsFile& file, const PlaceSummary& whole, Rows& rows) {
    std::vector<std::string> groups;
    for (const auto& [index, sum] : whole.values) {
        const std::string& group = file.counters[index].group;
        if (std::find(groups.begin(), groups.end(), group) != groups.end()) continue;
        groups.push_back(group);
        addHeading(rows, group);
        addCounters(file, whole, group, rows);
    }
}

std::string nameOf(const StatisticsPlace& place) {
    std::string name;
    for (const Dimension& dimension : kDimensions) name += place.*dimension.name;
    return name.empty() ? "frame" : name;
}

/// Of all places: there are few.
std::string distributionTable(const StatisticsFile& file, const StatisticsSummary& summary) {
    Rows rows{{"pixels", ""}};
    std::vector<bool> isText{true, true};
    for (const DistributionFigure& figure : kDistributionFigures) {
        rows[0].emplace_back(figure.name);
        isText.push_back(false);
    }
    rows[0].emplace_back("unit");
    isText.push_back(true);
    for (const auto& [place, figures] : summary.places) {
        for (const auto& [index, distribution] : figures.distributions) {
            std::vector<std::string>& row = rows.emplace_back();
            row = {fmt::format("  {}", file.quantities[index].name), nameOf(place)};
            for (const DistributionFigure& figure : kDistributionFigures) {
                row.push_back(readableNumber(figure.of(distribution)));
            }
            row.push_back(file.quantities[index].unit);
        }
    }
    return rows.size() > 1 ? fmt::format("\n{}", alignedTable(rows, isText)) : "";
}

std::string casterTable(const StatisticsSummary& summary) {
    if (summary.topCasters.empty()) return "";
    Rows rows{{"casters with most fill", kTopCastersCounter, "share"}};
    for (const TopCaster& caster : summary.topCasters) {
        rows.push_back({fmt::format("  {}", caster.caster), readableNumber(caster.value),
                        fmt::format("{:.1f} %", 100.0 * caster.share)});
    }
    return fmt::format("\n{}", alignedTable(rows, {true, false, false}));
}

std::string headLine(const StatisticsFile& file) {
    std::vector<int> frames;
    for (const auto& [frame, figures] : file.frames) frames.push_back(frame);
    std::string line;
    for (const auto& [key, value] : file.header) line.append(key).append(": ").append(value).append("; ");
    line.append("frames: ").append(frames.empty() ? "none" : FrameRange::textOf(frames));
    return printable(std::move(line)).append("\n");
}

}  // namespace

std::string readableNumber(double value) {
    const double size = std::abs(value);
    const bool isWhole = value == std::floor(value);
    if (size >= 1e15 || (size < 1e-3 && !isWhole)) return fmt::format("{:.3g}", value);
    const int decimals = isWhole || size >= 1000.0 ? 0 : size >= 100.0 ? 1 : size >= 10.0 ? 2 : 3;
    const std::string digits = fmt::format("{:.{}f}", value, decimals);
    const std::size_t point = std::min(digits.find('.'), digits.size());
    std::string text;
    for (std::size_t i = 0; i < digits.size(); ++i) {
        if (i > (value < 0.0 ? 1u : 0u) && i < point && (point - i) % 3 == 0) text += ',';
        text += digits[i];
    }
    return text;
}

std::string statisticsTable(const StatisticsFile& file) {
    const StatisticsSummary summary = summaryOf(file);
    Rows rows;
    for (const auto& [place, figures] : summary.places) {
        if (place == StatisticsPlace{}) {
            addGroups(file, figures, rows);
        } else if (!place.light.empty() && !figures.values.empty()) {
            addHeading(rows, fmt::format("light {}", place.light));
            addCounters(file, figures, "", rows);
        }
    }
    const std::string table = rows.empty() ? "" : fmt::format("\n{}", alignedTable(rows, kIsText));
    const std::string budgets = file.budgets.empty() ? "" : fmt::format("\n{}", budgetTable(file.budgets));
    return headLine(file) + budgets + table + distributionTable(file, summary) + casterTable(summary);
}

}  // namespace umbrage
