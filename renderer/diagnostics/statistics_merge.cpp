// SPDX-License-Identifier: Apache-2.0
#include "diagnostics/statistics_merge.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <utility>

#include "diagnostics/statistics_format.h"
#include "error.h"

namespace umbrage {
namespace {

[[noreturn]] void refuse(const NamedStatistics& file, const std::string& message, const std::string& hint) {
    throw Error(ErrorKind::Input, file.name, message, hint);
}

/// Adds what a table lacks of another.
/// @return  where each row of the other is in the table now
template <class Entry>
std::vector<std::size_t> mergeTable(std::vector<Entry>& table, const std::vector<Entry>& other,
                                    const NamedStatistics& file) {
    std::vector<std::size_t> positions;
    for (const Entry& entry : other) {
        const auto known =
            std::find_if(table.begin(), table.end(), [&](const Entry& e) { return e.name == entry.name; });
        positions.push_back(static_cast<std::size_t>(known - table.begin()));
        if (known == table.end()) {
            table.push_back(entry);
        } else if (*known != entry) {
            refuse(file, fmt::format("{} means something else than in the files before", entry.name),
                   "merge files of one version of umbrage");
        }
    }
    return positions;
}

void mergeHeader(StatisticsFile& merged, const NamedStatistics& other) {
    for (const auto& [key, value] : other.file.header) {
        const auto known = std::find_if(merged.header.begin(), merged.header.end(),
                                        [&, name = key](const auto& entry) { return entry.first == name; });
        if (known == merged.header.end()) {
            merged.header.emplace_back(key, value);
        } else if (known->second != value) {
            if (key == "sequence") {
                refuse(other, fmt::format("is of {}, the files before are of {}", value, known->second),
                       "merge files of one sequence");
            }
            if (("; " + known->second + "; ").find("; " + value + "; ") == std::string::npos) {
                known->second += "; " + value;
            }
        }
    }
}

std::string textOf(int frame, const StatisticsPlace& place) {
    std::string text = fmt::format("frame {}", frame);
    for (const Dimension& dimension : kDimensions) {
        if (!(place.*dimension.name).empty()) text += fmt::format(", {} {}", dimension.key, place.*dimension.name);
    }
    return text;
}

/// @param positions  where the other's rows are in `table`
template <class Value, class Entry>
void mergeNumbers(std::map<std::size_t, Value>& numbers, const std::map<std::size_t, Value>& others,
                  const std::vector<std::size_t>& positions, const std::vector<Entry>& table, const std::string& where,
                  const NamedStatistics& file) {
    for (const auto& [index, value] : others) {
        const auto [known, isNew] = numbers.try_emplace(positions[index], value);
        if (isNew || known->second == value) continue;
        refuse(file, fmt::format("has another {} for {} than the files before", table[positions[index]].name, where),
               "leave out one of the files, or choose frames with --frames");
    }
}

template <class Value, class Entry>
std::map<std::size_t, Value> selectedNumbers(const std::map<std::size_t, Value>& numbers,
                                             const std::vector<Entry>& table, const StatisticsSelection& selection) {
    std::map<std::size_t, Value> selected;
    for (const auto& [index, value] : numbers) {
        if (!selection.name || selection.name(table[index].name)) selected.emplace(index, value);
    }
    return selected;
}

}  // namespace

StatisticsFile mergedStatistics(const std::vector<NamedStatistics>& files) {
    assert(!files.empty());
    StatisticsFile merged = files.front().file;
    for (std::size_t i = 1; i < files.size(); ++i) {
        const NamedStatistics& other = files[i];
        mergeHeader(merged, other);
        const auto counters = mergeTable(merged.counters, other.file.counters, other);
        const auto quantities = mergeTable(merged.quantities, other.file.quantities, other);
        for (const auto& [frame, places] : other.file.frames) {
            for (const auto& [place, figures] : places) {
                Figures& known = merged.frames[frame][place];
                const std::string where = textOf(frame, place);
                mergeNumbers(known.values, figures.values, counters, merged.counters, where, other);
                mergeNumbers(known.distributions, figures.distributions, quantities, merged.quantities, where, other);
            }
        }
    }
    std::vector<Budget> budgets;
    for (const NamedStatistics& part : files) {
        for (const Budget& budget : budgetsOf(part.file.budgets)) {
            if (std::ranges::find(budgets, budget) == budgets.end()) budgets.push_back(budget);
        }
    }
    merged.budgets = checkBudgets(merged, budgets);
    return merged;
}

StatisticsFile selectedStatistics(const StatisticsFile& file, const StatisticsSelection& selection) {
    StatisticsFile selected = file;
    if (selection.frame) std::erase_if(selected.frames, [&](const auto& f) { return !selection.frame(f.first); });
    selected.budgets = checkBudgets(selected, budgetsOf(file.budgets));  // of whole frames, whatever is kept of them
    for (auto& [frame, kept] : selected.frames) {
        const FrameFigures places = std::exchange(kept, {});
        for (const auto& [place, figures] : places) {
            if (selection.light && (place.light.empty() || !selection.light(place.light))) continue;
            Figures some{selectedNumbers(figures.values, file.counters, selection),
                         selectedNumbers(figures.distributions, file.quantities, selection)};
            if (!some.values.empty() || !some.distributions.empty()) kept.emplace(place, std::move(some));
        }
    }
    return selected;
}

}  // namespace umbrage
