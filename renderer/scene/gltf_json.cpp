// SPDX-License-Identifier: Apache-2.0
#include "scene/gltf_json.h"

#include <fmt/format.h>

#include <cmath>

#include "error.h"

namespace umbrage {

void failAt(const std::string& file, const std::string& pointer, const std::string& message, const std::string& hint) {
    throw Error(ErrorKind::Input, pointer.empty() ? file : file + ": " + pointer, message, hint);
}

std::string inQuotes(std::string_view name) {
    constexpr std::size_t kLongest = 80;
    std::string result = "\"";
    for (const char c : name.substr(0, kLongest)) {
        result += static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? '?' : c;
    }
    return result + (name.size() > kLongest ? "...\"" : "\"");
}

namespace {

// RFC 6901 spells '~' and '/' inside a token as "~0" and "~1".
std::string pointerToken(std::string_view key) {
    std::string token;
    for (const char c : key) {
        if (c == '~') {
            token += "~0";
        } else if (c == '/') {
            token += "~1";
        } else {
            token += c;
        }
    }
    return token;
}

}  // namespace

JsonView JsonView::child(const nlohmann::json& value, std::string_view token) const {
    return {value, *file_, fmt::format("{}/{}", pointer_, token)};
}

void JsonView::fail(const std::string& message, const std::string& hint) const {
    failAt(*file_, pointer_, message, hint);
}

void JsonView::failType(std::string_view wanted) const {
    fail(fmt::format("must be {}, but is of type {}", wanted, value_->type_name()));
}

void JsonView::requireObject() const {
    if (!value_->is_object()) {
        failType("an object");
    }
}

bool JsonView::has(const char* key) const {
    requireObject();
    return value_->contains(key);
}

std::optional<JsonView> JsonView::find(const std::string& key) const {
    requireObject();
    const auto found = value_->find(key);
    if (found == value_->end()) {
        return std::nullopt;
    }
    return child(*found, pointerToken(key));
}

JsonView JsonView::at(const std::string& key) const {
    if (auto found = find(key)) {
        return *std::move(found);
    }
    fail(fmt::format("the required property \"{}\" is missing", key));
}

std::vector<std::pair<std::string, JsonView>> JsonView::members() const {
    requireObject();
    std::vector<std::pair<std::string, JsonView>> result;
    for (const auto& [key, value] : value_->items()) {
        result.emplace_back(key, child(value, pointerToken(key)));
    }
    return result;
}

std::optional<JsonView> JsonView::extension(const std::string& name) const {
    const auto extensions = find("extensions");
    auto found = extensions ? extensions->find(name) : std::nullopt;
    if (found) {
        found->requireObject();
    }
    return found;
}

std::vector<JsonView> JsonView::items() const {
    if (!value_->is_array()) {
        failType("an array");
    }
    std::vector<JsonView> result;
    result.reserve(value_->size());
    for (std::size_t i = 0; i < value_->size(); ++i) {
        result.push_back(child((*value_)[i], std::to_string(i)));
    }
    return result;
}

std::vector<JsonView> JsonView::objects(const std::string& key) const {
    const auto array = find(key);
    if (!array) {
        return {};
    }
    auto result = array->items();
    for (const JsonView& element : result) {
        element.requireObject();
    }
    return result;
}

std::vector<double> JsonView::numbers(std::size_t count) const {
    const auto elements = items();
    if (elements.size() != count) {
        fail(fmt::format("must have {} numbers, but has {}", count, elements.size()));
    }
    std::vector<double> result;
    result.reserve(count);
    for (const JsonView& element : elements) {
        result.push_back(element.number());
    }
    return result;
}

const std::string& JsonView::text() const {
    if (!value_->is_string()) {
        failType("a string");
    }
    return value_->get_ref<const std::string&>();
}

bool JsonView::flag() const {
    if (!value_->is_boolean()) {
        failType("true or false");
    }
    return value_->get<bool>();
}

double JsonView::number() const {
    if (!value_->is_number()) {
        failType("a number");
    }
    const auto result = value_->get<double>();
    // The values end up as floats, and a float's infinity is as bad as a double's. Half a unit beyond the largest
    // float, numbers begin to round to infinity; exporters write that float with few digits, which may be a little
    // more.
    constexpr double kRoundsToInfinity = 3.4028235677973366e38;
    if (!(std::abs(result) < kRoundsToInfinity)) {
        fail(fmt::format("{} is not a number that a float can hold", result));
    }
    return result;
}

double JsonView::number(const std::string& key, double otherwise) const {
    const auto found = find(key);
    return found ? found->number() : otherwise;
}

std::uint64_t JsonView::integer(std::uint64_t smallest, std::uint64_t largest) const {
    // glTF wants integers written without a fraction; tinygltf silently takes the default for 1.0.
    if (!value_->is_number_integer()) {
        failType("an integer");
    }
    const bool negative = !value_->is_number_unsigned() && value_->get<std::int64_t>() < 0;
    const auto result = value_->get<std::uint64_t>();
    if (negative || result < smallest || result > largest) {
        fail(fmt::format("must be an integer from {} to {}, but is {}", smallest, largest, value_->dump()));
    }
    return result;
}

std::uint64_t JsonView::integer(const std::string& key, std::uint64_t otherwise, std::uint64_t largest) const {
    const auto found = find(key);
    return found ? found->integer(0, largest) : otherwise;
}

std::size_t JsonView::index(std::size_t count, std::string_view noun) const {
    if (!value_->is_number_integer()) {
        failType("an integer");
    }
    if ((!value_->is_number_unsigned() && value_->get<std::int64_t>() < 0) || value_->get<std::uint64_t>() >= count) {
        fail(fmt::format("names {} {}, but the file has {} of them", noun, value_->dump(), count));
    }
    return value_->get<std::size_t>();
}

std::optional<std::size_t> JsonView::index(const std::string& key, std::size_t count, std::string_view noun) const {
    const auto found = find(key);
    return found ? std::optional(found->index(count, noun)) : std::nullopt;
}

}  // namespace umbrage
