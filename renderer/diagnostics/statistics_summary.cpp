// SPDX-License-Identifier: Apache-2.0
#include "diagnostics/statistics_summary.h"

#include <algorithm>
#include <array>
#include <optional>

#include "diagnostics/statistics_format.h"

namespace umbrage {
namespace {

std::optional<std::size_t> indexOf(const StatisticsFile& file, std::string_view counter) {
    const auto found = std::find_if(file.counters.begin(), file.counters.end(),
                                    [&](const auto& entry) { return entry.name == counter; });
    if (found == file.counters.end()) return std::nullopt;
    return static_cast<std::size_t>(found - file.counters.begin());
}

/// The positions of the counters that a ratio is made of.
struct Ratio {
    std::size_t numerator, denominator;
};

std::optional<Ratio> ratioOf(const StatisticsFile& file, std::size_t counter) {
    const auto numerator = indexOf(file, file.counters[counter].numerator);
    const auto denominator = indexOf(file, file.counters[counter].denominator);
    if (!numerator || !denominator) return std::nullopt;
    return Ratio{*numerator, *denominator};
}

/// Puts into `whole` what it lacks of its parts' counters.
class Combiner {
public:
    explicit Combiner(const StatisticsFile& file) : file_(file) {
        for (std::size_t i = 0; i < file.counters.size(); ++i) ratios_.push_back(ratioOf(file, i));
    }

    void combine(const std::vector<const Figures*>& parts, std::map<std::size_t, double>& whole) const {
        std::map<std::size_t, double> combined;
        for (const Figures* part : parts) {
            for (const auto& [counter, value] : part->values) {
                const auto [entry, isFirst] = combined.try_emplace(counter, value);
                if (isFirst) continue;
                entry->second = file_.counters[counter].combine == Combine::Sum ? entry->second + value
                                                                                : std::max(entry->second, value);
            }
        }
        for (const auto& [counter, value] : combined) {
            if (file_.counters[counter].combine != Combine::Mean) whole.try_emplace(counter, value);
        }
        for (const auto& [counter, value] : combined) {
            if (!ratios_[counter]) continue;
            const auto above = whole.find(ratios_[counter]->numerator);
            const auto below = whole.find(ratios_[counter]->denominator);
            if (above != whole.end() && below != whole.end() && below->second != 0.0) {
                whole.try_emplace(counter, above->second / below->second);
            }
        }
    }

private:
    const StatisticsFile& file_;
    std::vector<std::optional<Ratio>> ratios_;
};

void addFrame(int frame, const Figures& figures, PlaceSummary& summary, std::map<std::size_t, std::size_t>& counts) {
    for (const auto& [counter, value] : figures.values) {
        CounterSummary& sum = summary.values[counter];
        if (++counts[counter] == 1 || value > sum.max) {
            sum.max = value;
            sum.maxFrame = frame;
        }
        sum.total += value;
    }
    for (const auto& [quantity, distribution] : figures.distributions) {
        summary.distributions[quantity].add(distribution);
    }
}

void findMeans(const StatisticsFile& file, const std::map<std::size_t, std::size_t>& counts, PlaceSummary& summary) {
    for (auto& [counter, sum] : summary.values) {
        sum.mean = sum.total / static_cast<double>(counts.at(counter));
        const std::optional<Ratio> ratio = ratioOf(file, counter);
        if (!ratio) continue;
        const auto above = summary.values.find(ratio->numerator), below = summary.values.find(ratio->denominator);
        if (above != summary.values.end() && below != summary.values.end() && below->second.total != 0.0) {
            sum.mean = above->second.total / below->second.total;
        }
    }
}

std::vector<TopCaster> topCastersOf(const StatisticsFile& file, const StatisticsSummary& summary) {
    std::vector<TopCaster> casters;
    const std::optional<std::size_t> counter = indexOf(file, kTopCastersCounter);
    if (!counter) return casters;
    const PlaceSummary& whole = summary.places.at({});
    const double all = whole.values.contains(*counter) ? whole.values.at(*counter).total : 0.0;
    for (const auto& [place, figures] : summary.places) {
        if (place.caster.empty() || !figures.values.contains(*counter)) continue;
        const double value = figures.values.at(*counter).total;
        if (value > 0.0) casters.push_back({place.caster, value, all > 0.0 ? value / all : 0.0});
    }
    std::stable_sort(casters.begin(), casters.end(), [](const auto& a, const auto& b) { return a.value > b.value; });
    casters.resize(std::min(casters.size(), kMostTopCasters));
    return casters;
}

}  // namespace

FrameFigures withWholes(const StatisticsFile& file, const FrameFigures& frame) {
    const Combiner combiner(file);
    FrameFigures result = frame;
    for (std::size_t level = kDimensions.size(); level > 0; --level) {
        std::map<StatisticsPlace, std::array<std::vector<const Figures*>, kDimensions.size()>> wholes;
        for (const auto& [place, figures] : result) {
            if (dimensionsOf(place) != level) continue;
            for (std::size_t d = 0; d < kDimensions.size(); ++d) {
                if ((place.*kDimensions[d].name).empty()) continue;
                StatisticsPlace whole = place;
                (whole.*kDimensions[d].name).clear();
                wholes[whole][d].push_back(&figures);
            }
        }
        for (const auto& [place, partsByDimension] : wholes) {
            for (const auto& parts : partsByDimension) combiner.combine(parts, result[place].values);
        }
    }
    return result;
}

StatisticsSummary summaryOf(const StatisticsFile& file) {
    StatisticsSummary summary;
    summary.frames = file.frames.size();
    std::map<StatisticsPlace, std::map<std::size_t, std::size_t>> counts;
    summary.places[{}];
    for (const auto& [frame, figures] : file.frames) {
        for (const auto& [place, numbers] : withWholes(file, figures)) {
            if (dimensionsOf(place) > 1) continue;
            addFrame(frame, numbers, summary.places[place], counts[place]);
        }
    }
    for (auto& [place, figures] : summary.places) findMeans(file, counts[place], figures);
    summary.topCasters = topCastersOf(file, summary);
    return summary;
}

}  // namespace umbrage
