// SPDX-License-Identifier: Apache-2.0
// The JSON Schema of comparison files.
#include "diagnostics/budgets_json.h"
#include "diagnostics/schema_parts.h"
#include "golden/comparison_format.h"
#include "golden/reports.h"

namespace umbrage {
namespace {

using Json = nlohmann::ordered_json;

Json reference(const std::string& name) {
    return {{"$ref", "#/$defs/" + name}};
}

Json listOf(const Json& items) {
    return {{"type", "array"}, {"items", items}};
}

Json text() {
    return {{"type", "string"}};
}

Json number() {
    return {{"type", {"number", "null"}}};
}

Json size() {
    return {{"type", "integer"}, {"minimum", 0}};
}

Json outcomeSchema() {
    Json names = Json::array();
    std::string meanings;
    for (const OutcomeInfo& info : kOutcomes) {
        names.push_back(info.name);
        meanings += (meanings.empty() ? "" : "; ") + std::string(info.name) + ": " + std::string(info.meaning);
    }
    return described({{"enum", names}}, meanings);
}

Json imageSchema() {
    const Json decision = object({{"rule", described(text(), "the limit's own name")},
                                  {"metric", text()},
                                  {"limit", number()},
                                  {"value", number()}});
    const Json figures = {{"type", "object"}, {"additionalProperties", number()}};
    Json place = listOf(size());
    place["minItems"] = place["maxItems"] = 2;
    return object(
        {{"name", described(text(), "of the file below either folder, with '/'")},
         {"aov", described(text(), "empty where the name does not tell")},
         {"frame", described({{"type", "integer"}}, "0: none")},
         {"outcome", reference("outcome")},
         {"reason", text()},
         {"decision", described(decision, "the limit that decided, or the one that came nearest to deciding")},
         {"figures", described(figures, "by metric; null: not finite, as the PSNR of equal pictures")},
         {"width", described(size(), "pixels")},
         {"height", described(size(), "pixels")},
         {"channels", listOf(text())},
         {"worst", described(place, "x and y of the pixel that differs most, from the top left")}},
        std::vector<std::string>{"decision", "worst"});
}

Json columnSchema() {
    return object({{"column", described(text(), "counter or figure")},
                   {"frame", described({{"type", "integer"}}, "that differs most; 0: of the whole sequence")},
                   {"outcome", reference("outcome")},
                   {"golden", number()},
                   {"output", number()},
                   {"tolerance", described(number(), "share of the golden's value")},
                   {"reason", text()}});
}

Json budgetWithUnitSchema() {
    Json schema = budgetSchema();
    schema["properties"]["unit"] = described(text(), "of the limit and the value");
    schema["required"].push_back("unit");
    return schema;
}

}  // namespace

std::string comparisonSchema() {
    Json provenance = Json::object();
    for (const ProvenanceField& field : kProvenanceFields) provenance[field.key] = described(text(), field.doc);
    Json schema = {{"$schema", "https://json-schema.org/draft/2020-12/schema"},
                   {"title", "umbrage comparison"},
                   {"description", "What umbrage compare found, and the source of its other reports."}};
    schema.update(object(
        {{"format", {{"const", kComparisonFormat}}},
         {"passes", described({{"type", "boolean"}}, "whether the exit code was 0")},
         {"golden", described(text(), "folder or file, from the folder of this report")},
         {"output", described(text(), "the same")},
         {"goldenFrom", described(reference("provenance"), "from manifest.json beside the pictures")},
         {"outputFrom", reference("provenance")},
         {"foreignDevice", described({{"type", "boolean"}}, "allowed, and judged by the tolerance of that pair")},
         {"notes", listOf(text())},
         {"counts",
          described({{"type", "object"}, {"additionalProperties", size()}}, "images, columns and budgets by outcome")},
         {"images", listOf(reference("image"))},
         {"statistics", listOf(reference("column"))},
         {"budgets",
          described(listOf(reference("budget")), "what every frame of the output was held to; not there without any")},
         {"renderCommand", described(text(), "makes the output again")},
         {"acceptCommand", described(text(), "makes the output the golden")}},
        std::vector<std::string>{"goldenFrom", "outputFrom", "budgets"}));
    schema["$defs"] = {{"outcome", outcomeSchema()},
                       {"provenance", object(provenance)},
                       {"image", imageSchema()},
                       {"column", columnSchema()},
                       {"budget", budgetWithUnitSchema()}};
    return schema.dump(2) + "\n";
}

}  // namespace umbrage
