// SPDX-License-Identifier: Apache-2.0
// Strict reading of the JSON files that umbrage writes.
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>

#include "error.h"

namespace umbrage {

/// A value and where it stands: errors name the file and the value's JSON pointer.
class JsonNode {
public:
    using Json = nlohmann::ordered_json;

    /// Both must outlive the node.
    JsonNode(const Json& json, const std::string& file) : json_(json), file_(file) {}

    [[noreturn]] void fail(const std::string& message, const std::string& hint = {}) const {
        throw Error(ErrorKind::Input, pointer_.empty() ? file_ : file_ + ": " + pointer_, message, hint);
    }

    const Json& json() const { return json_; }

    JsonNode member(const std::string& name) const {
        requireObject();
        if (!json_.contains(name)) fail(fmt::format("\"{}\" is missing", name));
        return child(json_[name], name);
    }

    bool has(const char* name) const {
        requireObject();
        return json_.contains(name);
    }

    /// visit(name, node) for each member, in the file's order.
    template <class Visit>
    void eachMember(const Visit& visit) const {
        requireObject();
        for (const auto& [name, value] : json_.items()) visit(name, child(value, name));
    }

    template <class Visit>
    void eachElement(const Visit& visit) const {
        if (!json_.is_array()) failType("an array");
        for (std::size_t i = 0; i < json_.size(); ++i) visit(child(json_[i], std::to_string(i)));
    }

    std::string string() const {
        if (!json_.is_string()) failType("a string");
        return json_.get<std::string>();
    }

    double number() const {
        if (!json_.is_number()) failType("a number");
        return json_.get<double>();
    }

    std::uint64_t count() const {
        if (!json_.is_number_unsigned()) failType("a whole number that is not negative");
        return json_.get<std::uint64_t>();
    }

    bool boolean() const {
        if (!json_.is_boolean()) failType("true or false");
        return json_.get<bool>();
    }

    int integer() const {
        if (!json_.is_number_integer()) failType("a whole number");
        const auto value = json_.get<std::int64_t>();
        if (value < std::numeric_limits<int>::min() || value > std::numeric_limits<int>::max()) {
            fail("is too large");
        }
        return static_cast<int>(value);
    }

    [[noreturn]] void failType(std::string_view wanted) const {
        fail(fmt::format("must be {}, but is {}", wanted, json_.type_name()));
    }

private:
    JsonNode(const Json& json, const std::string& file, std::string pointer)
        : json_(json), file_(file), pointer_(std::move(pointer)) {}

    JsonNode child(const Json& json, const std::string& name) const {
        return {json, file_, pointer_ + Json::json_pointer().operator/=(name).to_string()};
    }

    void requireObject() const {
        if (!json_.is_object()) failType("an object");
    }

    const Json& json_;
    const std::string& file_;
    std::string pointer_;
};

}  // namespace umbrage
