// SPDX-License-Identifier: Apache-2.0
// Output becomes golden: what that would change, and doing it.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "golden/provenance.h"

namespace umbrage {

struct GoldenChange {
    enum class Kind { Added, Changed, Removed };
    Kind kind;
    std::string name;        // of the picture, from either folder on
    std::string difference;  // of a changed one, in words
};

struct AcceptPlan {
    std::filesystem::path golden, output;
    std::vector<GoldenChange> changes;  // by name
    std::size_t unchanged = 0;
    std::optional<Manifest> goldenFrom, outputFrom;

    /// Whether goldens of one device would be mixed with or replaced by output of another.
    bool isForeign() const { return goldenFrom && outputFrom && !goldenFrom->from.sameDevice(outputFrom->from); }
};

/// @param asked  the pictures a job makes: goldens of others stay, and outputs of others are left alone
/// @param statistics  statistics.json becomes golden, too; where there is a golden of it, it does anyway
/// @throws Error(Input)
AcceptPlan planAccept(const std::filesystem::path& golden, const std::filesystem::path& output,
                      const std::optional<std::map<std::string, ManifestImage>>& asked, bool statistics = false);

/// Copies what is added or changed, each file whole or not at all, removes what is removed, and notes where it comes
/// from. What is unchanged is not touched. @throws Error(Output)
void accept(const AcceptPlan& plan);

}  // namespace umbrage
