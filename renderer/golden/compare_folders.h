// SPDX-License-Identifier: Apache-2.0
// Output against golden frames: which pictures belong together, by which rules, and what became of each.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "golden/comparison.h"
#include "golden/provenance.h"
#include "job/golden_rules.h"

namespace umbrage {

struct CompareOptions {
    GoldenRules rules;
    bool otherDevice = false;  // compare with goldens of another device, too
    int threads = 0;           // 0: as many as processors
    /// The pictures that a job should have written, by name; else those of the output's manifest.
    std::optional<std::map<std::string, ManifestImage>> asked{};
    /// Calls come from one thread at a time.
    std::function<void(std::size_t done, std::size_t count)> progress{};
};

/// Name of the statistics that are compared where a folder of goldens has them.
inline constexpr const char* kGoldenStatistics = "statistics.json";

/// @param golden, output  two folders, or two pictures
/// @throws Error(Input) for what is not there, a bad manifest, and goldens of another device unless that is allowed
Comparison comparePictures(const std::filesystem::path& golden, const std::filesystem::path& output,
                           const CompareOptions& options);

/// PNG and EXR files in a folder and those in it, by name from the folder on, with '/'.
/// @param except  a folder that may be inside, and is not looked into
/// @throws Error(Input)
std::vector<std::string> picturesIn(const std::filesystem::path& folder, const std::filesystem::path& except = {});

/// AOV and frame as NAME.FRAME.EXT says them; without a frame the AOV is empty.
ManifestImage namedImage(const std::string& name);

/// Whether two files hold the same bytes; false where one is missing. @throws Error(Input) for what cannot be read
bool equalFiles(const std::filesystem::path& a, const std::filesystem::path& b);

}  // namespace umbrage
