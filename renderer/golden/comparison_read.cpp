// SPDX-License-Identifier: Apache-2.0
// The model from JSON. Strict: what the writer would not have written is refused with its JSON pointer.
#include <algorithm>
#include <limits>

#include "diagnostics/budgets_json.h"
#include "diagnostics/json_node.h"
#include "golden/comparison_format.h"
#include "golden/reports.h"
#include "job/nearest.h"

namespace umbrage {
namespace {

using Node = JsonNode;

/// null stands for what is not finite.
double readNumber(const Node& node) {
    return node.json().is_null() ? std::numeric_limits<double>::infinity() : node.number();
}

int readSize(const Node& node) {
    const int value = node.integer();
    if (value < 0) node.fail("must not be negative");
    return value;
}

Outcome readOutcome(const Node& node) {
    const std::string name = node.string();
    const auto found =
        std::find_if(kOutcomes.begin(), kOutcomes.end(), [&](const auto& info) { return info.name == name; });
    if (found != kOutcomes.end()) return Outcome(found - kOutcomes.begin());
    std::vector<std::string> known;
    for (const OutcomeInfo& info : kOutcomes) known.emplace_back(info.name);
    node.fail(fmt::format("there is no outcome \"{}\"", name), hintForName(name, known));
}

std::vector<std::string> readTexts(const Node& node) {
    std::vector<std::string> texts;
    node.eachElement([&](const Node& text) { texts.push_back(text.string()); });
    return texts;
}

Provenance readProvenance(const Node& node) {
    Provenance provenance;
    for (const ProvenanceField& field : kProvenanceFields) provenance.*field.text = node.member(field.key).string();
    return provenance;
}

ImageResult readImage(const Node& node) {
    ImageResult image;
    image.name = node.member("name").string();
    image.aov = node.member("aov").string();
    image.frame = node.member("frame").integer();
    image.outcome = readOutcome(node.member("outcome"));
    image.reason = node.member("reason").string();
    if (node.has("decision")) {
        const Node decision = node.member("decision");
        image.decision = Decision{decision.member("rule").string(), decision.member("metric").string(),
                                  readNumber(decision.member("limit")), readNumber(decision.member("value"))};
    }
    node.member("figures").eachMember([&](const std::string& metric, const Node& value) {
        image.figures.push_back({metric, readNumber(value)});
    });
    image.width = readSize(node.member("width"));
    image.height = readSize(node.member("height"));
    image.channels = readTexts(node.member("channels"));
    if (node.has("worst")) {
        std::vector<int> place;
        node.member("worst").eachElement([&](const Node& value) { place.push_back(readSize(value)); });
        if (place.size() != 2) node.member("worst").fail("must be a pair of x and y");
        image.worst = {place[0], place[1]};
    }
    return image;
}

StatisticsResult readColumn(const Node& node) {
    return {node.member("column").string(),    node.member("frame").integer(),    readOutcome(node.member("outcome")),
            readNumber(node.member("golden")), readNumber(node.member("output")), readNumber(node.member("tolerance")),
            node.member("reason").string()};
}

BudgetResult readBudgetWithUnit(const Node& node) {
    BudgetResult budget = readBudget(node);
    budget.unit = node.member("unit").string();
    return budget;
}

}  // namespace

Comparison readComparison(std::string_view json, const std::string& name) {
    Node::Json document;
    try {
        document = Node::Json::parse(json);
    } catch (const Node::Json::parse_error& error) {
        throw Error(ErrorKind::Input, name, fmt::format("is no JSON: {}", error.what()));
    }
    const Node root(document, name);
    if (root.member("format").string() != kComparisonFormat) {
        root.member("format").fail(fmt::format("must be \"{}\"", kComparisonFormat));
    }
    Comparison comparison;
    comparison.golden = root.member("golden").string();
    comparison.output = root.member("output").string();
    if (root.has("goldenFrom")) comparison.goldenFrom = readProvenance(root.member("goldenFrom"));
    if (root.has("outputFrom")) comparison.outputFrom = readProvenance(root.member("outputFrom"));
    comparison.foreignDevice = root.member("foreignDevice").boolean();
    comparison.notes = readTexts(root.member("notes"));
    root.member("images").eachElement([&](const Node& node) { comparison.images.push_back(readImage(node)); });
    root.member("statistics").eachElement([&](const Node& node) { comparison.statistics.push_back(readColumn(node)); });
    if (root.has("budgets")) {
        root.member("budgets").eachElement(
            [&](const Node& node) { comparison.budgets.push_back(readBudgetWithUnit(node)); });
    }
    comparison.renderCommand = root.member("renderCommand").string();
    comparison.acceptCommand = root.member("acceptCommand").string();
    if (root.member("passes").boolean() != comparison.passes()) {
        root.member("passes").fail("contradicts the outcomes");
    }
    return comparison;
}

}  // namespace umbrage
