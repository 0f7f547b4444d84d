// SPDX-License-Identifier: Apache-2.0
// statistics.budgets, and --budget, which is the same on the command line.
#include "job/job_types.h"
#include "job/overrides.h"

namespace umbrage {
namespace {

/// The limits of one figure.
struct Bounds {
    std::optional<double> max, min;
};

Type<Bounds> bounds() {
    const auto limit = opinion(number(atLeast(0)));
    const auto most = converted<Bounds>(number(atLeast(0)), [](double value, const YamlNode&) {
        return Bounds{value, {}};
    });
    const auto both = mapping<Bounds>(
        "budget", "Limits of one figure, in its unit; a value on the limit is within it.",
        {
            field<Bounds>("max", limit, &Bounds::max, "The most that any frame may have").unset("no limit"),
            field<Bounds>("min", limit, &Bounds::min, "The least that every frame must have").unset("no limit"),
        },
        [](const Bounds& made, const YamlNode& node) {
            if (!made.max && !made.min)
                refuse(node, "the budget has no limit", "write max: or min:, or a number alone");
            if (made.max && made.min && *made.min > *made.max)
                refuse(node, fmt::format("no value is at least {} and at most {}", *made.min, *made.max));
        });
    return either(most, both, [](const YamlNode& node) { return !node.isMapping(); });
}

}  // namespace

Type<std::vector<Budget>> budgets() {
    return converted<std::vector<Budget>>(dictionary(bounds(), "a mapping {figure: limit, ...}", budgetFigures()),
                                          [](const auto& entries, const YamlNode&) {
                                              std::vector<Budget> made;
                                              for (const auto& [figure, limits] : entries) {
                                                  if (limits.max) made.push_back({figure.value, *limits.max, false});
                                                  if (limits.min) made.push_back({figure.value, *limits.min, true});
                                              }
                                              return made;
                                          });
}

void applyBudgets(YamlNode& root, const std::vector<std::string>& assignments) {
    for (const std::string& assignment : assignments) {
        // The name is one key, dots and all.
        const std::string name = assignment.substr(0, assignment.find('='));
        applyOverride(root, fmt::format("statistics.budgets.\"{}\"{}", name, assignment.substr(name.size())),
                      "--budget");
    }
}

std::vector<Budget> parseBudgets(const std::vector<std::string>& assignments) {
    if (assignments.empty()) return {};
    YamlNode root{.kind = YamlNode::Kind::Mapping};
    applyBudgets(root, assignments);
    return budgets().read(*root.find("statistics")->find("budgets"), "budgets");
}

}  // namespace umbrage
