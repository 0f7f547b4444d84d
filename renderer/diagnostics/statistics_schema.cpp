// SPDX-License-Identifier: Apache-2.0
// The JSON Schema of statistics files, from the tables that write them.
#include <fmt/format.h>

#include "diagnostics/budgets_json.h"
#include "diagnostics/quantities.h"
#include "diagnostics/schema_parts.h"
#include "diagnostics/statistics_format.h"
#include "diagnostics/statistics_summary.h"

namespace umbrage {
namespace {

using Json = nlohmann::ordered_json;

Json reference(const std::string& name) {
    return {{"$ref", "#/$defs/" + name}};
}

Json mapOf(const Json& schema) {
    return {{"type", "object"}, {"additionalProperties", schema}};
}

/// An object with some names of a table.
template <class Table>
Json someOf(const Table& table, const Json& schema) {
    Json properties = Json::object();
    for (const auto& row : table) {
        properties[std::string(row.name)] = described(schema, fmt::format("{}: {}", row.unit, row.doc));
    }
    return {{"type", "object"}, {"properties", properties}, {"additionalProperties", false}};
}

/// A place that may have parts by this dimension and those after it.
Json placeSchema(std::size_t dimension) {
    Json properties = {{"values", reference("values")}, {"distributions", reference("distributions")}};
    std::vector<std::string> optional{"distributions"};
    for (std::size_t d = dimension; d < kDimensions.size(); ++d) {
        properties[kDimensions[d].key] = described(mapOf(reference(kDimensions[d].key)), kDimensions[d].doc);
        optional.emplace_back(kDimensions[d].key);
    }
    return object(properties, optional);
}

Json distributionSchema(const Json& count, const Json& amount) {
    Json properties = {{"pixels", count}, {"sum", described(amount, "of all values")}};
    for (const DistributionFigure& figure : kDistributionFigures) {
        properties[figure.name] = described(amount, figure.doc);
    }
    const Json bin = {
        {"type", "array"}, {"prefixItems", Json::array({amount, count})}, {"minItems", 2}, {"maxItems", 2}};
    properties["histogram"] = described({{"type", "array"}, {"items", bin}},
                                        "[start of the bin, pixels], ascending, without empty bins; bins are 1 wide "
                                        "below 256, above there are 128 of them an octave");
    return object(properties);
}

Json summarySchema(const Json& count, const Json& number) {
    Json properties = {{"frames", described(count, "how many there are")},
                       {"values", reference("valueSummaries")},
                       {"distributions", reference("distributions")}};
    const Json place = object({{"values", reference("valueSummaries")}, {"distributions", reference("distributions")}});
    for (const Dimension& dimension : kDimensions) {
        properties[dimension.key] = described(mapOf(place), dimension.doc);
    }
    const Json caster = object({{"caster", {{"type", "string"}}}, {kTopCastersCounter, number}, {"share", number}});
    properties["topCasters"] = described({{"type", "array"}, {"items", caster}, {"maxItems", kMostTopCasters}},
                                         fmt::format("by {}, with their share of all", kTopCastersCounter));
    return object(properties);
}

}  // namespace

std::string statisticsSchema() {
    const Json text = {{"type", "string"}}, number = {{"type", "number"}}, integer = {{"type", "integer"}};
    const Json count = {{"type", "integer"}, {"minimum", 0}}, amount = {{"type", "number"}, {"minimum", 0}};
    const Json texts = {{"type", "array"}, {"items", text}, {"minItems", 2}, {"maxItems", 2}};
    const Json valueSummary = object({{"total", described(number, "of all frames; only where values add up")},
                                      {"mean", described(number,
                                                         "over the frames that have the value; of a ratio, the "
                                                         "ratio of the totals")},
                                      {"max", number},
                                      {"maxFrame", described(integer, "the first frame with it")}},
                                     {"total"});
    Json definitions = {{"values", someOf(kCounters, number)},
                        {"distribution", distributionSchema(count, amount)},
                        {"distributions", someOf(kQuantities, reference("distribution"))},
                        {"valueSummaries", someOf(kCounters, valueSummary)}};
    for (std::size_t d = 0; d < kDimensions.size(); ++d) definitions[kDimensions[d].key] = placeSchema(d + 1);

    const Json counter =
        object({{"group", described(text, "what is shown together")},
                {"unit", text},
                {"doc", text},
                {"combine", described({{"enum", kCombineNames}}, "how values of frames or parts become the whole's")},
                {"ratio", described(texts, "counters: a mean that is the first divided by the second")}},
               {"ratio"});
    const Json quantity = object({{"unit", text}, {"doc", text}, {"aov", described(text, "channel with the values")}});
    Json frame = placeSchema(0);
    Json frameProperties = {{"frame", integer}};
    frameProperties.update(frame["properties"]);
    frame["properties"] = frameProperties;
    frame["required"] = {"frame", "values", "distributions"};

    const Json properties = {{"format", {{"const", kStatisticsFormat}}},
                             {"sequence", described(text, "file that was rendered")},
                             {"version", described(text, "of umbrage")},
                             {"device", text},
                             {"clock", described(text, "what measured the time")},
                             {"counters", mapOf(counter)},
                             {"quantities", mapOf(quantity)},
                             {"budgets", described({{"type", "array"}, {"items", budgetSchema()}},
                                                   "what every frame was held to; not there without any")},
                             {"frames", {{"type", "array"}, {"items", frame}}},
                             {"summary", summarySchema(count, number)}};
    Json schema = {{"$schema", "https://json-schema.org/draft/2020-12/schema"},
                   {"title", "umbrage statistics"},
                   {"description", "The numbers of a sequence, as umbrage render writes them."}};
    schema.update(object(properties, {"budgets"}));
    schema["$defs"] = definitions;
    return schema.dump(2) + "\n";
}

}  // namespace umbrage
