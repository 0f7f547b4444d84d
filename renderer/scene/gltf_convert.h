// SPDX-License-Identifier: Apache-2.0
// The third step of loading: tinygltf's model into our Scene, part by part, in this order. Whatever only the bytes in
// buffers can tell (indices, joints, times, finite numbers) is checked here, where it is read.
#pragma once

#include <string>
#include <vector>

#include "scene/gltf_accessor.h"
#include "scene/gltf_notes.h"
#include "scene/scene.h"

namespace umbrage {

struct GltfConversion {
    const std::string& file;
    tinygltf::Model& model;  // images are moved out of it
    const AccessorReader& reader;
    MemoryBudget& budget;
    GltfNotes& notes;
    Scene& scene;

    /// The largest value in a mesh's JOINTS_n and where it is; what it may be depends on the skin it meets.
    struct JointUse {
        std::uint32_t largest = 0;
        std::string pointer;
    };
    std::vector<JointUse> meshJoints{};
    std::vector<Index> sceneNodes{};  // glTF node -> Scene::nodes, or kNone for nodes that are not kept
};

void convertTextures(GltfConversion& conversion);
void convertMaterials(GltfConversion& conversion);
void convertMeshes(GltfConversion& conversion);
void convertCamerasAndLights(GltfConversion& conversion);

/// Keeps the nodes of the scene named `sceneName` (or its index; empty: the default, else the first, else all roots)
/// and the joints that it needs from elsewhere.
void convertNodes(GltfConversion& conversion, const std::string& sceneName);
void convertSkins(GltfConversion& conversion);
void convertAnimations(GltfConversion& conversion);

}  // namespace umbrage
