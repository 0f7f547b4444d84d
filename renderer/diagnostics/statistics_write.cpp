// SPDX-License-Identifier: Apache-2.0
// StatisticsFile as JSON and CSV.
#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "diagnostics/budgets_json.h"
#include "diagnostics/csv_field.h"
#include "diagnostics/statistics_format.h"
#include "diagnostics/statistics_summary.h"

namespace umbrage {
namespace {

using Json = nlohmann::ordered_json;
using Entry = FrameFigures::const_iterator;

// Counts are whole numbers and should look like it.
Json jsonNumber(double value) {
    constexpr double kExactIntegers = 9007199254740992.0;  // 2^53
    if (value == std::floor(value) && std::abs(value) <= kExactIntegers) return static_cast<std::int64_t>(value);
    return value;
}

/// At the end, without the search for the name that operator[] begins with: names are unique as they come.
void append(Json& object, const std::string& name, Json value) {
    object.get_ref<Json::object_t&>().emplace_back(name, std::move(value));
}

Json jsonOf(const Distribution& distribution) {
    Json histogram = Json::array();
    for (const auto& [start, pixels] : distribution.histogram()) histogram.push_back({jsonNumber(start), pixels});
    Json json = {{"pixels", distribution.pixels()}, {"sum", jsonNumber(distribution.sum())}};
    for (const DistributionFigure& figure : kDistributionFigures) {
        json[figure.name] = jsonNumber(figure.of(distribution));
    }
    json["histogram"] = histogram;
    return json;
}

class Writer {
public:
    explicit Writer(const StatisticsFile& file) : file_(file) {}

    Json frame(int frame, const FrameFigures& figures) const {
        Json node = {{"frame", frame}, {"values", Json::object()}, {"distributions", Json::object()}};
        fill(node, figures.begin(), figures.end(), 0);
        return node;
    }

    Json summary(const StatisticsSummary& summary) const {
        Json json = {{"frames", summary.frames}};
        json.update(summaryOf(summary.places.at({})));
        for (const Dimension& dimension : kDimensions) {
            Json& parts = json[dimension.key] = Json::object();
            for (const auto& [place, figures] : summary.places) {
                const std::string& name = place.*dimension.name;
                if (!name.empty() && dimensionsOf(place) == 1) append(parts, name, summaryOf(figures));
            }
        }
        Json& top = json["topCasters"] = Json::array();
        for (const TopCaster& caster : summary.topCasters) {
            top.push_back({{"caster", caster.caster},
                           {kTopCastersCounter, jsonNumber(caster.value)},
                           {"share", jsonNumber(caster.share)}});
        }
        return json;
    }

private:
    Json distributionsOf(const std::map<std::size_t, Distribution>& distributions) const {
        Json json = Json::object();
        for (const auto& [index, distribution] : distributions) {
            append(json, file_.quantities[index].name, jsonOf(distribution));
        }
        return json;
    }

    /// What is known of the places from `first` to `last`, which are alike in the dimensions before this one.
    void fill(Json& node, Entry first, Entry last, std::size_t dimension) const {
        if (first == last) return;
        if (dimension == kDimensions.size()) {
            for (const auto& [index, value] : first->second.values) {
                append(node["values"], file_.counters[index].name, jsonNumber(value));
            }
            const Json distributions = distributionsOf(first->second.distributions);
            if (!distributions.empty()) node["distributions"] = distributions;
            return;
        }
        const auto nameOfEntry = [&](const auto& entry) -> const std::string& {
            return entry.first.*kDimensions[dimension].name;
        };
        Entry group = std::find_if(first, last, [&](const auto& entry) { return !nameOfEntry(entry).empty(); });
        fill(node, first, group, dimension + 1);
        if (group == last) return;
        Json& parts = node[kDimensions[dimension].key] = Json::object();
        while (group != last) {
            const std::string& name = nameOfEntry(*group);
            const Entry end = std::find_if(group, last, [&](const auto& entry) { return nameOfEntry(entry) != name; });
            Json part = {{"values", Json::object()}};
            fill(part, group, end, dimension + 1);
            append(parts, name, std::move(part));
            group = end;
        }
    }

    Json summaryOf(const PlaceSummary& place) const {
        Json values = Json::object();
        for (const auto& [index, counter] : place.values) {
            Json json = Json::object();
            if (file_.counters[index].combine == Combine::Sum) json["total"] = jsonNumber(counter.total);
            json["mean"] = jsonNumber(counter.mean);
            json["max"] = jsonNumber(counter.max);
            json["maxFrame"] = counter.maxFrame;
            append(values, file_.counters[index].name, std::move(json));
        }
        return {{"values", values}, {"distributions", distributionsOf(place.distributions)}};
    }

    const StatisticsFile& file_;
};

}  // namespace

std::string StatisticsFile::json() const {
    Json document = {{"format", kStatisticsFormat}};
    for (const auto& [name, value] : header) document[name] = value;
    Json& counterTable = document["counters"] = Json::object();
    for (const CounterEntry& counter : counters) {
        Json entry = {{"group", counter.group},
                      {"unit", counter.unit},
                      {"doc", counter.doc},
                      {"combine", nameOf(counter.combine)}};
        if (!counter.numerator.empty()) entry["ratio"] = {counter.numerator, counter.denominator};
        append(counterTable, counter.name, std::move(entry));
    }
    Json& quantityTable = document["quantities"] = Json::object();
    for (const QuantityEntry& quantity : quantities) {
        append(quantityTable, quantity.name, {{"unit", quantity.unit}, {"doc", quantity.doc}, {"aov", quantity.aov}});
    }
    for (const BudgetResult& result : budgets) document["budgets"].push_back(budgetJson(result));
    // A light's name is whatever the scene says: bytes that are not UTF-8 become U+FFFD rather than an exception.
    const auto textOf = [](const Json& value, int indent) {
        return value.dump(indent, ' ', false, Json::error_handler_t::replace);
    };
    // A frame is one line: with a line for each number of a histogram files are five times as large.
    const Writer writer(*this);
    std::string text = textOf(document, 1);
    text.resize(text.size() - 2);  // the last line, "}"
    text += ",\n \"frames\": [";
    const char* before = "\n  ";
    for (const auto& [frame, figures] : frames) {
        text += before + textOf(writer.frame(frame, figures), -1);
        before = ",\n  ";
    }
    return text + "],\n \"summary\": " + textOf(writer.summary(summaryOf(*this)), -1) + "\n}\n";
}

std::string StatisticsFile::csv() const {
    std::string text = "frame,light,caster,material,counter,unit,value\n";
    for (const auto& [frame, figures] : frames) {
        for (const auto& [place, numbers] : figures) {
            const std::string where = fmt::format("{},{},{},{}", frame, csvField(place.light), csvField(place.caster),
                                                  csvField(place.material));
            for (const auto& [index, value] : numbers.values) {
                text += fmt::format("{},{},{},{}\n", where, counters[index].name, counters[index].unit, value);
            }
            for (const auto& [index, distribution] : numbers.distributions) {
                for (const DistributionFigure& figure : kDistributionFigures) {
                    text += fmt::format("{},{}.{},{},{}\n", where, quantities[index].name, figure.name,
                                        quantities[index].unit, figure.of(distribution));
                }
            }
        }
    }
    return text;
}

}  // namespace umbrage
