// SPDX-License-Identifier: Apache-2.0
// manifest.json beside pictures: what made them, and which they are. Goldens without one are compared, too.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>

#include "golden/comparison.h"

namespace umbrage {

inline constexpr const char* kManifestName = "manifest.json";

struct ManifestImage {
    std::string aov;  // or overlay
    int frame = 0;
};

struct Manifest {
    Provenance from;
    std::map<std::string, ManifestImage> images;  // by name from the manifest's folder on, with '/'
};

/// Of a folder; nothing where there is none. @throws Error(Input) for one that is no manifest
std::optional<Manifest> readManifest(const std::filesystem::path& folder);

/// Adds to the manifest of the folder if that was made by the same job on the same device; otherwise replaces it, and
/// what else lies in the folder is no longer accounted for. Unchanged contents leave the file as it is.
/// @throws Error(Output)
void updateManifest(const std::filesystem::path& folder, Manifest manifest);

/// As it is, without looking at what was there. @throws Error(Output)
void writeManifest(const std::filesystem::path& folder, const Manifest& manifest);

/// The vector and FMA instructions that this machine's processor has, as far as they change what a software device
/// compiles: "avx avx2 fma".
std::string processorFlags();

/// Of what shapes a job's pictures. Where files lie does not matter, nor how the sequence is laid out.
/// @param shape  Job::shape
/// @param sources  the scene's files, whose contents count
/// @param color  the display transform's cache id
/// @return 16 hexadecimal digits
/// @throws Error(Input) for a source that cannot be read
std::string fingerprintOf(const std::string& shape, std::span<const std::filesystem::path> sources,
                          const std::string& color);

/// "renderer, version, processor", as rules name it.
std::string deviceOf(const Provenance& from);

}  // namespace umbrage
