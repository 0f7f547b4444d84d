// SPDX-License-Identifier: Apache-2.0
// The edges of a mesh's casting triangles, for any triangle soup (docs/rules.md, G2, R3).
//
// Vertices that can never separate (equal positions, and equal joints, weights, morph displacements and, where a
// procedure moves vertices along them, normals) are welded by exact bits. Every edge record names two vertices in
// canonical order and at most two triangles; an edge with more triangles has several records, which is right because
// counts are sums.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "scene/scene.h"

namespace umbrage {

struct MeshEdge {
    static constexpr std::uint32_t kNoTriangle = 0xffffffffu;

    std::uint32_t a = 0, b = 0;                        // vertices of the mesh, a before b by position
    std::uint32_t left = 0, right = kNoTriangle;       // triangles of the mesh
    bool leftReversed = false, rightReversed = false;  // the triangle runs from b to a
};

struct MeshTopology {
    std::vector<MeshEdge> edges;
    std::vector<bool> casts;    // per triangle: false for BLEND materials and triangles without area
    std::vector<bool> hasArea;  // per triangle: false where its corners lie exactly on a line
    std::vector<bool> even;     // per triangle: all edges of its connected component have an even number of triangles

    struct Figures {
        std::uint32_t weldedVertices = 0, edges = 0;  // of the casting triangles
        std::uint32_t openEdges = 0;                  // one triangle
        std::uint32_t nonManifoldEdges = 0;           // more than two
        std::uint32_t inconsistentEdges = 0;          // two that run along it in the same direction
        std::uint32_t components = 0, closedComponents = 0;
        std::uint32_t degenerateTriangles = 0;
    } figures;
};

/// @param materials  those the mesh's primitives name
/// @param displacedAlong  a normal a vertex, where a procedure will move them; else empty
MeshTopology buildTopology(const Mesh& mesh, std::span<const Material> materials,
                           std::span<const glm::vec3> displacedAlong = {});

/// For each vertex of the mesh the lowest one it is welded to.
std::vector<std::uint32_t> weldVertices(const Mesh& mesh, std::span<const glm::vec3> displacedAlong = {});

/// The mesh's normals; where it has none, the area-weighted mean of the triangles at each welded vertex.
std::vector<glm::vec3> normalsOf(const Mesh& mesh);

}  // namespace umbrage
