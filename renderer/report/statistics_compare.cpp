// SPDX-License-Identifier: Apache-2.0
#include "report/statistics_compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "diagnostics/median.h"
#include "diagnostics/statistics_format.h"
#include "diagnostics/statistics_merge.h"
#include "diagnostics/statistics_summary.h"
#include "report/statistics_table.h"
#include "report/text_table.h"

namespace umbrage {
namespace {

constexpr double kNoRatio = std::numeric_limits<double>::quiet_NaN();

StatisticsFile framesIn(const StatisticsFile& file, const StatisticsFile& other) {
    return selectedStatistics(file, {.frame = [&](int frame) { return other.frames.contains(frame); }});
}

double ratioOf(double before, double after) {
    return before != 0.0 ? after / before : after == 0.0 ? 1.0 : kNoRatio;
}

/// What stands for the sequence.
double representative(const CounterSummary& sum, Combine combine, bool isMeasured) {
    if (isMeasured) return sum.mean;
    return combine == Combine::Sum ? sum.total : combine == Combine::Largest ? sum.max : sum.mean;
}

class Comparison {
public:
    Comparison(const StatisticsFile& before, const StatisticsFile& after)
        : before_(framesIn(before, after)),
          after_(framesIn(after, before)),
          framesBefore_(namedFrames(before_)),
          framesAfter_(namedFrames(after_)) {}

    StatisticsComparison result() const {
        StatisticsComparison result;
        const StatisticsSummary before = summaryOf(before_), after = summaryOf(after_);
        for (const auto& [place, figures] : before.places) {
            const auto other = after.places.find(place);
            if (other == after.places.end()) {
                result.onlyBefore.push_back(placeText(place));
                continue;
            }
            addCounters(place, figures, other->second, result.changes);
            addDistributions(place, figures, other->second, result.changes);
        }
        for (const auto& [place, figures] : after.places) {
            if (!before.places.contains(place)) result.onlyAfter.push_back(placeText(place));
        }
        return result;
    }

private:
    void addCounters(const StatisticsPlace& place, const PlaceSummary& before, const PlaceSummary& after,
                     std::vector<StatisticsChange>& changes) const {
        for (const auto& [index, sum] : before.values) {
            const StatisticsFile::CounterEntry& counter = before_.counters[index];
            const auto other = std::find_if(after.values.begin(), after.values.end(), [&](const auto& entry) {
                return after_.counters[entry.first].name == counter.name;
            });
            if (other == after.values.end()) continue;
            StatisticsChange change{.place = place, .name = counter.name, .unit = counter.unit};
            change.isMeasured = isMeasured(counter.unit);
            change.before = representative(sum, counter.combine, change.isMeasured);
            change.after = representative(other->second, counter.combine, change.isMeasured);
            change.ratio = ratioOf(change.before, change.after);
            pair(change);
            changes.push_back(std::move(change));
        }
    }

    /// Frame by frame.
    void pair(StatisticsChange& change) const {
        std::vector<double> ratios;
        for (const auto& [frame, places] : framesBefore_) {
            const auto one = find(places, change), other = find(framesAfter_.at(frame), change);
            if (!one && !other) continue;
            ++change.frames;
            if (one != other) ++change.framesThatDiffer;
            if (one && other && *one != 0.0) ratios.push_back(*other / *one);
        }
        if (!change.isMeasured || ratios.empty()) return;
        change.ratio = median(ratios);
        change.interval = medianInterval(std::move(ratios));
    }

    static std::optional<double> find(const NamedFrames::mapped_type& places, const StatisticsChange& change) {
        const auto place = places.find(change.place);
        if (place == places.end()) return std::nullopt;
        const auto value = place->second.find(change.name);
        return value == place->second.end() ? std::nullopt : std::optional(value->second);
    }

    void addDistributions(const StatisticsPlace& place, const PlaceSummary& before, const PlaceSummary& after,
                          std::vector<StatisticsChange>& changes) const {
        for (const auto& [index, distribution] : before.distributions) {
            const StatisticsFile::QuantityEntry& quantity = before_.quantities[index];
            const auto other =
                std::find_if(after.distributions.begin(), after.distributions.end(),
                             [&](const auto& entry) { return after_.quantities[entry.first].name == quantity.name; });
            if (other == after.distributions.end()) continue;
            for (const DistributionFigure& figure : kDistributionFigures) {
                StatisticsChange change{
                    .place = place, .name = figureName(quantity.name, figure), .unit = quantity.unit};
                change.before = figure.of(distribution);
                change.after = figure.of(other->second);
                change.ratio = ratioOf(change.before, change.after);
                pair(change);
                changes.push_back(std::move(change));
            }
        }
    }

