// SPDX-License-Identifier: Apache-2.0
// The validator's parts, in the order in which they must run: each may rely on what those before it have checked.
#pragma once

#include <set>

#include "scene/gltf_accessor_format.h"
#include "scene/gltf_validate.h"

namespace umbrage {

struct AccessorFacts {
    const ElementType* type = nullptr;
    ComponentType component = ComponentType::Float;
    bool normalized = false;
    std::uint64_t count = 0;
    bool hasData = true;  // false: neither a buffer view nor sparse values, all zero
};

/// What is known about the document while it is being checked.
struct Validation {
    JsonView root;
    const GltfDocument& document;
    GltfFiles& files;
    GltfNotes& notes;
    GltfFacts& facts;
    std::set<std::string> extensionsUsed;

    std::vector<JsonView> bufferViews;
    std::vector<AccessorFacts> accessors;
    std::vector<std::size_t> meshTargetCounts;  // morph targets of each mesh
    std::vector<bool> meshHasJoints;            // JOINTS_0 on every primitive
    std::size_t sceneCount = 0, nodeCount = 0, skinCount = 0, cameraCount = 0, lightCount = 0;
    std::size_t imageCount = 0, samplerCount = 0, textureCount = 0, materialCount = 0;

    bool uses(const std::string& extension) const { return extensionsUsed.contains(extension); }
};

void validateBuffers(Validation& validation);
void validateBufferViews(Validation& validation);
void validateAccessors(Validation& validation);
void validateImagesAndTextures(Validation& validation);
void validateMaterials(const Validation& validation);
void validateMeshes(Validation& validation);
void validateCamerasAndLights(const Validation& validation);
void validateNodesAndScenes(const Validation& validation);
void validateSkins(const Validation& validation);
void validateAnimations(const Validation& validation);

/// The accessor named by `reference`, which must have this element type and one of these component formats.
const AccessorFacts& requireAccessor(const Validation& validation, const JsonView& reference, std::string_view type,
                                     ComponentFormats formats);

/// The value must be one of the given numbers.
void requireEnum(const JsonView& value, std::initializer_list<std::uint64_t> allowed);

/// The value must be one of the given words.
void requireEnum(const JsonView& value, std::initializer_list<std::string_view> allowed);

}  // namespace umbrage
