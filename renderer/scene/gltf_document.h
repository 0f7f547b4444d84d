// SPDX-License-Identifier: Apache-2.0
// The first step of loading: bytes into a parsed JSON document and, for .glb, its binary chunk. What the JSON says is
// not looked at here.
#pragma once

#include <cstddef>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/gltf_json.h"

namespace umbrage {

struct GltfDocument {
    std::string name;           // for messages
    std::size_t sizeBytes = 0;  // of the file
    nlohmann::json json;
    std::vector<std::byte> bytes;                      // the file, kept when it is a .glb
    std::optional<std::span<const std::byte>> binary;  // the BIN chunk, within `bytes`

    JsonView root() const { return {json, name, ""}; }
};

/// Reads a whole regular file; devices and pipes, which may never end, are refused. @throws Error(Input)
std::vector<std::byte> readRegularFile(const std::filesystem::path& file);

/// .gltf or .glb, told apart by the first bytes. @throws Error(Input)
GltfDocument parseGltfDocument(std::vector<std::byte> bytes, std::string_view name);

}  // namespace umbrage
