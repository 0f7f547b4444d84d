// SPDX-License-Identifier: Apache-2.0
// The part of JSON Schema 2020-12 that our schemas use.
#pragma once

#include <gmock/gmock.h>
#include <regex.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

namespace umbrage {

class SchemaCheck {
public:
    using Json = nlohmann::ordered_json;

    /// @param root  what "#/..." points into
    explicit SchemaCheck(const Json& root) : root_(root) {}

    /// Fails the test on a keyword it does not know.
    bool valid(const Json& schema, const Json& value) const {
        const auto count = [&](const char* key) {
            return std::count_if(schema[key].begin(), schema[key].end(),
                                 [&](const Json& s) { return valid(s, value); });
        };
        for (const auto& [keyword, limit] : schema.items()) {
            bool good = true;
            if (keyword == "type")
                good = limit.is_string() ? hasType(value, limit)
                                         : std::any_of(limit.begin(), limit.end(),
                                                       [&](const Json& type) { return hasType(value, type); });
            else if (keyword == "$ref")
                good = valid(root_.at(Json::json_pointer(limit.get<std::string>().substr(1))), value);
            else if (keyword == "const")
                good = value == limit;
            else if (keyword == "enum")
                good = std::find(limit.begin(), limit.end(), value) != limit.end();
            else if (keyword == "oneOf")
                good = count("oneOf") == 1;
            else if (keyword == "anyOf")
                good = count("anyOf") > 0;
            else if (keyword == "minimum")
                good = !value.is_number() || value >= limit;
            else if (keyword == "maximum")
                good = !value.is_number() || value <= limit;
            else if (keyword == "exclusiveMinimum")
                good = !value.is_number() || value > limit;
            else if (keyword == "exclusiveMaximum")
                good = !value.is_number() || value < limit;
            else if (keyword == "minLength")
                good = !value.is_string() || value.get<std::string>().size() >= limit;
            else if (keyword == "pattern")
                good = !value.is_string() || matches(value, limit);
            else if (keyword == "minItems")
                good = !value.is_array() || value.size() >= limit;
            else if (keyword == "maxItems")
                good = !value.is_array() || value.size() <= limit;
            else if (keyword == "minProperties")
                good = !value.is_object() || value.size() >= limit;
            else if (keyword == "prefixItems")
                good = !value.is_array() || validPrefix(limit, value);
            else if (keyword == "items")
                good = !value.is_array() ||
                       std::all_of(value.begin(), value.end(), [&](const Json& item) { return valid(limit, item); });
            else if (keyword == "required")
                good = std::all_of(limit.begin(), limit.end(),
                                   [&](const Json& key) { return value.contains(key.get<std::string>()); });
            else if (keyword == "properties")
                good = !value.is_object() || validMembers(schema, value);
            else if (keyword == "patternProperties" || keyword == "propertyNames" || keyword == "additionalProperties")
                good = schema.contains("properties") || !value.is_object() || validMembers(schema, value);
            else
                EXPECT_THAT(keyword, testing::AnyOf("$schema", "$defs", "title", "description", "default"));
            if (!good) return false;
        }
        return true;
    }

private:
    static bool hasType(const Json& value, const std::string& type) {
        if (type == "object") return value.is_object();
        if (type == "array") return value.is_array();
        if (type == "string") return value.is_string();
        if (type == "integer") return value.is_number_integer();
        if (type == "boolean") return value.is_boolean();
        if (type == "number") return value.is_number();
        if (type == "boolean") return value.is_boolean();
        if (type == "null") return value.is_null();
        ADD_FAILURE() << "the schema has the type " << type << ", which this test does not know";
        return false;
    }

    // Our patterns mean the same as POSIX extended ones; std::regex does not compile without warnings under sanitizers.
    static bool matches(const std::string& text, const std::string& pattern) {
        regex_t compiled;
        if (regcomp(&compiled, pattern.c_str(), REG_EXTENDED | REG_NOSUB) != 0) throw std::runtime_error(pattern);
        const bool found = regexec(&compiled, text.c_str(), 0, nullptr, 0) == 0;
        regfree(&compiled);
        return found;
    }

    bool validPrefix(const Json& schemas, const Json& array) const {
        for (std::size_t i = 0; i < std::min(schemas.size(), array.size()); ++i) {
            if (!valid(schemas[i], array[i])) return false;
        }
        return true;
    }

    bool validMembers(const Json& schema, const Json& object) const {
        const Json none = Json::object();
        const Json& properties = schema.contains("properties") ? schema["properties"] : none;
        const Json& patterns = schema.contains("patternProperties") ? schema["patternProperties"] : none;
        for (const auto& [key, member] : object.items()) {
            bool known = false;
            if (properties.contains(key)) {
                known = true;
                if (!valid(properties[key], member)) return false;
            }
            for (const auto& [pattern, inner] : patterns.items()) {
                if (!matches(key, pattern)) continue;
                known = true;
                if (!valid(inner, member)) return false;
            }
            if (known || !schema.contains("additionalProperties")) continue;
            const Json& others = schema["additionalProperties"];
            if (others.is_boolean() ? !others.get<bool>() : !valid(others, member)) return false;
            if (schema.contains("propertyNames") && !valid(schema["propertyNames"], key)) return false;
        }
        return true;
    }

    const Json& root_;
};

inline bool validates(const nlohmann::ordered_json& schema, const nlohmann::ordered_json& value) {
    return SchemaCheck(schema).valid(schema, value);
}

}  // namespace umbrage
