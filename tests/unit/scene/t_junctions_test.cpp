// SPDX-License-Identifier: Apache-2.0
#include "scene/t_junctions.h"

#include <gtest/gtest.h>

namespace umbrage {
namespace {

std::size_t junctionsOf(const std::vector<glm::vec3>& positions, const std::vector<std::uint32_t>& indices) {
    Mesh mesh;
    mesh.positions = positions;
    mesh.indices = indices;
    Primitive primitive;
    primitive.indexCount = std::uint32_t(indices.size());
    primitive.vertexCount = std::uint32_t(positions.size());
    primitive.material = 0;
    mesh.primitives = {primitive};
    const std::vector<Material> materials(1);
    return countTJunctions(mesh, buildTopology(mesh, materials));
}

// One large triangle above two small ones that meet in the middle of its lower edge.
const std::vector<glm::vec3> kPositions = {{0, 0, 0}, {4, 0, 0}, {2, 3, 0}, {2, 0, 0}, {1, -1, 0}, {3, -1, 0}};

TEST(TJunctions, ACornerInTheMiddleOfAnEdgeIsOne) {
    EXPECT_EQ(junctionsOf(kPositions, {0, 1, 2, 0, 4, 3, 3, 5, 1}), 1u);
}

TEST(TJunctions, ACornerAtTheEndOfAnEdgeIsNone) {
    EXPECT_EQ(junctionsOf(kPositions, {0, 3, 2, 3, 1, 2, 0, 4, 3, 3, 5, 1}), 0u);
}

TEST(TJunctions, ACornerBesideAnEdgeIsNone) {
    std::vector<glm::vec3> beside = kPositions;
    beside[3].y = -0.001f;
    EXPECT_EQ(junctionsOf(beside, {0, 1, 2, 0, 4, 3, 3, 5, 1}), 0u);
}

TEST(TJunctions, AClosedMeshHasNone) {
    const std::vector<glm::vec3> corners = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    EXPECT_EQ(junctionsOf(corners, {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3}), 0u);
}

}  // namespace
}  // namespace umbrage
