// SPDX-License-Identifier: Apache-2.0
// A value in a glTF document together with its place. Every reading is checked, and whatever is wrong becomes an
// Error at "file: /json/pointer", so that the validator reads like the specification's tables.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace umbrage {

/// @throws Error(Input) at "file: pointer", always
[[noreturn]] void failAt(const std::string& file, const std::string& pointer, const std::string& message,
                         const std::string& hint = {});

/// A name from the file as it may appear in a message: quoted, without control characters, not endless.
std::string inQuotes(std::string_view name);

class JsonView {
public:
    /// `file` and `value` must outlive the view and all views made from it.
    JsonView(const nlohmann::json& value, const std::string& file, std::string pointer)
        : value_(&value), file_(&file), pointer_(std::move(pointer)) {}

    const std::string& pointer() const { return pointer_; }
    const nlohmann::json& value() const { return *value_; }

    // Objects. All are an Error unless this is one.
    bool has(const char* key) const;
    std::optional<JsonView> find(const std::string& key) const;
    JsonView at(const std::string& key) const;
    std::vector<std::pair<std::string, JsonView>> members() const;
    /// The extension object of that name, when there is one.
    std::optional<JsonView> extension(const std::string& name) const;

    // Arrays
    std::vector<JsonView> items() const;
    /// The elements of the array named `key`, each of them an object; none when it is absent.
    std::vector<JsonView> objects(const std::string& key) const;
    /// Finite numbers, exactly `count` of them.
    std::vector<double> numbers(std::size_t count) const;

    // Scalars
    const std::string& text() const;
    bool flag() const;
    double number() const;  // finite
    double number(const std::string& key, double otherwise) const;
    std::uint64_t integer(std::uint64_t smallest, std::uint64_t largest) const;
    std::uint64_t integer(const std::string& key, std::uint64_t otherwise, std::uint64_t largest) const;
    /// An index of one of `count` things, called `noun` in the message.
    std::size_t index(std::size_t count, std::string_view noun) const;
    /// The same of a member; none when it is absent.
    std::optional<std::size_t> index(const std::string& key, std::size_t count, std::string_view noun) const;

    [[noreturn]] void fail(const std::string& message, const std::string& hint = {}) const;

private:
    JsonView child(const nlohmann::json& value, std::string_view token) const;
    void requireObject() const;
    [[noreturn]] void failType(std::string_view wanted) const;

    const nlohmann::json* value_;
    const std::string* file_;
    std::string pointer_;
};

}  // namespace umbrage
