// SPDX-License-Identifier: Apache-2.0
#include "scene/t_junctions.h"

#include <algorithm>
#include <vector>

namespace umbrage {

std::size_t countTJunctions(const Mesh& mesh, const MeshTopology& topology) {
    std::vector<const MeshEdge*> open;
    std::vector<std::uint32_t> ends;
    for (const MeshEdge& edge : topology.edges) {
        if (edge.right != MeshEdge::kNoTriangle) continue;
        open.push_back(&edge);
        ends.insert(ends.end(), {edge.a, edge.b});
    }
    const auto byX = [&](std::uint32_t a, std::uint32_t b) { return mesh.positions[a].x < mesh.positions[b].x; };
    std::sort(ends.begin(), ends.end());
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    std::stable_sort(ends.begin(), ends.end(), byX);

    std::vector<std::uint32_t> junctions;
    for (const MeshEdge* edge : open) {
        const glm::dvec3 a(mesh.positions[edge->a]), way = glm::dvec3(mesh.positions[edge->b]) - a;
        const double squared = glm::dot(way, way), tolerance = 0x1p-40 * squared;
        const double low = std::min(a.x, a.x + way.x), high = std::max(a.x, a.x + way.x);
        const auto first = std::lower_bound(ends.begin(), ends.end(), low, [&](std::uint32_t end, double x) {
            return double(mesh.positions[end].x) < x;
        });
        for (auto end = first; end != ends.end() && double(mesh.positions[*end].x) <= high; ++end) {
            const glm::dvec3 p = glm::dvec3(mesh.positions[*end]) - a;
            const double along = glm::dot(p, way) / squared;
            const glm::dvec3 beside = p - along * way;
            const double margin = 0x1p-20;
            if (along > margin && along < 1.0 - margin && glm::dot(beside, beside) <= tolerance)
                junctions.push_back(*end);
        }
    }
    std::sort(junctions.begin(), junctions.end());
    return std::size_t(std::unique(junctions.begin(), junctions.end()) - junctions.begin());
}

}  // namespace umbrage
