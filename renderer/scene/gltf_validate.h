// SPDX-License-Identifier: Apache-2.0
// The second step of loading: everything the JSON of a glTF document says is checked, before tinygltf sees it and
// before anything is allocated by a number it declares. What lies inside buffers (indices, times, joints) is checked
// by the conversion, which is the first to read it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scene/gltf_document.h"
#include "scene/gltf_files.h"
#include "scene/gltf_notes.h"

namespace umbrage {

/// What validation found out and the next steps need.
struct GltfFacts {
    std::vector<std::optional<GltfSource>> buffers;  // none: a buffer without data, which nothing reads
    std::vector<std::uint64_t> bufferBytes;          // declared; the source has at least as many
    std::vector<std::optional<GltfSource>> images;   // none: the image is in a buffer view
    std::vector<std::string> extensionsUsed, extensionsIgnored;
};

/// @throws Error(Input) at "file: /json/pointer"
GltfFacts validateGltf(const GltfDocument& document, GltfFiles& files, GltfNotes& notes);

}  // namespace umbrage
