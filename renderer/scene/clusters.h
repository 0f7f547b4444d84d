// SPDX-License-Identifier: Apache-2.0
// A mesh's casting triangles as a tree of clusters, so that casters can be divided into parts by choosing a cut through
// it: what the split-plane paper did by hand (Laine 2005, sections 6 and 8.3). Made once a mesh, from its positions at
// rest. Small pieces that hang together only in themselves never come apart.
#pragma once

#include <vector>

#include "scene/topology.h"

namespace umbrage {

struct ClusterTree {
    static constexpr std::uint32_t kNone = 0xffffffffu;

    struct Node {
        std::uint32_t children[2] = {kNone, kNone};
        std::uint32_t firstLeaf = 0, leafCount = 1;
        std::vector<glm::dvec3> extremes;  // see extremesOf()
        double outlineMetres = 0.0;        // about how long its silhouette is, whole meshes being seen from afar ...
        double borderMetres = 0.0;         // ... and how long the edges are that it shares with the rest of the mesh

        bool isLeaf() const { return children[0] == kNone; }
    };
    std::vector<Node> nodes;  // the root first, children behind their parents
    std::vector<std::uint32_t> leafOfTriangle;
};

ClusterTree buildClusters(const Mesh& mesh, const MeshTopology& topology);

/// Those points that lie farthest in 26 directions: what boxes, axes and outlines need.
std::vector<glm::dvec3> extremesOf(std::span<const glm::vec3> points);

}  // namespace umbrage
