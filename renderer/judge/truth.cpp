// SPDX-License-Identifier: Apache-2.0
#include "judge/truth.h"

#include <algorithm>

namespace umbrage {
namespace {

oracle::Triangle traitsOf(const Material& material) {
    oracle::Triangle traits;
    traits.casts = traits.visible = material.alphaMode != AlphaMode::Blend;
    traits.singleSided = !material.doubleSided;
    traits.holed = material.alphaMode == AlphaMode::Mask;
    return traits;
}

bool same(const std::vector<oracle::Triangle>& a, const std::vector<oracle::Triangle>& b) {
    return std::ranges::equal(a, b, [](const auto& x, const auto& y) { return x.corners == y.corners; });
}

}  // namespace

void Truth::update(const Moment& moment, const Geometry& geometry) {
    const std::vector<float> evaluated = geometry.deforms() ? geometry.readPositions() : std::vector<float>();
    std::vector<oracle::Triangle> triangles;
    indices_.assign(geometry.placedTriangleCount(), oracle::kNothing);
    for (std::uint32_t i = 0; i < moment.instances.size(); ++i) {
        const Instance& instance = moment.instances[i];
        const Mesh& mesh = scene_.meshes[std::size_t(instance.mesh)];
        std::vector<glm::dvec3> world;
        for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
            if (!geometry.hasOwnVertices(i)) {
                world.push_back(instance.worldFromModel * glm::dvec4(mesh.positions[v], 1.0));
                continue;
            }
            const float* own = &evaluated[3 * (geometry.instances()[i].vertexBase + v)];
            world.push_back(geometry.worldFromModel(i) * glm::dvec4(own[0], own[1], own[2], 1.0));
        }
        const glm::dmat4& placing = instance.skinned() ? instance.worldFromBindPose[0] : instance.worldFromModel;
        const bool mirrored = glm::determinant(glm::dmat3(placing)) < 0.0;
        std::uint32_t placed = geometry.instances()[i].placedTriangleBase;
        for (const Primitive& primitive : mesh.primitives) {
            if (primitive.topology != Topology::Triangles) continue;
            oracle::Triangle triangle =
                traitsOf(primitive.material == kNone ? Material{} : scene_.materials[std::size_t(primitive.material)]);
            for (std::uint32_t k = 0; k < primitive.indexCount; k += 3) {
                const std::uint32_t* v = &mesh.indices[primitive.firstIndex + k];
                triangle.corners = {world[v[0]], world[v[1]], world[v[2]]};
                if (mirrored) std::swap(triangle.corners[1], triangle.corners[2]);
                indices_[placed++] = std::uint32_t(triangles.size());
                triangles.push_back(triangle);
            }
        }
    }
    if (oracle_ && same(oracle_->triangles(), triangles)) return;
    oracle_ = std::make_unique<oracle::Oracle>(std::move(triangles));
}

}  // namespace umbrage
