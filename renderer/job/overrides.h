// SPDX-License-Identifier: Apache-2.0
// --set path=value: changes the YAML tree before it is read, so that every check of the file holds for it too.
#pragma once

#include <string>

#include "job/yaml_tree.h"

namespace umbrage {

/// Sets one value. `path` is keys and list indices with dots between them, where a key may itself have dots
/// ("displace./A.b.amplitude"); mappings on the way that are not there are made, lists keep their length.
/// A key in quotes is one with all its dots, there or not: statistics.budgets."overdraw.p95".
/// @param assignment  "image.size=[640, 480]": the value is YAML
/// @param option  what errors name as their place; empty: "--set PATH"
/// @throws Error(Usage) for what is no assignment; Error(Input) for bad YAML or a path through a value
void applyOverride(YamlNode& root, const std::string& assignment, const std::string& option = {});

/// --budget: statistics.budgets of "FIGURE=LIMIT".
/// @throws as applyOverride()
void applyBudgets(YamlNode& root, const std::vector<std::string>& assignments);

}  // namespace umbrage
