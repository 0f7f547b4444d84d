// SPDX-License-Identifier: Apache-2.0
// Skins: those that kept nodes use.
#include <fmt/format.h>

#include <cmath>
#include <glm/gtc/type_ptr.hpp>

#include "scene/gltf_convert.h"

namespace umbrage {
namespace {

// Whether every JOINTS value names a joint depends on the skin that a node brings to a mesh.
void requireJoints(const GltfConversion& conversion) {
    for (const tinygltf::Node& node : conversion.model.nodes) {
        if (node.mesh < 0 || node.skin < 0) {
            continue;
        }
        const auto& use = conversion.meshJoints[static_cast<std::size_t>(node.mesh)];
        const std::size_t jointCount = conversion.model.skins[static_cast<std::size_t>(node.skin)].joints.size();
        if (!use.pointer.empty() && use.largest >= jointCount) {
            failAt(conversion.file, use.pointer,
                   fmt::format("names joint {}, but skin {} has {} joints", use.largest, node.skin, jointCount));
        }
    }
}

Skin convertSkin(const GltfConversion& conversion, std::size_t index) {
    const tinygltf::Skin& source = conversion.model.skins[index];
    Skin skin;
    skin.name = source.name;
    for (const int joint : source.joints) {
        skin.joints.push_back(conversion.sceneNodes[static_cast<std::size_t>(joint)]);
    }
    skin.jointFromMesh.assign(skin.joints.size(), glm::mat4(1.0f));
    if (source.inverseBindMatrices < 0) {
        return skin;
    }
    const std::string pointer = fmt::format("/skins/{}/inverseBindMatrices", index);
    const auto values = conversion.reader.floats(source.inverseBindMatrices, pointer);
    for (std::size_t i = 0; i < skin.joints.size(); ++i) {
        glm::mat4 matrix = glm::make_mat4(&values[i * 16]);
        const glm::vec4 lastRow(matrix[0].w, matrix[1].w, matrix[2].w, matrix[3].w);
        constexpr float kRounding = 1e-3f;
        if (glm::length(lastRow - glm::vec4(0.0f, 0.0f, 0.0f, 1.0f)) > kRounding) {
            failAt(conversion.file, pointer,
                   fmt::format("the last row of matrix {} must be 0 0 0 1, but is {} {} {} {}", i, lastRow.x, lastRow.y,
                               lastRow.z, lastRow.w));
        }
        matrix[0].w = matrix[1].w = matrix[2].w = 0.0f;
        matrix[3].w = 1.0f;
        skin.jointFromMesh[i] = matrix;
    }
    return skin;
}

}  // namespace

void convertSkins(GltfConversion& conversion) {
    requireJoints(conversion);
    std::vector<Index> kept(conversion.model.skins.size(), kNone);
    for (Node& node : conversion.scene.nodes) {
        if (node.skin == kNone) {
            continue;
        }
        const auto source = static_cast<std::size_t>(node.skin);
        if (kept[source] == kNone) {
            kept[source] = static_cast<Index>(conversion.scene.skins.size());
            conversion.scene.skins.push_back(convertSkin(conversion, source));
        }
        node.skin = kept[source];
    }
}

}  // namespace umbrage
