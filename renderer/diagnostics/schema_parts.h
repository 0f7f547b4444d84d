// SPDX-License-Identifier: Apache-2.0
// What the JSON Schemas of our files are made of.
#pragma once

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace umbrage {

inline nlohmann::ordered_json described(nlohmann::ordered_json schema, std::string_view description) {
    schema["description"] = description;
    return schema;
}

/// An object with these members and no others; those not named in `optional` are required.
inline nlohmann::ordered_json object(const nlohmann::ordered_json& properties,
                                     const std::vector<std::string>& optional = {}) {
    nlohmann::ordered_json required = nlohmann::ordered_json::array();
    for (const auto& [name, schema] : properties.items()) {
        if (std::find(optional.begin(), optional.end(), name) == optional.end()) required.push_back(name);
    }
    return {{"type", "object"}, {"properties", properties}, {"required", required}, {"additionalProperties", false}};
}

}  // namespace umbrage
