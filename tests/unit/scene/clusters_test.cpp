// SPDX-License-Identifier: Apache-2.0
// Clusters of a mesh: what may come apart and what never does.
#include "scene/clusters.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

namespace umbrage {
namespace {

/// Adds a bumpless sphere of rows x columns quads.
void addSphere(Mesh& mesh, const glm::vec3& center, float radius, std::uint32_t rows, std::uint32_t columns) {
    const auto first = std::uint32_t(mesh.positions.size());
    for (std::uint32_t r = 0; r <= rows; ++r) {
        for (std::uint32_t c = 0; c < columns; ++c) {
            const float polar = 3.14159265f * float(r) / float(rows), around = 6.2831853f * float(c) / float(columns);
            const bool pole = r == 0 || r == rows;  // exactly one point
            const glm::vec3 out(pole ? 0.0f : std::sin(polar) * std::cos(around), r == 0 ? 1.0f : std::cos(polar),
                                pole ? 0.0f : std::sin(polar) * std::sin(around));
            mesh.positions.push_back(center + radius * out);
        }
    }
    for (std::uint32_t r = 0; r < rows; ++r) {
        for (std::uint32_t c = 0; c < columns; ++c) {
            const std::uint32_t a = first + r * columns + c, b = first + r * columns + (c + 1) % columns;
            for (const std::uint32_t v : {a, b, b + columns, a, b + columns, a + columns}) mesh.indices.push_back(v);
        }
    }
}

Mesh finished(Mesh mesh) {
    Primitive primitive;
    primitive.indexCount = std::uint32_t(mesh.indices.size());
    primitive.vertexCount = std::uint32_t(mesh.positions.size());
    mesh.primitives = {primitive};
    return mesh;
}

TEST(Clusters, EveryCastingTriangleIsInOneLeafAndTheRootHoldsAll) {
    Mesh mesh;
    addSphere(mesh, {0, 0, 0}, 1.0f, 24, 32);
    mesh = finished(std::move(mesh));
    const MeshTopology topology = buildTopology(mesh, {});
    const ClusterTree tree = buildClusters(mesh, topology);
    EXPECT_GT(tree.nodes[0].leafCount, 8u);
    EXPECT_LE(tree.nodes[0].leafCount, 128u);
    std::map<std::uint32_t, int> sizes;
    for (std::uint32_t t = 0; t < mesh.triangleCount(); ++t) {
        ASSERT_LT(tree.leafOfTriangle[t], tree.nodes[0].leafCount);
        if (topology.casts[t]) ++sizes[tree.leafOfTriangle[t]];
    }
    EXPECT_EQ(sizes.size(), tree.nodes[0].leafCount) << "no leaf is empty";
    for (std::size_t n = 0; n < tree.nodes.size(); ++n) {
        if (tree.nodes[n].isLeaf()) continue;
        const auto& [left, right] = tree.nodes[n].children;
        ASSERT_GT(left, n);
        ASSERT_GT(right, n);
        EXPECT_EQ(tree.nodes[left].leafCount + tree.nodes[right].leafCount, tree.nodes[n].leafCount);
    }
}

TEST(Clusters, TheRootHasNoBorderAndItsHalvesShareTheirs) {
    Mesh mesh;
    addSphere(mesh, {0, 0, 0}, 1.0f, 24, 32);
    mesh = finished(std::move(mesh));
    const ClusterTree tree = buildClusters(mesh, buildTopology(mesh, {}));
    EXPECT_EQ(tree.nodes[0].borderMetres, 0.0);
    const auto& [left, right] = tree.nodes[0].children;
    EXPECT_NEAR(tree.nodes[left].borderMetres, tree.nodes[right].borderMetres, 1e-9);
    EXPECT_GT(tree.nodes[left].borderMetres, 6.0) << "about a great circle, in steps";
}

TEST(Clusters, TheOutlineOfASphereIsAboutAGreatCircle) {
    Mesh mesh;
    addSphere(mesh, {0, 0, 0}, 1.0f, 24, 32);
    mesh = finished(std::move(mesh));
    const double outline = buildClusters(mesh, buildTopology(mesh, {})).nodes[0].outlineMetres;
    EXPECT_GT(outline, 6.28);
    EXPECT_LT(outline, 1.5 * 6.28);
}

TEST(Clusters, SmallPiecesNeverComeApart) {
    Mesh mesh;
    for (int i = 0; i < 12; ++i) addSphere(mesh, {3.0f * float(i), 0, 0}, 1.0f, 6, 10);
    mesh = finished(std::move(mesh));
    const ClusterTree tree = buildClusters(mesh, buildTopology(mesh, {}));
    EXPECT_GE(tree.nodes[0].leafCount, 6u);
    const std::uint32_t trianglesOfPiece = mesh.triangleCount() / 12;
    for (std::uint32_t piece = 0; piece < 12; ++piece) {
        std::set<std::uint32_t> leaves;
        for (std::uint32_t t = 0; t < trianglesOfPiece; ++t) {
            const std::uint32_t triangle = piece * trianglesOfPiece + t;
            const std::uint32_t row = t / 20;
            if (row > 0 && row < 5) leaves.insert(tree.leafOfTriangle[triangle]);  // at the poles some have no area
        }
        EXPECT_EQ(leaves.size(), 1u) << piece;
    }
    for (const ClusterTree::Node& node : tree.nodes) EXPECT_EQ(node.borderMetres, 0.0);
}

TEST(Clusters, AMeshOfFewTrianglesIsOne) {
    Mesh mesh;
    addSphere(mesh, {0, 0, 0}, 1.0f, 4, 6);
    mesh = finished(std::move(mesh));
    EXPECT_EQ(buildClusters(mesh, buildTopology(mesh, {})).nodes.size(), 1u);
}

}  // namespace
}  // namespace umbrage
