// SPDX-License-Identifier: Apache-2.0
// What compare and accept work on: two places, or a sequence that is rendered first.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "diagnostics/budgets.h"
#include "golden/provenance.h"
#include "job/golden_rules.h"
#include "options.h"

namespace umbrage {

struct GoldenInput {
    std::filesystem::path golden, output;
    GoldenRules rules;                                          // of the sequence
    std::optional<std::map<std::string, ManifestImage>> asked;  // of the sequence: what it makes
    std::string renderCommand, acceptCommand;                   // to do it again
    std::vector<BudgetResult> budgets{};                        // of the sequence
    bool interrupted = false;                                   // while rendering
};

/// @throws Error(Usage, Input), and as rendering does
GoldenInput goldenInput(const std::vector<std::string>& inputs, const RenderOptions& render, bool quiet);

}  // namespace umbrage
