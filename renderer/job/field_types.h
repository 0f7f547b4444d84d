// SPDX-License-Identifier: Apache-2.0
// The types of single values in the table, and the combinators that make larger ones: lists, time samples, choices.
#pragma once

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <limits>
#include <span>

#include "job/field_table.h"

namespace umbrage {

struct Limits {
    double least = -std::numeric_limits<double>::infinity(), most = std::numeric_limits<double>::infinity();
    bool leastExcluded = false, mostExcluded = false;
};

inline Limits atLeast(double least) {
    return {.least = least};
}
inline Limits above(double least) {
    return {.least = least, .leastExcluded = true};
}
inline Limits between(double least, double most) {
    return {.least = least, .most = most};
}

Type<double> number(const Limits& limits = {});
Type<int> integer(const Limits& limits = {});
/// One of a few, such as 8 or 16.
Type<int> oneOf(const std::vector<int>& values);
Type<bool> boolean();
/// Not empty; a plain number, true and false must be quoted.
Type<std::string> text(const std::string& what = "a string");
/// A name, or an index from 0 on, which is kept as its digits.
Type<std::string> nameOrIndex();
Type<std::string> choice(const std::vector<std::string>& names);
/// A range as FrameRange::parse() has it, or a list of such.
Type<FrameRange> frameRange();

/// From a type to another; `show` goes back for the default.
template <class B, class A, class Make, class Show>
Type<B> converted(const Type<A>& from, Make make, Show show) {
    Type<B> type{.text = from.text, .schema = from.schema, .pages = from.pages};
    type.read = [read = from.read, make](const YamlNode& node, const std::string& name) -> B {
        return make(read(node, name), node);
    };
    type.show = [back = from.show, show](const B& value) { return back(show(value)); };
    return type;
}

template <class B, class A, class Make>
Type<B> converted(const Type<A>& from, Make make) {
    Type<B> type = converted<B>(from, make, [](const B&) { return A{}; });
    type.show = [](const B&) { return Json(); };
    return type;
}

template <class T>
Type<Located<T>> located(const Type<T>& from) {
    return converted<Located<T>>(
        from,
        [](T value, const YamlNode& node) {
            return Located<T>{std::move(value), node.place};
        },
        [](const Located<T>& value) { return value.value; });
}

template <class E>
Type<E> choiceOf(const std::vector<std::pair<std::string, E>>& choices) {
    std::vector<std::string> names;
    for (const auto& [name, value] : choices) names.push_back(name);
    return converted<E>(
        choice(names),
        [choices](const std::string& name, const YamlNode&) {
            return std::find_if(choices.begin(), choices.end(), [&](const auto& c) { return c.first == name; })->second;
        },
        [choices](E value) {
            return std::find_if(choices.begin(), choices.end(), [&](const auto& c) { return c.second == value; })
                ->first;
        });
}

/// Any length.
template <class T>
Type<std::vector<T>> listOf(const Type<T>& element, const std::string& what) {
    Type<std::vector<T>> type{
        .text = what, .schema = {{"type", "array"}, {"items", element.schema}}, .pages = element.pages};
    type.read = [read = element.read, what](const YamlNode& node, const std::string& name) {
        if (!node.isSequence()) refuseType(node, name, what, "write [a, b] or one \"- \" line for each");
        std::vector<T> made;
        for (const YamlNode& item : node.items) made.push_back(read(item, "an entry of " + name));
        return made;
    };
    type.show = [show = element.show](const std::vector<T>& values) {
        Json list = Json::array();
        for (const T& value : values) list.push_back(show(value));
        return list;
    };
    return type;
}

/// Exactly N, as a list.
template <std::size_t N, class T>
Type<std::array<T, N>> arrayOf(const Type<T>& element, const std::string& what) {
    Type<std::array<T, N>> type = converted<std::array<T, N>>(
        listOf(element, what),
        [](const std::vector<T>& values, const YamlNode& node) {
            if (values.size() != N) refuse(node, fmt::format("expected {} values, not {}", N, values.size()));
            std::array<T, N> made{};
            std::copy(values.begin(), values.end(), made.begin());
            return made;
        },
        [](const std::array<T, N>& values) { return std::vector<T>(values.begin(), values.end()); });
    type.schema["minItems"] = type.schema["maxItems"] = N;
    return type;
}

/// A mapping whose keys are names of the user's (or, when `known` is not empty, some of those).
template <class T>
Type<std::vector<std::pair<Located<std::string>, T>>> dictionary(const Type<T>& value, const std::string& what,
                                                                 const std::vector<std::string>& known = {}) {
    using Entries = std::vector<std::pair<Located<std::string>, T>>;
    Type<Entries> type{.text = what, .schema = {{"type", "object"}}, .pages = value.pages};
    if (!known.empty()) type.schema["propertyNames"] = {{"enum", known}};
    type.schema["additionalProperties"] = value.schema;
    type.read = [read = value.read, what, known](const YamlNode& node, const std::string& name) {
        if (!node.isMapping()) refuseType(node, name, what);
        Entries made;
        for (std::size_t i = 0; i < node.keys.size(); ++i) {
            const YamlNode& key = node.keys[i];
            if (!known.empty() && std::find(known.begin(), known.end(), key.scalar) == known.end())
                refuse(key, "unknown name " + describe(key) + " in " + name, hintForName(key.scalar, known));
            made.emplace_back(Located<std::string>{key.scalar, key.place}, read(node.items[i], key.scalar));
        }
        return made;
    };
    type.show = [show = value.show](const Entries& entries) {
        Json object = Json::object();
        for (const auto& [key, entry] : entries) object[key.value] = show(entry);
        return object;
    };
    return type;
}

/// The same into a std::map.
template <class T>
Type<std::map<std::string, T>> mapOf(const Type<T>& value, const std::string& what,
                                     const std::vector<std::string>& known = {}) {
    using Entries = std::vector<std::pair<Located<std::string>, T>>;
    return converted<std::map<std::string, T>>(
        dictionary(value, what, known),
        [](const Entries& entries, const YamlNode&) {
            std::map<std::string, T> made;
            for (const auto& [key, entry] : entries) made[key.value] = entry;
            return made;
        },
        [](const std::map<std::string, T>& values) {
            Entries entries;
            for (const auto& [key, entry] : values) entries.emplace_back(Located<std::string>{key, {}}, entry);
            return entries;
        });
}

/// One of two forms of the same thing, told apart by `isFirst`; shown in the first form.
template <class T>
Type<T> either(const Type<T>& first, const Type<T>& second, bool (*isFirst)(const YamlNode&)) {
    Type<T> type{.text = first.text + ", or " + second.text,
                 .schema = {{"oneOf", {first.schema, second.schema}}},
                 .pages = first.pages,
                 .show = first.show};
    type.pages.insert(type.pages.end(), second.pages.begin(), second.pages.end());
    type.read = [a = first.read, b = second.read, isFirst, both = type.text](const YamlNode& node,
                                                                             const std::string& name) {
        if (!isFirst(node) && !node.isMapping()) refuseType(node, name, both);
        return isFirst(node) ? a(node, name) : b(node, name);
    };
    return type;
}

/// Time samples {seconds: value, ...}, brought into ascending order.
/// @throws Error(Input) for none, for keys that are no times, and for two at the same time (as float, which tracks use)
std::vector<std::pair<double, const YamlNode*>> timeSamples(const YamlNode& node, const std::string& name);

/// What the keys of time samples look like, for the schema.
extern const char* const kNumberPattern;

template <std::size_t N>
Type<Sampled<N>> sampled(const Type<std::array<double, N>>& constant) {
    Type<Sampled<N>> type{.text = constant.text + ", or time samples {seconds: value, ...}"};
    const Json samples = {{"type", "object"},
                          {"minProperties", 1},
                          {"patternProperties", {{kNumberPattern, constant.schema}}},
                          {"additionalProperties", false}};
    type.schema = {{"oneOf", {constant.schema, samples}}};
    type.read = [read = constant.read](const YamlNode& node, const std::string& name) {
        Sampled<N> made;
        made.place = node.place;
        if (!node.isMapping()) {
            made.values = {read(node, name)};
            return made;
        }
        for (const auto& [timeSeconds, value] : timeSamples(node, name)) {
            made.timesSeconds.push_back(timeSeconds);
            made.values.push_back(read(*value, name));
        }
        return made;
    };
    type.show = [show = constant.show](const Sampled<N>& value) { return show(value.values.front()); };
    return type;
}

}  // namespace umbrage
