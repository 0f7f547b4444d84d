// SPDX-License-Identifier: Apache-2.0
#include "scene/topology.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <numeric>
#include <tuple>

namespace umbrage {
namespace {

/// The bits of everything that moves a vertex, so that equal keys can never separate.
class VertexKeys {
public:
    VertexKeys(const Mesh& mesh, std::span<const glm::vec3> displacedAlong) {
        width_ = 3 + 6 * mesh.influenceSets() + 3 * mesh.morphTargets.size() + (displacedAlong.empty() ? 0 : 3);
        words_.resize(width_ * mesh.positions.size());
        for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
            std::uint32_t* key = &words_[v * width_];
            key = put(key, mesh.positions[v]);
            const std::size_t sets = mesh.influenceSets();
            for (std::size_t s = v * sets; s < (v + 1) * sets; ++s) {
                std::memcpy(key, &mesh.joints[s], sizeof mesh.joints[s]);
                std::memcpy(key + 2, &mesh.weights[s], sizeof mesh.weights[s]);
                key += 6;
            }
            if (!displacedAlong.empty()) key = put(key, displacedAlong[v]);
            for (const MorphTarget& target : mesh.morphTargets) {
                key = put(key, target.positions.empty() ? glm::vec3(0.0f) : target.positions[v]);
            }
        }
    }

    bool less(std::uint32_t a, std::uint32_t b) const {
        return std::lexicographical_compare(at(a), at(a) + width_, at(b), at(b) + width_);
    }
    bool equal(std::uint32_t a, std::uint32_t b) const { return std::equal(at(a), at(a) + width_, at(b)); }

private:
    const std::uint32_t* at(std::uint32_t v) const { return &words_[v * width_]; }

    static std::uint32_t* put(std::uint32_t* key, const glm::vec3& p) {
        for (int i = 0; i < 3; ++i) *key++ = std::bit_cast<std::uint32_t>(p[i] + 0.0f);  // -0 becomes +0
        return key;
    }

    std::size_t width_;
    std::vector<std::uint32_t> words_;
};

/// No area exactly: the cross product of float differences is exact enough in long double to tell zero from the rest
/// (differences of floats within 2^40 of each other need 64 bits; beyond that a triangle is not degenerate).
/// In meshes that deform only triangles with two equal vertices stay without area.
bool hasNoArea(const Mesh& mesh, const std::uint32_t* v) {
    if (v[0] == v[1] || v[1] == v[2] || v[2] == v[0]) return true;
    if (!mesh.morphTargets.empty() || !mesh.joints.empty()) return false;
    using Real = long double;
    const auto difference = [&](std::uint32_t p, std::uint32_t q, int i) {
        return Real(mesh.positions[p][i]) - Real(mesh.positions[q][i]);
    };
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3;
        const Real x = difference(v[1], v[0], i) * difference(v[2], v[0], j);
        const Real y = difference(v[1], v[0], j) * difference(v[2], v[0], i);
        if (x != y) return false;
    }
    return true;
}

struct HalfEdge {
    std::uint64_t vertices;  // a << 32 | b
    std::uint32_t triangle;
    bool reversed;
};

std::uint64_t edgeKey(std::uint32_t a, std::uint32_t b) {
    return std::uint64_t(a) << 32 | b;
}

/// The order of an edge's ends, by position: edges of different meshes that lie at the same place are drawn alike.
bool comesBefore(const Mesh& mesh, std::uint32_t a, std::uint32_t b) {
    const glm::vec3 &p = mesh.positions[a], &q = mesh.positions[b];
    for (int i = 0; i < 3; ++i) {
        if (p[i] != q[i]) return p[i] < q[i];
    }
    return a < b;
}

class Components {
public:
    explicit Components(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0u); }
    std::uint32_t root(std::uint32_t t) {
        while (parent_[t] != t) t = parent_[t] = parent_[parent_[t]];
        return t;
    }
    void join(std::uint32_t s, std::uint32_t t) { parent_[root(s)] = root(t); }

private:
    std::vector<std::uint32_t> parent_;
};

/// Turns the triangles of one edge into records, pairing opposite directions first: they cancel when both face the
/// light alike, which keeps the records' multiplicities small.
/// @param halves  those that are not reversed first
void appendRecords(std::span<const HalfEdge> halves, std::vector<MeshEdge>& edges) {
    const auto firstReversed = std::ranges::find(halves, true, &HalfEdge::reversed);
    const std::span<const HalfEdge> forward(halves.begin(), firstReversed), backward(firstReversed, halves.end());
    const auto record = [&](const HalfEdge* left, const HalfEdge* right) {
        MeshEdge edge;
        edge.a = std::uint32_t(left->vertices >> 32);
        edge.b = std::uint32_t(left->vertices);
        edge.left = left->triangle;
        edge.leftReversed = left->reversed;
        if (right) {
            edge.right = right->triangle;
            edge.rightReversed = right->reversed;
        }
        edges.push_back(edge);
    };
    const std::size_t pairs = std::min(forward.size(), backward.size());
    for (std::size_t i = 0; i < pairs; ++i) record(&forward[i], &backward[i]);
    const std::span<const HalfEdge> rest = (forward.size() > pairs ? forward : backward).subspan(pairs);
    for (std::size_t i = 0; i < rest.size(); i += 2) record(&rest[i], i + 1 < rest.size() ? &rest[i + 1] : nullptr);
}

}  // namespace

