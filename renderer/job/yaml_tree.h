// SPDX-License-Identifier: Apache-2.0
// YAML text as a plain tree in which every node knows its place. Refuses what makes YAML surprising: several documents,
// duplicate keys, merge keys, tags, keys that are no scalars, text that is not UTF-8, trees without bounds. What a
// scalar means is decided by the functions at the end, not by the library: only plain scalars are numbers or
// booleans, and 0010 is ten.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "job/job.h"

namespace umbrage {

struct YamlNode {
    enum class Kind : std::uint8_t { Null, Scalar, Sequence, Mapping };

    Kind kind = Kind::Null;
    bool plain = false;             // scalar without quotes
    std::string scalar{};           // a scalar's text
    std::vector<YamlNode> keys{};   // mapping: scalars, as many as items, all different
    std::vector<YamlNode> items{};  // sequence: the elements; mapping: the values
    Place place{};

    bool isScalar() const { return kind == Kind::Scalar; }
    bool isSequence() const { return kind == Kind::Sequence; }
    bool isMapping() const { return kind == Kind::Mapping; }

    /// A mapping's value; null if there is none or this is no mapping.
    const YamlNode* find(std::string_view key) const;
    YamlNode* find(std::string_view key);
};

/// A whole file. @throws Error(Input)
std::string contentsOf(const std::filesystem::path& file);

/// @param name  of the file, for places
/// @throws Error(Input) with file:line:column
YamlNode parseYaml(const std::string& text, const std::string& name);

/// The value of an override: all of its nodes stand at `place`, and it may be empty (Null).
/// @throws Error(Input) with that place
YamlNode parseYamlValue(const std::string& text, const Place& place);

/// Throws Error(Input) at the node's place.
[[noreturn]] void refuse(const YamlNode& node, const std::string& message, const std::string& hint = {});

/// The scalar's meaning, or nothing. Decimal only; finite and within the range of float.
std::optional<double> numberOf(const YamlNode& node);
std::optional<long long> integerOf(const YamlNode& node);
/// true, yes, on; false, no, off
std::optional<bool> booleanOf(const YamlNode& node);
/// Quoted, or plain and neither a number nor true or false.
std::optional<std::string> stringOf(const YamlNode& node);

/// The node in a few words for a message: `12`, `"abc"`, `a list`, `nothing`.
std::string describe(const YamlNode& node);

}  // namespace umbrage
