// SPDX-License-Identifier: Apache-2.0
// Types that several parts of the table share, and the parts themselves, each in the file of its name.
#pragma once

#include <variant>

#include "job/field_types.h"

namespace umbrage {

using Triple = std::array<double, 3>;

inline Type<Triple> triple(const std::string& what, const Limits& limits = {}) {
    return arrayOf<3>(number(limits), what);
}
inline Type<Triple> color() {
    return triple("a colour [r, g, b], linear Rec.709", atLeast(0));
}
inline Type<Triple> point() {
    return triple("a point [x, y, z]");
}

using Single = std::array<double, 1>;

inline Type<Sampled<1>> sampledNumber(const Limits& limits = {}) {
    return sampled<1>(converted<Single>(
        number(limits), [](double value, const YamlNode&) { return Single{value}; },
        [](const Single& value) { return value[0]; }));
}

inline Type<KeyInterpolation> interpolation() {
    return choiceOf<KeyInterpolation>({{"linear", KeyInterpolation::Linear}, {"step", KeyInterpolation::Step}});
}

/// Of a table of names.
template <class Entry, std::size_t N>
std::vector<std::string> namesOf(const std::array<Entry, N>& table) {
    std::vector<std::string> names;
    for (const Entry& entry : table) names.emplace_back(entry.name);
    return names;
}

/// "name (meaning); ..."
template <class Entry, std::size_t N>
std::string meaningsOf(const std::array<Entry, N>& table) {
    std::string text;
    for (const Entry& entry : table)
        text += fmt::format("{}{} ({})", text.empty() ? "" : "; ", entry.name, entry.meaning);
    return text;
}

/// Type<T> for a member that may stay empty.
template <class T>
Type<std::optional<T>> opinion(const Type<T>& type) {
    return converted<std::optional<T>>(type,
                                       [](T value, const YamlNode&) { return std::optional<T>(std::move(value)); });
}

// job_layers.cpp
using Overs = std::vector<OverLayer>;
using Layer = std::variant<GltfLayer, GeneratedLayer, Overs>;
Type<std::vector<Layer>> layers();

// job_generated.cpp
Type<GeneratedLayer> generatedLayer();

// job_golden.cpp
Type<JobGolden> goldenSettings();

// job_lights.cpp
Type<std::vector<JobLight>> extraLights();
/// What over: says about a light.
Type<LightOpinion> lightOpinion();

// job_budgets.cpp
Type<std::vector<Budget>> budgets();

// job_camera.cpp
Type<JobCamera> camera();

}  // namespace umbrage
