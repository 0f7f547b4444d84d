// SPDX-License-Identifier: Apache-2.0
// StatisticsFile from JSON. Strict: what the writer would not have written is refused with its JSON pointer.
#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "diagnostics/budgets_json.h"
#include "diagnostics/json_node.h"
#include "diagnostics/statistics_format.h"
#include "error.h"

namespace umbrage {
namespace {

using Node = JsonNode;

template <class Entries>
std::size_t indexIn(const Entries& table, const std::string& name, const char* tableName, const Node& node) {
    const auto found = std::find_if(table.begin(), table.end(), [&](const auto& entry) { return entry.name == name; });
    if (found == table.end()) node.fail(fmt::format("is not explained under /{}", tableName));
    return static_cast<std::size_t>(found - table.begin());
}

StatisticsFile::CounterEntry readCounter(const std::string& name, const Node& node) {
    StatisticsFile::CounterEntry counter;
    counter.name = name;
    counter.group = node.member("group").string();
    counter.unit = node.member("unit").string();
    counter.doc = node.member("doc").string();
    const std::string combine = node.member("combine").string();
    const auto found = std::find(kCombineNames.begin(), kCombineNames.end(), combine);
    if (found == kCombineNames.end()) {
        node.member("combine").fail(fmt::format("must be {}", fmt::join(kCombineNames, ", ")));
    }
    counter.combine = static_cast<Combine>(found - kCombineNames.begin());
    if (node.has("ratio")) {
        std::vector<std::string> parts;
        node.member("ratio").eachElement([&](const Node& part) { parts.push_back(part.string()); });
        if (parts.size() != 2) node.member("ratio").fail("must be two counters");
        counter.numerator = parts[0];
        counter.denominator = parts[1];
    }
    return counter;
}

/// The unit is the table's.
BudgetResult readBudgetOf(const StatisticsFile& file, const Node& node) {
    BudgetResult result = readBudget(node);
    const std::optional<std::string> unit = unitOfFigure(file, result.name);
    if (!unit) node.member("name").fail("is not explained under /counters or /quantities");
    result.unit = *unit;
    return result;
}

Distribution readDistribution(const Node& node) {
    std::vector<std::pair<double, std::uint64_t>> histogram;
    node.member("histogram").eachElement([&](const Node& bin) {
        if (!bin.json().is_array() || bin.json().size() != 2) bin.failType("a pair of bin start and pixels");
        std::vector<Node> pair;
        bin.eachElement([&](const Node& number) { pair.push_back(number); });
        histogram.emplace_back(pair[0].number(), pair[1].count());
    });
    try {
        Distribution distribution(histogram, node.member("sum").number(), node.member("max").number());
        if (distribution.pixels() != node.member("pixels").count()) {
            throw std::invalid_argument("the bins hold another number of pixels");
        }
        return distribution;
    } catch (const std::invalid_argument& error) {
        node.fail(fmt::format("is no distribution: {}", error.what()));
    }
}

/// @param dimension  the first by which the place may have parts
void readPlace(const Node& node, const StatisticsPlace& place, std::size_t dimension, const StatisticsFile& file,
               FrameFigures& frame) {
    node.member("values").eachMember([&](const std::string& name, const Node& value) {
        frame[place].values[indexIn(file.counters, name, "counters", value)] = value.number();
    });
    node.eachMember([&](const std::string& key, const Node& parts) {
        if (key == "values" || (key == "frame" && dimension == 0)) return;
        if (key == "distributions") {
            parts.eachMember([&](const std::string& name, const Node& distribution) {
                frame[place].distributions[indexIn(file.quantities, name, "quantities", distribution)] =
                    readDistribution(distribution);
            });
            return;
        }
        std::size_t d = dimension;
        while (d < kDimensions.size() && key != kDimensions[d].key) ++d;
        if (d == kDimensions.size()) parts.fail("does not belong here");
        parts.eachMember([&](const std::string& name, const Node& part) {
            if (name.empty()) part.fail("has no name");
            StatisticsPlace inner = place;
            inner.*kDimensions[d].name = name;
            readPlace(part, inner, d + 1, file, frame);
        });
    });
}

}  // namespace

StatisticsFile parseStatistics(std::string_view json, const std::string& name) {
    Node::Json document;
    try {
        document = Node::Json::parse(json);
    } catch (const Node::Json::parse_error& error) {
        const std::string_view text = error.what();
        throw Error(ErrorKind::Input, name,
                    fmt::format("is not JSON: {}", text.substr(std::min(text.size(), text.find("] ") + 2))));
    }
    const Node root(document, name);
    if (!document.is_object() || !root.has("format") || document["format"] != kStatisticsFormat) {
        root.fail(fmt::format("is no statistics file: its format is not \"{}\"", kStatisticsFormat),
                  "umbrage render writes one where the sequence has statistics: {path: FILE.json}");
    }
    StatisticsFile file;
    root.member("counters").eachMember([&](const std::string& counter, const Node& node) {
        file.counters.push_back(readCounter(counter, node));
    });
    root.member("quantities").eachMember([&](const std::string& quantity, const Node& node) {
        file.quantities.push_back(
            {quantity, node.member("unit").string(), node.member("doc").string(), node.member("aov").string()});
    });
    root.member("frames").eachElement([&](const Node& node) {
        const int frame = node.member("frame").integer();
        const auto [entry, isNew] = file.frames.try_emplace(frame);
        if (!isNew) node.fail(fmt::format("frame {} is there twice", frame));
        readPlace(node, {}, 0, file, entry->second);
    });
    if (root.has("budgets")) {
        root.member("budgets").eachElement([&](const Node& node) { file.budgets.push_back(readBudgetOf(file, node)); });
    }
    root.eachMember([&](const std::string& key, const Node& node) {
        for (const char* known : {"format", "counters", "quantities", "budgets", "frames", "summary"}) {
            if (key == known) return;
        }
        file.header.emplace_back(key, node.string());
    });
    return file;
}

StatisticsFile readStatistics(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();  // a folder opens, and then fails to be read
    if (!stream.is_open() || text.bad()) throw Error(ErrorKind::Input, file.string(), "cannot be read");
    return parseStatistics(text.view(), file.string());
}

}  // namespace umbrage
