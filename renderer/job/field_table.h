// SPDX-License-Identifier: Apache-2.0
// The machinery of the one table (job_fields.cpp): a Type<T> knows how to read a T, how an editor's schema describes
// it and how the reference page does; a Field names a place for it in a struct; mapping() makes a Type of the struct
// from its fields. Defaults are those of the struct itself, so no two of parser, schema and reference can disagree.
#pragma once

#include <algorithm>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "job/nearest.h"
#include "job/yaml_tree.h"

namespace umbrage {

using Json = nlohmann::ordered_json;

/// One mapping of the reference page.
struct ReferencePage {
    struct Row {
        std::string key, value, unit, byDefault, meaning;
    };
    std::string title, meaning;
    std::vector<Row> rows;
};

template <class T>
struct Type {
    std::string text{};  // a noun for messages and the reference: "a number above 0"
    Json schema{};
    std::vector<ReferencePage> pages{};  // of the mappings inside, outermost first
    /// @param name  what messages call the value
    std::function<T(const YamlNode& node, const std::string& name)> read{};
    std::function<Json(const T&)> show{};  // a value as the file has it; null: not worth showing
};

/// Throws Error(Input): `name` must be `expected`, not what the node is.
[[noreturn]] inline void refuseType(const YamlNode& node, const std::string& name, const std::string& expected,
                                    const std::string& hint = {}) {
    refuse(node, name + " must be " + expected + ", not " + describe(node), hint);
}

/// A key of the mapping that is read into S.
template <class S>
struct Field {
    std::string key{}, meaning{}, unit{}, byDefault{};
    bool isRequired = false;
    std::string text{};
    Json schema{};
    std::vector<ReferencePage> pages{};
    std::function<void(S&, const YamlNode&)> read{};

    Field required() && { return isRequired = true, byDefault = "required", std::move(*this); }
    Field in(std::string name) && { return unit = std::move(name), std::move(*this); }
    /// In words, where the struct's own value says nothing.
    Field unset(std::string words) && { return byDefault = std::move(words), std::move(*this); }
};

/// A value that `set` puts into S.
/// @param byDefault  what S has without it, for the schema and the reference
template <class S, class T>
Field<S> fieldThrough(const std::string& key, const Type<T>& type,
                      std::type_identity_t<std::function<void(S&, const T&)>> set, const std::string& meaning,
                      const std::optional<T>& byDefault = std::nullopt) {
    Field<S> made{.key = key, .meaning = meaning, .text = type.text, .schema = type.schema, .pages = type.pages};
    if (const Json shown = byDefault ? type.show(*byDefault) : Json(); !shown.is_null()) {
        made.schema["default"] = shown;
        made.byDefault = shown.is_string() ? shown.template get<std::string>() : shown.dump();
    }
    made.read = [key, read = type.read, set](S& into, const YamlNode& node) { set(into, read(node, key)); };
    return made;
}

/// A value that is a member of S, which also says its default.
/// @param access  a member pointer, or a function from S& to the member's reference
template <class S, class T, class Access>
Field<S> field(const std::string& key, const Type<T>& type, Access access, const std::string& meaning) {
    S defaults{};
    return fieldThrough<S, T>(
        key, type, [access](S& into, const T& value) { std::invoke(access, into) = value; }, meaning,
        std::optional<T>(std::invoke(access, defaults)));
}

/// Looks at what was read as a whole; throws with refuse().
template <class S>
using Check = std::function<void(const S&, const YamlNode&)>;

/// @param title  heading of its reference page, and what messages call it
template <class S>
Type<S> mapping(std::string title, std::string meaning, std::vector<Field<S>> fields, Check<S> check = {}) {
    Type<S> type{.text = "a mapping (" + title + ")", .schema = {{"type", "object"}}};
    type.pages.push_back({title, meaning, {}});
    Json properties = Json::object(), required = Json::array();
    for (const Field<S>& f : fields) {
        Json property = f.schema;
        property["description"] = f.meaning + (f.unit.empty() ? "" : " (" + f.unit + ")");
        properties[f.key] = property;
        if (f.isRequired) required.push_back(f.key);
        type.pages.front().rows.push_back({f.key, f.text, f.unit, f.byDefault, f.meaning});
        type.pages.insert(type.pages.end(), f.pages.begin(), f.pages.end());
    }
    type.schema["properties"] = properties;
    if (!required.empty()) type.schema["required"] = required;
    type.schema["additionalProperties"] = false;

    type.read = [fields = std::make_shared<const std::vector<Field<S>>>(std::move(fields)), title, check](
                    const YamlNode& node, const std::string& name) {
        if (!node.isMapping()) refuseType(node, name, "a mapping");
        std::vector<std::string> known;
        for (const Field<S>& f : *fields) known.push_back(f.key);
        S made{};
        for (std::size_t i = 0; i < node.keys.size(); ++i) {
            const YamlNode& key = node.keys[i];
            const auto at = std::find(known.begin(), known.end(), key.scalar);
            if (at == known.end()) {
                // {frames: 1-10,20} is what YAML takes for two keys
                const bool strayComma = node.items[i].kind == YamlNode::Kind::Null && integerOf(key);
                refuse(key, "unknown key " + describe(key) + " in " + title,
                       strayComma ? "quote a value with commas" : hintForName(key.scalar, known));
            }
            (*fields)[static_cast<std::size_t>(at - known.begin())].read(made, node.items[i]);
        }
        for (const Field<S>& f : *fields)
            if (f.isRequired && !node.find(f.key))
                refuse(node, title + " lacks the key \"" + f.key + "\"", "add " + f.key + ": " + f.text);
        if (check) check(made, node);
        return made;
    };
    type.show = [](const S&) { return Json(); };
    return type;
}

}  // namespace umbrage
