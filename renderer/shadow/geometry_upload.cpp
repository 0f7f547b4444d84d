// SPDX-License-Identifier: Apache-2.0
// What a scene's geometry is made of on the device, uploaded once.
#include <algorithm>
#include <cstring>

#include "shadow/geometry.h"

namespace umbrage {

void Geometry::uploadVertices(const Scene& scene) {
    std::vector<glm::vec3> positions(vertexCount_), normals(vertexCount_, glm::vec3(0.0f, 0.0f, 1.0f));
    std::vector<glm::vec4> tangents, colors;
    std::vector<glm::vec2> texCoords[kTexCoordSetCount];
    std::vector<std::uint32_t> influences;
    std::vector<float> morphs;
    std::vector<std::uint32_t> firstMorph(scene.meshes.size()), firstInfluence(scene.meshes.size());

    const auto place = [&](std::size_t m, std::uint32_t firstVertex) {
        const Mesh& mesh = scene.meshes[m];
        const auto copy = [&](const auto& from, auto& to) {
            if (from.empty()) return;
            to.resize(vertexCount_);
            std::copy(from.begin(), from.end(), to.begin() + firstVertex);
        };
        std::transform(mesh.positions.begin(), mesh.positions.end(), positions.begin() + firstVertex,
                       [&](const glm::vec3& p) { return p - ranges_[m].origin; });
        copy(displaced_[m] ? normalsOf(mesh) : mesh.normals, normals);
        copy(mesh.tangents, tangents);
        copy(mesh.colors, colors);
        for (int s = 0; s < kTexCoordSetCount; ++s) copy(mesh.texCoords[s], texCoords[s]);
    };
    for (std::size_t m = 0; m < scene.meshes.size(); ++m) {
        const Mesh& mesh = scene.meshes[m];
        place(m, ranges_[m].firstVertex);
        firstInfluence[m] = std::uint32_t(influences.size() / 6);
        for (std::size_t i = 0; i < mesh.joints.size(); ++i) {
            std::uint32_t words[6];
            std::memcpy(words, &mesh.joints[i], 8);
            std::memcpy(words + 2, &mesh.weights[i], 16);
            influences.insert(influences.end(), words, words + 6);
        }
        firstMorph[m] = std::uint32_t(morphs.size() / MORPH_FLOATS);
        for (const MorphTarget& target : mesh.morphTargets) {
            const auto at = [](const std::vector<glm::vec3>& values, std::size_t v) {
                return values.empty() ? glm::vec3(0.0f) : values[v];
            };
            for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
                for (const glm::vec3& d : {at(target.positions, v), at(target.normals, v), at(target.tangents, v)}) {
                    morphs.insert(morphs.end(), {d.x, d.y, d.z});
                }
            }
        }
    }
    std::uint32_t jointCount = 0, weightCount = 0;
    for (Deforming& own : deforming_) {
        const std::uint32_t mesh = instanceMesh_[own.instance];
        place(mesh, own.firstVertex);
        own.firstInfluence = firstInfluence[mesh];
        own.firstMorph = firstMorph[mesh];
        own.firstJoint = jointCount;
        jointCount += own.jointCount;
        weightCount += own.morphCount;
    }

    using gpu::Buffer;
    positions_ = Buffer::of("positions", std::span<const glm::vec3>(positions));
    normals_ = Buffer::of("normals", std::span<const glm::vec3>(normals));
    tangents_ = Buffer::of("tangents", std::span<const glm::vec4>(tangents));
    colors_ = Buffer::of("colours", std::span<const glm::vec4>(colors));
    influences_ = Buffer::of("joint influences", std::span<const std::uint32_t>(influences));
    morphs_ = Buffer::of("morph targets", std::span<const float>(morphs));
    jointMatrices_ = Buffer("joint matrices", jointCount * 3 * sizeof(gpu::vec4));
    morphWeights_ = Buffer("morph weights", weightCount * sizeof(float));
    bounds_ = Buffer("deformed bounds", deforming_.size() * BOUNDS_WORDS * sizeof(std::uint32_t));
    indexBuffer_ = Buffer::of("indices", std::span<const std::uint32_t>(indices_));
    flagBuffer_ = Buffer::of("triangle flags", std::span<const std::uint32_t>(triangleFlags_));
    edgeBuffer_ = Buffer::of("edges", std::span<const gpu::Edge>(edges_));
    triangleChunkBuffer_ = Buffer::of("triangle chunks", std::span<const std::uint32_t>(triangleChunks_));
    edgeChunkBuffer_ = Buffer::of("edge chunks", std::span<const std::uint32_t>(edgeChunks_));
    instanceBuffer_ = Buffer("instances", instances_.size() * sizeof(gpu::InstanceData));

    for (int s = 0; s < kTexCoordSetCount; ++s) {
        texCoords_[s] = Buffer::of("texture coordinates", std::span<const glm::vec2>(texCoords[s]));
    }
}

}  // namespace umbrage
