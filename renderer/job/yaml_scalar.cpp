// SPDX-License-Identifier: Apache-2.0
// What a scalar means: YAML 1.2's core schema without hexadecimal, octal, .inf and .nan, plus the words for booleans.
#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "error.h"
#include "job/yaml_tree.h"

namespace umbrage {
namespace {

std::string_view withoutPlus(std::string_view text) {
    if (text.starts_with('+') && text.size() > 1 && text[1] != '-' && text[1] != '+') text.remove_prefix(1);
    return text;
}

// The whole text must be the number.
template <class T>
std::optional<T> wholeNumber(std::string_view text) {
    T value{};
    const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (status != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return value;
}

std::optional<double> numberOf(const std::string& plain) {
    if (plain.find_first_not_of("0123456789+-.eE") != std::string::npos) return std::nullopt;  // inf, nan
    const auto value = wholeNumber<double>(withoutPlus(plain));
    if (!value || std::abs(*value) > std::numeric_limits<float>::max()) return std::nullopt;
    return value;
}

constexpr std::size_t kLongestShown = 60;

std::string shortened(const std::string& text) {
    if (text.size() <= kLongestShown) return text;
    std::size_t end = kLongestShown;
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0u) == 0x80u) --end;  // not within a character
    return text.substr(0, end) + "...";
}

}  // namespace

void refuse(const YamlNode& node, const std::string& message, const std::string& hint) {
    throw Error(ErrorKind::Input, node.place.text(), message, hint);
}

std::optional<double> numberOf(const YamlNode& node) {
    if (!node.isScalar() || !node.plain) return std::nullopt;
    return numberOf(node.scalar);
}

std::optional<long long> integerOf(const YamlNode& node) {
    if (!node.isScalar() || !node.plain) return std::nullopt;
    return wholeNumber<long long>(withoutPlus(node.scalar));
}

std::optional<bool> booleanOf(const YamlNode& node) {
    if (!node.isScalar() || !node.plain) return std::nullopt;
    if (node.scalar == "true" || node.scalar == "yes" || node.scalar == "on") return true;
    if (node.scalar == "false" || node.scalar == "no" || node.scalar == "off") return false;
    return std::nullopt;
}

std::optional<std::string> stringOf(const YamlNode& node) {
    if (!node.isScalar()) return std::nullopt;
    if (node.plain && (numberOf(node.scalar) || node.scalar == "true" || node.scalar == "false")) return std::nullopt;
    return node.scalar;
}

std::string describe(const YamlNode& node) {
    switch (node.kind) {
        case YamlNode::Kind::Null:
            return "nothing";
        case YamlNode::Kind::Scalar: {
            const bool bare = numberOf(node) || booleanOf(node);
            std::string text = shortened(node.scalar);
            std::replace(text.begin(), text.end(), '\n', ' ');
            return bare ? text : fmt::format("\"{}\"", text);
        }
        case YamlNode::Kind::Sequence:
            return node.items.empty() ? "an empty list" : fmt::format("a list of {}", node.items.size());
        case YamlNode::Kind::Mapping:
            return "a mapping";
    }
    return {};
}

}  // namespace umbrage
