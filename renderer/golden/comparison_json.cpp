// SPDX-License-Identifier: Apache-2.0
// The model as JSON.
#include "diagnostics/budgets_json.h"
#include "diagnostics/json_number.h"
#include "golden/comparison_format.h"
#include "golden/reports.h"
#include "golden/result_text.h"

namespace umbrage {
namespace {

using Json = nlohmann::ordered_json;

Json jsonOf(const Provenance& provenance) {
    Json json;
    for (const ProvenanceField& field : kProvenanceFields) json[field.key] = provenance.*field.text;
    return json;
}

Json jsonOf(const ImageResult& image) {
    Json json = {{"name", image.name},
                 {"aov", image.aov},
                 {"frame", image.frame},
                 {"outcome", infoOf(image.outcome).name},
                 {"reason", image.reason}};
    if (image.decision) {
        json["decision"] = {{"rule", image.decision->rule},
                            {"metric", image.decision->metric},
                            {"limit", shortestNumber(image.decision->limit)},
                            {"value", shortestNumber(image.decision->value)}};
    }
    json["figures"] = Json::object();
    for (const Figure& figure : image.figures) json["figures"][figure.metric] = shortestNumber(figure.value);
    json["width"] = image.width;
    json["height"] = image.height;
    json["channels"] = image.channels;
    if (image.worst.first >= 0) json["worst"] = {image.worst.first, image.worst.second};
    return json;
}

Json jsonOf(const StatisticsResult& column) {
    return {{"column", column.column},
            {"frame", column.frame},
            {"outcome", infoOf(column.outcome).name},
            {"golden", shortestNumber(column.golden)},
            {"output", shortestNumber(column.output)},
            {"tolerance", shortestNumber(column.tolerance)},
            {"reason", column.reason}};
}

Json jsonOf(const BudgetResult& budget) {
    Json json = budgetJson(budget);
    json["unit"] = budget.unit;  // there is no table of figures here that would have it
    return json;
}

template <class Results>
Json listOf(const Results& results) {
    Json list = Json::array();
    for (const auto& result : results) list.push_back(jsonOf(result));
    return list;
}

std::string seenFrom(const std::filesystem::path& folder, const std::string& path) {
    if (path.empty()) return path;
    const std::filesystem::path relative =
        std::filesystem::absolute(path).lexically_normal().lexically_relative(folder);
    return relative.empty() ? path : relative.generic_string();
}

}  // namespace

Comparison relativeTo(const std::filesystem::path& folder, Comparison comparison) {
    const std::filesystem::path from = std::filesystem::absolute(folder.empty() ? "." : folder).lexically_normal();
    comparison.golden = seenFrom(from, comparison.golden);
    comparison.output = seenFrom(from, comparison.output);
    return comparison;
}

std::string comparisonJson(const Comparison& comparison) {
    Json json = {{"format", kComparisonFormat},
                 {"passes", comparison.passes()},
                 {"golden", comparison.golden},
                 {"output", comparison.output}};
    if (comparison.goldenFrom) json["goldenFrom"] = jsonOf(*comparison.goldenFrom);
    if (comparison.outputFrom) json["outputFrom"] = jsonOf(*comparison.outputFrom);
    json["foreignDevice"] = comparison.foreignDevice;
    json["notes"] = comparison.notes;
    const auto counts = countsOf(comparison);
    json["counts"] = Json::object();
    for (std::size_t o = 0; o < counts.size(); ++o) {
        if (counts[o] > 0) json["counts"][std::string(kOutcomes[o].name)] = counts[o];
    }
    json["images"] = listOf(comparison.images);
    json["statistics"] = listOf(comparison.statistics);
    if (!comparison.budgets.empty()) json["budgets"] = listOf(comparison.budgets);
    json["renderCommand"] = comparison.renderCommand;
    json["acceptCommand"] = comparison.acceptCommand;
    // names of files need not be text
    return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace umbrage
