// SPDX-License-Identifier: Apache-2.0
#include "topology.h"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <utility>

namespace generator {

Topology& Topology::operator+=(const Topology& other) {
    triangles += other.triangles, vertices += other.vertices, edges += other.edges;
    openEdges += other.openEdges, nonManifoldEdges += other.nonManifoldEdges;
    degenerate += other.degenerate, inwardPieces += other.inwardPieces, pieces += other.pieces;
    return *this;
}

Topology topologyOf(const std::vector<glm::vec3>& corners) {
    Topology result;
    result.triangles = corners.size() / 3;
    std::map<std::array<float, 3>, std::size_t> vertices;
    std::vector<std::size_t> ids;
    for (const glm::vec3& p : corners)
        ids.push_back(vertices.try_emplace({p.x, p.y, p.z}, vertices.size()).first->second);
    result.vertices = vertices.size();

    std::vector<std::size_t> piece(vertices.size());
    std::iota(piece.begin(), piece.end(), std::size_t{0});
    const auto root = [&](std::size_t v) {
        while (piece[v] != v) v = piece[v] = piece[piece[v]];
        return v;
    };
    std::map<std::pair<std::size_t, std::size_t>, std::array<std::size_t, 2>> uses;  // per direction
    for (std::size_t i = 0; i < ids.size(); i += 3) {
        const glm::dvec3 a = corners[i], b = corners[i + 1], c = corners[i + 2];
        if (glm::cross(b - a, c - a) == glm::dvec3(0)) ++result.degenerate;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t from = ids[i + k], to = ids[i + (k + 1) % 3];
            ++uses[std::minmax(from, to)][from < to];
            piece[root(from)] = root(to);
        }
    }
    result.edges = uses.size();
    for (const auto& [edge, count] : uses) {
        if (count[0] + count[1] == 1)
            ++result.openEdges;
        else if (count[0] != 1 || count[1] != 1)
            ++result.nonManifoldEdges;
    }

    std::map<std::size_t, double> volumes;
    for (std::size_t i = 0; i < ids.size(); i += 3)
        volumes[root(ids[i])] +=
            glm::dot(glm::dvec3(corners[i]), glm::cross(glm::dvec3(corners[i + 1]), glm::dvec3(corners[i + 2])));
    result.pieces = volumes.size();
    if (result.openEdges == 0)
        for (const auto& [id, volume] : volumes) result.inwardPieces += volume < 0;
    return result;
}

}  // namespace generator
