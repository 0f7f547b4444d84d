// SPDX-License-Identifier: Apache-2.0
#include "diagnostics/budgets_json.h"

#include "diagnostics/json_number.h"
#include "diagnostics/schema_parts.h"

namespace umbrage {

using Json = nlohmann::ordered_json;

Json budgetJson(const BudgetResult& result) {
    Json json = {{"name", result.name}, {result.atLeast ? "min" : "max", shortestNumber(result.limit)}};
    if (result.value) json["value"] = shortestNumber(*result.value);
    if (result.frame) json["frame"] = *result.frame;
    if (!result.light.empty()) json["light"] = result.light;
    json["exceeded"] = result.exceeded;
    return json;
}

BudgetResult readBudget(const JsonNode& node) {
    BudgetResult result;
    result.name = node.member("name").string();
    result.atLeast = node.has("min");
    if (result.atLeast && node.has("max")) node.fail("has both \"min\" and \"max\"");
    result.limit = node.member(result.atLeast ? "min" : "max").number();
    if (node.has("value")) result.value = node.member("value").number();
    if (node.has("frame")) result.frame = node.member("frame").integer();
    if (result.value && !result.frame) node.fail("has a value, but of no frame");
    if (node.has("light")) result.light = node.member("light").string();
    result.exceeded = node.member("exceeded").boolean();
    return result;
}

Json budgetSchema() {
    const Json text = {{"type", "string"}}, number = {{"type", "number"}}, integer = {{"type", "integer"}};
    Json budget = object({{"name", described(text, "of a counter, or QUANTITY.FIGURE")},
                          {"max", described(number, "at most this")},
                          {"min", described(number, "at least this")},
                          {"value", described(number, "the worst; not there if there is none")},
                          {"frame", described(integer, "the first with it")},
                          {"light", described(text, "whose it is, of a figure that a whole frame has not")},
                          {"exceeded", described({{"type", "boolean"}}, "also where there is no value to judge")}},
                         {"max", "min", "value", "frame", "light"});
    for (const char* limit : {"max", "min"}) budget["oneOf"].push_back({{"required", Json::array({limit})}});
    return budget;
}

}  // namespace umbrage