    StatisticsFile before_, after_;  // the frames of both
    NamedFrames framesBefore_, framesAfter_;
};

std::string ratioText(const StatisticsChange& change) {
    return std::isnan(change.ratio) ? "-" : fmt::format("{:.3f}", change.ratio);
}

std::string intervalText(const StatisticsChange& change) {
    return change.interval ? fmt::format("{:.3f}-{:.3f}", change.interval->first, change.interval->second) : "";
}

std::vector<std::string> onlyIn(const std::string& place, const char* when) {
    return {place, when, "", "", "", "", "", "*", ""};
}

}  // namespace

std::string placeText(const StatisticsPlace& place) {
    std::string text;
    for (const Dimension& dimension : kDimensions) text += place.*dimension.name;
    return text;
}

NamedFrames namedFrames(const StatisticsFile& file) {
    NamedFrames frames;
    for (const auto& [frame, places] : file.frames) {
        for (const auto& [place, figures] : withWholes(file, places)) {
            if (dimensionsOf(place) > 1) continue;
            std::map<std::string, double>& named = frames[frame][place];
            for (const auto& [index, value] : figures.values) named[file.counters[index].name] = value;
            for (const auto& [index, distribution] : figures.distributions) {
                for (const DistributionFigure& figure : kDistributionFigures) {
                    named[figureName(file.quantities[index].name, figure)] = figure.of(distribution);
                }
            }
        }
    }
    return frames;
}

std::optional<std::pair<double, double>> medianInterval(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const std::size_t n = values.size();
    // With k values cut off at either end, the median is outside with a chance of 2 P(B <= k), B ~ binomial(n, 1/2).
    double logChance = -static_cast<double>(n) * std::log(2.0), below = 0.0;
    std::size_t cut = 0;
    for (; cut < n / 2; ++cut) {
        below += std::exp(logChance);
        if (2.0 * below > 0.05) break;
        logChance += std::log(static_cast<double>(n - cut) / static_cast<double>(cut + 1));
    }
    if (cut == 0) return std::nullopt;
    return std::pair(values[cut - 1], values[n - cut]);
}

StatisticsComparison compareStatistics(const StatisticsFile& before, const StatisticsFile& after) {
    return Comparison(before, after).result();
}

std::string comparisonTable(const StatisticsFile& before, const StatisticsFile& after) {
    std::vector<std::vector<std::string>> rows{
        {"place", "counter", "before", "after", "change", "ratio", "95 % interval", "", "unit"}};
    std::size_t hidden = 0, significant = 0, common = 0;
    const StatisticsComparison comparison = compareStatistics(before, after);
    for (const StatisticsChange& change : comparison.changes) {
        significant += change.isSignificant();
        if (change.place != StatisticsPlace{} && !change.isSignificant()) {
            ++hidden;
            continue;
        }
        rows.push_back({placeText(change.place), change.name, readableNumber(change.before),
                        readableNumber(change.after), readableNumber(change.after - change.before), ratioText(change),
                        intervalText(change), change.isSignificant() ? "*" : "", change.unit});
    }
    for (const std::string& place : comparison.onlyBefore) rows.push_back(onlyIn(place, "only before"));
    for (const std::string& place : comparison.onlyAfter) rows.push_back(onlyIn(place, "only after"));
    for (const auto& [frame, figures] : before.frames) common += after.frames.contains(frame);
    std::string text = alignedTable(rows, {true, true, false, false, false, false, false, true, true});
    text += fmt::format(
        "\n{} of {} and {} frames are in both. * marks what changed: counts that differ in any frame; measured "
        "numbers (ms, MiB, ratios)\nwhose frame-by-frame ratio has a median other than 1 (sign test, 95 %).",
        common, before.frames.size(), after.frames.size());
    text += fmt::format(" {} changed", significant);
    if (hidden > 0) text += fmt::format("; {} of lights, casters and materials that did not are left out", hidden);
    return text + ".\n";
}

}  // namespace umbrage