std::vector<std::uint32_t> weldVertices(const Mesh& mesh, std::span<const glm::vec3> displacedAlong) {
    const VertexKeys keys(mesh, displacedAlong);
    std::vector<std::uint32_t> order(mesh.positions.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        if (keys.less(a, b)) return true;
        return !keys.less(b, a) && a < b;
    });
    std::vector<std::uint32_t> welded(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        const bool same = i > 0 && keys.equal(order[i - 1], order[i]);
        welded[order[i]] = same ? welded[order[i - 1]] : order[i];
    }
    return welded;
}

std::vector<glm::vec3> normalsOf(const Mesh& mesh) {
    std::vector<glm::vec3> normals = mesh.normals;
    normals.resize(mesh.positions.size(), glm::vec3(0.0f));
    const auto missing = [](const glm::vec3& n) { return n == glm::vec3(0.0f); };
    if (std::none_of(normals.begin(), normals.end(), missing)) return normals;
    const std::vector<std::uint32_t> welded = weldVertices(mesh);
    std::vector<glm::vec3> sums(normals.size(), glm::vec3(0.0f));
    for (std::uint32_t i = 0; i < 3 * mesh.triangleCount(); i += 3) {
        const auto p = [&](std::uint32_t k) { return mesh.positions[mesh.indices[i + k]]; };
        const glm::vec3 area = glm::cross(p(1) - p(0), p(2) - p(0));
        for (std::uint32_t k = 0; k < 3; ++k) sums[welded[mesh.indices[i + k]]] += area;
    }
    for (std::size_t v = 0; v < normals.size(); ++v) {
        const glm::vec3 sum = sums[welded[v]];
        if (missing(normals[v])) normals[v] = glm::length(sum) > 0.0f ? glm::normalize(sum) : glm::vec3(0, 0, 1);
    }
    return normals;
}

MeshTopology buildTopology(const Mesh& mesh, std::span<const Material> materials,
                           std::span<const glm::vec3> displacedAlong) {
    const std::uint32_t triangleCount = mesh.triangleCount();
    MeshTopology topology;
    topology.casts.assign(triangleCount, true);
    topology.even.assign(triangleCount, false);
    topology.hasArea.assign(triangleCount, true);
    for (const Primitive& primitive : mesh.primitives) {
        if (primitive.topology != Topology::Triangles || primitive.material == kNone) continue;
        if (materials[std::size_t(primitive.material)].alphaMode != AlphaMode::Blend) continue;
        for (std::uint32_t i = 0; i < primitive.indexCount; i += 3)
            topology.casts[(primitive.firstIndex + i) / 3] = false;
    }

    const std::vector<std::uint32_t> welded = weldVertices(mesh, displacedAlong);
    std::vector<HalfEdge> halves;
    halves.reserve(3 * std::size_t(triangleCount));
    std::vector<bool> vertexUsed(welded.size());
    for (std::uint32_t t = 0; t < triangleCount; ++t) {
        const std::uint32_t v[3] = {welded[mesh.indices[3 * t]], welded[mesh.indices[3 * t + 1]],
                                    welded[mesh.indices[3 * t + 2]]};
        if (hasNoArea(mesh, v)) {
            topology.figures.degenerateTriangles += topology.casts[t];
            topology.casts[t] = topology.hasArea[t] = false;
        }
        if (!topology.casts[t]) continue;
        for (int i = 0; i < 3; ++i) {
            const std::uint32_t from = v[i], to = v[(i + 1) % 3];
            vertexUsed[from] = true;
            const bool reversed = comesBefore(mesh, to, from);
            halves.push_back({reversed ? edgeKey(to, from) : edgeKey(from, to), t, reversed});
        }
    }
    std::sort(halves.begin(), halves.end(), [](const HalfEdge& x, const HalfEdge& y) {
        return std::tie(x.vertices, x.reversed, x.triangle) < std::tie(y.vertices, y.reversed, y.triangle);
    });

    Components components(triangleCount);
    std::vector<bool> odd(triangleCount), open(triangleCount);  // marks on some triangle of the component
    topology.edges.reserve(halves.size() / 2);
    auto& figures = topology.figures;
    for (std::size_t begin = 0, end = 0; begin < halves.size(); begin = end) {
        while (end < halves.size() && halves[end].vertices == halves[begin].vertices) ++end;
        const std::span<const HalfEdge> group(&halves[begin], end - begin);
        for (const HalfEdge& half : group) components.join(half.triangle, group.front().triangle);
        if (group.size() % 2) odd[group.front().triangle] = true;
        if (group.size() != 2) open[group.front().triangle] = true;
        ++figures.edges;
        figures.openEdges += group.size() == 1;
        figures.nonManifoldEdges += group.size() > 2;
        if (group.size() == 2 && group[0].reversed == group[1].reversed) {
            ++figures.inconsistentEdges;
            open[group.front().triangle] = true;
        }
        appendRecords(group, topology.edges);
    }

    std::vector<bool> rootOdd(triangleCount), rootOpen(triangleCount);
    for (std::uint32_t t = 0; t < triangleCount; ++t) {
        if (odd[t]) rootOdd[components.root(t)] = true;
        if (open[t]) rootOpen[components.root(t)] = true;
    }
    for (std::uint32_t t = 0; t < triangleCount; ++t) {
        if (!topology.casts[t]) continue;
        const std::uint32_t root = components.root(t);
        topology.even[t] = !rootOdd[root];
        if (root == t) {
            ++figures.components;
            figures.closedComponents += !rootOpen[t];
        }
    }
    figures.weldedVertices = std::uint32_t(std::count(vertexUsed.begin(), vertexUsed.end(), true));
    return topology;
}

}  // namespace umbrage
