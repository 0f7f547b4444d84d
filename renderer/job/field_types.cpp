// SPDX-License-Identifier: Apache-2.0
#include "job/field_types.h"

#include <fmt/ranges.h>

#include <cmath>

#include "diagnostics/json_number.h"

namespace umbrage {
namespace {

std::string described(const std::string& noun, const Limits& limits) {
    const bool least = std::isfinite(limits.least), most = std::isfinite(limits.most);
    const auto bound = [](bool excluded, const char* open, const char* closed, double value) {
        return fmt::format("{} {}", excluded ? open : closed, value);
    };
    std::string words = noun;
    if (least && most && !limits.leastExcluded && !limits.mostExcluded)
        return words + fmt::format(" from {} to {}", limits.least, limits.most);
    if (least) words += bound(limits.leastExcluded, " above", " of at least", limits.least);
    if (least && most) words += " and";
    if (most) words += bound(limits.mostExcluded, " below", " of at most", limits.most);
    return words;
}

template <class T>
std::string anyOf(const std::vector<T>& values) {
    return fmt::format("{}{}", values.size() == 1 ? "" : "one of ", fmt::join(values, ", "));
}

Json limited(const char* type, const Limits& limits) {
    Json schema = {{"type", type}};
    if (std::isfinite(limits.least))
        schema[limits.leastExcluded ? "exclusiveMinimum" : "minimum"] = shortestNumber(limits.least);
    if (std::isfinite(limits.most))
        schema[limits.mostExcluded ? "exclusiveMaximum" : "maximum"] = shortestNumber(limits.most);
    return schema;
}

bool within(double value, const Limits& limits) {
    return (limits.leastExcluded ? value > limits.least : value >= limits.least) &&
           (limits.mostExcluded ? value < limits.most : value <= limits.most);
}

// Why something that looks like a number is none.
std::string numberHint(const YamlNode& node) {
    if (!node.isScalar()) return {};
    if (!node.plain) return "numbers are written without quotes";
    return "numbers are decimal and finite, such as 12, -0.5 or 1e-3";
}

}  // namespace

const char* const kNumberPattern = "^[-+]?(\\.[0-9]+|[0-9]+(\\.[0-9]*)?)([eE][-+]?[0-9]+)?$";

Type<double> number(const Limits& limits) {
    Type<double> type{.text = described("a number", limits), .schema = limited("number", limits)};
    type.read = [limits, words = type.text](const YamlNode& node, const std::string& name) {
        const auto value = numberOf(node);
        if (!value) refuseType(node, name, words, numberHint(node));
        if (!within(*value, limits)) refuseType(node, name, words);
        return *value;
    };
    type.show = [](double value) { return shortestNumber(value); };
    return type;
}

Type<int> integer(const Limits& limits) {
    Type<int> type{.text = described("an integer", limits), .schema = limited("integer", limits)};
    type.read = [limits, words = type.text](const YamlNode& node, const std::string& name) {
        const auto value = integerOf(node);
        if (!value) refuseType(node, name, words, node.isScalar() && !node.plain ? numberHint(node) : "");
        if (*value < std::numeric_limits<int>::min() || *value > std::numeric_limits<int>::max() ||
            !within(static_cast<double>(*value), limits))
            refuseType(node, name, words);
        return static_cast<int>(*value);
    };
    type.show = [](int value) { return Json(value); };
    return type;
}

Type<int> oneOf(const std::vector<int>& values) {
    Type<int> type = integer();
    type.text = anyOf(values);
    type.schema = {{"enum", values}};
    type.read = [values, words = type.text](const YamlNode& node, const std::string& name) {
        const auto value = integerOf(node);
        const auto at = value ? std::find(values.begin(), values.end(), *value) : values.end();
        if (at == values.end()) refuseType(node, name, words);
        return *at;
    };
    return type;
}

Type<bool> boolean() {
    Type<bool> type{.text = "true or false", .schema = {{"enum", {true, false, "yes", "no", "on", "off"}}}};
    type.read = [words = type.text](const YamlNode& node, const std::string& name) {
        const auto value = booleanOf(node);
        if (!value) refuseType(node, name, words);
        return *value;
    };
    type.show = [](bool value) { return Json(value); };
    return type;
}

Type<std::string> text(const std::string& what) {
    Type<std::string> type{.text = what, .schema = {{"type", "string"}, {"minLength", 1}}};
    type.read = [what](const YamlNode& node, const std::string& name) {
        const auto value = stringOf(node);
        if (!value) refuseType(node, name, what, node.isScalar() ? "quote it if it is meant as a string" : "");
        if (value->empty()) refuseType(node, name, what);
        return *value;
    };
    type.show = [](const std::string& value) { return value.empty() ? Json() : Json(value); };
    return type;
}

Type<std::string> nameOrIndex() {
    Type<std::string> type{.text = "a name, or an index from 0 on",
                           .schema = {{"type", {"string", "integer"}}, {"minLength", 1}, {"minimum", 0}}};
    type.read = [words = type.text](const YamlNode& node, const std::string& name) {
        if (const auto index = integerOf(node); index && *index >= 0) return std::to_string(*index);
        const auto value = stringOf(node);
        if (!value || value->empty()) refuseType(node, name, words);
        return *value;
    };
    type.show = [](const std::string& value) { return value.empty() ? Json() : Json(value); };
    return type;
}

Type<std::string> choice(const std::vector<std::string>& names) {
    Type<std::string> type{.text = anyOf(names), .schema = {{"enum", names}}};
    type.read = [names, words = type.text](const YamlNode& node, const std::string& name) {
        const auto value = stringOf(node);
        if (!value) refuseType(node, name, words);
        if (std::find(names.begin(), names.end(), *value) == names.end())
            refuseType(node, name, words, hintForName(*value, names));
        return *value;
    };
    type.show = [](const std::string& value) { return Json(value); };
    return type;
}

Type<FrameRange> frameRange() {
    Type<FrameRange> type{.text = "frames: A, A-B, A-BxS, or several with commas or as a list"};
    const Json one = {{"type", "string"},
                      {"pattern", "^ *-?[0-9]+(--?[0-9]+(x[0-9]+)?)?( *, *-?[0-9]+(--?[0-9]+(x[0-9]+)?)?)* *$"}};
    const Json frame = {{"type", "integer"}};
    const Json list = {{"type", "array"}, {"minItems", 1}, {"items", {{"anyOf", {frame, one}}}}};
    type.schema = {{"anyOf", {frame, one, list}}};
    type.read = [words = type.text](const YamlNode& node, const std::string& name) {
        if (node.isScalar()) return FrameRange::parse(node.scalar, node.place.text());
        if (!node.isSequence() || node.items.empty()) refuseType(node, name, words);
        std::string joined;
        for (const YamlNode& item : node.items) {
            if (!item.isScalar()) refuseType(item, "an entry of " + name, "a frame or a range such as 1-48");
            FrameRange::parse(item.scalar, item.place.text());  // for the place of what is wrong
            joined += (joined.empty() ? "" : ",") + item.scalar;
        }
        return FrameRange::parse(joined, node.place.text());
    };
    type.show = [](const FrameRange& range) { return Json(range.text()); };
    return type;
}

std::vector<std::pair<double, const YamlNode*>> timeSamples(const YamlNode& node, const std::string& name) {
    if (node.items.empty()) refuse(node, "the time samples of " + name + " are empty", "write {0: value, 2: value}");
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t i = 0; i < node.keys.size(); ++i) {
        const auto timeSeconds = numberOf(node.keys[i]);
        if (!timeSeconds)
            refuse(node.keys[i],
                   "a key of " + name + "'s time samples must be a time in seconds, not " + describe(node.keys[i]));
        order.emplace_back(*timeSeconds, i);
    }
    std::sort(order.begin(), order.end());
    std::vector<std::pair<double, const YamlNode*>> samples;
    for (std::size_t i = 0; i < order.size(); ++i) {
        const auto [timeSeconds, at] = order[i];
        if (i > 0 && static_cast<float>(timeSeconds) == static_cast<float>(order[i - 1].first))
            refuse(node.keys[at], "two time samples of " + name + " are at the same time",
                   "the other one is at " + node.keys[order[i - 1].second].place.text());
        samples.emplace_back(timeSeconds, &node.items[at]);
    }
    return samples;
}

}  // namespace umbrage
