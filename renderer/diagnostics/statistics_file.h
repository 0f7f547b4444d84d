// SPDX-License-Identifier: Apache-2.0
// The numbers of a run as they stand in its file: written, read back, merged. It brings its own tables of counters and
// quantities, so that files of other versions work too.
#pragma once

#include <compare>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "diagnostics/budgets.h"
#include "diagnostics/counters.h"
#include "diagnostics/distribution.h"

namespace umbrage {

/// What a number is about: of the whole frame where all are empty, else of a light, a caster of that light ...
struct StatisticsPlace {
    std::string light{};     // id
    std::string caster{};    // node path
    std::string material{};  // name

    auto operator<=>(const StatisticsPlace&) const = default;
};

/// The numbers of a place, by their positions in the file's tables.
struct Figures {
    std::map<std::size_t, double> values;
    std::map<std::size_t, Distribution> distributions;

    bool operator==(const Figures&) const = default;
};

using FrameFigures = std::map<StatisticsPlace, Figures>;

struct StatisticsFile {
    struct CounterEntry {
        std::string name, group, unit, doc;
        Combine combine = Combine::Sum;
        std::string numerator, denominator;

        bool operator==(const CounterEntry&) const = default;
    };
    struct QuantityEntry {
        std::string name, unit, doc, aov;

        bool operator==(const QuantityEntry&) const = default;
    };

    std::vector<std::pair<std::string, std::string>> header;  // sequence, version, device, clock
    std::vector<CounterEntry> counters;
    std::vector<QuantityEntry> quantities;
    std::map<int, FrameFigures> frames;
    std::vector<BudgetResult> budgets{};  // what the run was held to; not in the CSV

    /// Tidy: frame,light,caster,material,counter,unit,value, one number a line. Lines end in \n, fields are quoted as
    /// RFC 4180 has it. A distribution is five lines: NAME.mean, .p50, .p95, .p99, .max.
    std::string csv() const;

    /// As statisticsSchema() describes it.
    std::string json() const;
};

/// @param name  for messages
/// @throws Error(Input) with the name and the JSON pointer of what is wrong
StatisticsFile parseStatistics(std::string_view json, const std::string& name);

/// @throws Error(Input)
StatisticsFile readStatistics(const std::filesystem::path& file);

/// The JSON Schema (draft 2020-12) of StatisticsFile::json().
std::string statisticsSchema();

/// What every term means, and the files and commands, as a page in Markdown.
std::string statisticsReference();

}  // namespace umbrage
