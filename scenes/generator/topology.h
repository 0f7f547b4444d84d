// SPDX-License-Identifier: Apache-2.0
// What a mesh is as a shadow caster: counts after welding equal positions, and whether it is closed and turned outward.
#pragma once

#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace generator {

struct Topology {
    std::size_t triangles = 0, vertices = 0, edges = 0;
    std::size_t openEdges = 0;         // in one triangle
    std::size_t nonManifoldEdges = 0;  // in more than two, or twice in the same direction
    std::size_t degenerate = 0;        // triangles without area
    std::size_t inwardPieces = 0;      // closed connected pieces whose volume is negative
    std::size_t pieces = 0;            // connected pieces

    Topology& operator+=(const Topology& other);
    bool closed() const { return openEdges == 0 && nonManifoldEdges == 0 && degenerate == 0 && inwardPieces == 0; }
};

/// @param corners  three positions per triangle
Topology topologyOf(const std::vector<glm::vec3>& corners);

}  // namespace generator
