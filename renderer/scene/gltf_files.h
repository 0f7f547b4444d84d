// SPDX-License-Identifier: Apache-2.0
// Where a glTF document's bytes may come from: data URIs and files in the scene's own folder. Nothing else is opened,
// whatever the document says: no other folder (symbolic links are followed before judging), no scheme, no device.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "scene/gltf_json.h"

namespace umbrage {

/// Bytes that are known to exist, not read yet.
struct GltfSource {
    struct DataUri {
        std::string_view base64;  // in the document's JSON, valid base64 without white space
    };
    std::variant<std::span<const std::byte>, DataUri, std::filesystem::path> origin;
    std::uint64_t sizeBytes = 0;
    std::string mimeType;  // of a data URI
    std::string fileName;  // of a file
};

class GltfFiles {
public:
    /// An empty `folder` means that no file may be read at all.
    GltfFiles(const std::filesystem::path& folder, bool allowExternalFiles);

    /// Finds out what a URI names and how much that is. @throws Error(Input) at `uri`
    GltfSource resolve(const JsonView& uri);

    /// The sum of the sizes of all different files resolved so far.
    std::uint64_t fileBytes() const { return fileBytes_; }

    /// Those files, by name.
    const std::set<std::filesystem::path>& files() const { return files_; }

private:
    GltfSource resolveFile(const JsonView& uri);

    std::filesystem::path folder_;
    bool allowExternalFiles_;
    std::set<std::filesystem::path> files_;
    std::uint64_t fileBytes_ = 0;
};

/// The first `sizeBytes` bytes of the source. @throws Error(Input) when a file has become shorter or unreadable
std::vector<unsigned char> readSource(const GltfSource& source, std::uint64_t sizeBytes);

}  // namespace umbrage
