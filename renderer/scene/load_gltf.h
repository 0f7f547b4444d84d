// SPDX-License-Identifier: Apache-2.0
// glTF 2.0 files into Scenes: read (inside the scene's folder only), parse, validate, convert. Every problem is an
// Error with the file and the JSON pointer of the place; memory is bounded by the size of the files.
#pragma once

#include <filesystem>
#include <span>
#include <string_view>

#include "scene/scene.h"

namespace umbrage {

struct GltfOptions {
    std::string scene;                // name or index of the glTF scene; empty: the file's default
    bool allowExternalFiles = false;  // let URIs leave the scene's folder
};

/// @throws Error(Input)
Scene loadGltf(const std::filesystem::path& file, const GltfOptions& options = {});

/// The same from memory, for tests and fuzzing: no external file can be read.
Scene loadGltf(std::span<const std::byte> bytes, std::string_view name, const GltfOptions& options = {});

/// Names of the extensions this loader understands, sorted.
std::span<const std::string_view> supportedExtensions();

}  // namespace umbrage
