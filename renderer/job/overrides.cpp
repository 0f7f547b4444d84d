// SPDX-License-Identifier: Apache-2.0
#include "job/overrides.h"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <span>

#include "error.h"

namespace umbrage {
namespace {

std::vector<std::string> segmentsOf(const std::string& path) {
    std::vector<std::string> segments(1);
    bool quoted = false;
    for (const char c : path) {
        if (c == '"')
            quoted = !quoted;
        else if (c == '.' && !quoted)
            segments.emplace_back();
        else
            segments.back() += c;
    }
    return segments;
}

std::string joined(std::span<const std::string> segments) {
    return fmt::format("{}", fmt::join(segments, "."));
}

YamlNode& element(YamlNode& list, const std::string& segment, const Place& place) {
    std::size_t index = 0;
    const auto [end, status] = std::from_chars(segment.data(), segment.data() + segment.size(), index);
    const bool isIndex = status == std::errc{} && end == segment.data() + segment.size();
    if (!isIndex || index >= list.items.size())
        throw Error(ErrorKind::Input, place.text(),
                    fmt::format("\"{}\" is not an entry of a list of {}", segment, list.items.size()),
                    list.items.empty() ? "the list is empty" : fmt::format("0 to {}", list.items.size() - 1));
    return list.items[index];
}

// The value of the longest key that the next segments spell; made from one segment where there is none.
YamlNode& member(YamlNode& mapping, std::span<const std::string>& segments, const Place& place) {
    for (std::size_t count = segments.size(); count > 0; --count) {
        if (YamlNode* value = mapping.find(joined(segments.first(count)))) {
            segments = segments.subspan(count);
            return *value;
        }
    }
    // A new key stands in the override, so that an unknown one is reported there.
    mapping.keys.push_back({.kind = YamlNode::Kind::Scalar, .plain = true, .scalar = segments.front(), .place = place});
    mapping.items.push_back({.place = place});
    segments = segments.subspan(1);
    if (!segments.empty()) mapping.items.back().kind = YamlNode::Kind::Mapping;
    return mapping.items.back();
}

}  // namespace

void applyOverride(YamlNode& root, const std::string& assignment, const std::string& option) {
    const auto equals = assignment.find('=');
    const std::string path = assignment.substr(0, equals);
    const Place place{option.empty() ? "--set " + path : option, 0, 0};
    const std::vector<std::string> all = segmentsOf(path);
    if (equals == std::string::npos || std::find(all.begin(), all.end(), "") != all.end())
        throw Error(ErrorKind::Usage, place.text(), "this is not an assignment",
                    "write path=value, such as shadow.count=z-fail or lights.0.intensity=40");

    YamlNode* node = &root;
    for (std::span<const std::string> rest = all; !rest.empty();) {
        const std::size_t done = all.size() - rest.size();
        if (node->isSequence()) {
            node = &element(*node, rest.front(), place);
            rest = rest.subspan(1);
        } else if (node->isMapping()) {
            node = &member(*node, rest, place);
        } else {
            const std::string parent = done == 0 ? "the file" : joined(std::span(all).first(done));
            throw Error(ErrorKind::Input, place.text(),
                        fmt::format("{} is {} here, which has no \"{}\"", parent, describe(*node), joined(rest)),
                        fmt::format("set {} as a whole", parent));
        }
    }
    *node = parseYamlValue(assignment.substr(equals + 1), place);
}

}  // namespace umbrage
