// SPDX-License-Identifier: Apache-2.0
#include "scene/clusters.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "scene/parts.h"

namespace umbrage {
namespace {

constexpr std::size_t kLeafTriangles = 48;    // fewer are not divided
constexpr std::size_t kPieceTriangles = 256;  // pieces of no more are not divided
constexpr std::uint32_t kMostLeaves = 128;    // so that a choice among them stays cheap

/// Sets of triangles that edges join, by a member of each.
class Pieces {
public:
    Pieces(const MeshTopology& topology) : parent_(topology.casts.size()) {
        std::iota(parent_.begin(), parent_.end(), 0u);
        for (const MeshEdge& edge : topology.edges) {
            if (edge.right != MeshEdge::kNoTriangle) parent_[rootOf(edge.left)] = rootOf(edge.right);
        }
        size_.resize(parent_.size());
        for (std::uint32_t t = 0; t < parent_.size(); ++t) size_[rootOf(t)] += topology.casts[t];
    }
    std::uint32_t rootOf(std::uint32_t t) {
        while (parent_[t] != t) t = parent_[t] = parent_[parent_[t]];
        return t;
    }
    std::size_t sizeOf(std::uint32_t t) { return size_[rootOf(t)]; }

private:
    std::vector<std::uint32_t> parent_;
    std::vector<std::size_t> size_;
};

class Builder {
public:
    Builder(const Mesh& mesh, const MeshTopology& topology) : mesh_(mesh), topology_(topology), pieces_(topology) {
        tree_.leafOfTriangle.assign(topology.casts.size(), 0);
        findCenters();
        std::vector<std::uint32_t> all;
        for (std::uint32_t t = 0; t < topology.casts.size(); ++t) {
            if (topology.casts[t]) all.push_back(t);
        }
        divide(all, kMostLeaves);
        measure();
    }

    ClusterTree take() && { return std::move(tree_); }

private:
    glm::dvec3 corner(std::uint32_t t, std::uint32_t k) const {
        return glm::dvec3(mesh_.positions[mesh_.indices[3 * t + k]]);
    }

    /// What triangles are told apart by: their own centre, or that of a small piece.
    void findCenters() {
        centers_.resize(topology_.casts.size());
        std::vector<glm::dvec3> sums(centers_.size(), glm::dvec3(0.0));
        for (std::uint32_t t = 0; t < centers_.size(); ++t) {
            if (!topology_.casts[t]) continue;
            centers_[t] = (corner(t, 0) + corner(t, 1) + corner(t, 2)) / 3.0;
            sums[pieces_.rootOf(t)] += centers_[t];
        }
        for (std::uint32_t t = 0; t < centers_.size(); ++t) {
            const std::size_t size = pieces_.sizeOf(t);
            if (size > 0 && size <= kPieceTriangles) centers_[t] = sums[pieces_.rootOf(t)] / double(size);
        }
    }

    /// @return the node made of these triangles
    std::uint32_t divide(std::vector<std::uint32_t>& triangles, std::uint32_t mostLeaves) {
        const auto node = std::uint32_t(tree_.nodes.size());
        tree_.nodes.emplace_back();
        std::vector<glm::vec3> points;
        for (const std::uint32_t t : triangles) {
            for (std::uint32_t k = 0; k < 3; ++k) points.emplace_back(corner(t, k));
        }
        tree_.nodes[node].extremes = extremesOf(points);
        tree_.nodes[node].firstLeaf = leaves_;
        std::vector<glm::dvec3> centers;
        for (const std::uint32_t t : triangles) centers.push_back(centers_[t]);
        const PartShape shape = shapeOf(centers);
        const glm::dvec3 axis = shape.axisEnds[1] - shape.axisEnds[0];
        std::vector<std::uint32_t> far;
        if (triangles.size() >= 2 * kLeafTriangles && mostLeaves > 1) far = takeFarHalf(triangles, axis);
        if (far.empty() || triangles.empty()) {
            triangles.insert(triangles.end(), far.begin(), far.end());
            for (const std::uint32_t t : triangles) tree_.leafOfTriangle[t] = leaves_;
            ++leaves_;
            return node;
        }
        const std::uint32_t near = divide(triangles, mostLeaves / 2);
        const std::uint32_t second = divide(far, mostLeaves / 2);
        tree_.nodes[node].children[0] = near;
        tree_.nodes[node].children[1] = second;
        tree_.nodes[node].leafCount = leaves_ - tree_.nodes[node].firstLeaf;
        return node;
    }

    /// Removes those beyond the middle one along the axis.
    std::vector<std::uint32_t> takeFarHalf(std::vector<std::uint32_t>& triangles, const glm::dvec3& axis) const {
        const auto along = [&](std::uint32_t t) { return glm::dot(centers_[t], axis); };
        const auto middle = triangles.begin() + std::ptrdiff_t(triangles.size() / 2);
        std::nth_element(triangles.begin(), middle, triangles.end(),
                         [&](std::uint32_t a, std::uint32_t b) { return along(a) < along(b); });
        const double border = along(*middle);  // a piece in the middle stays on the near side, whole
        const auto far =
            std::partition(triangles.begin(), triangles.end(), [&](std::uint32_t t) { return along(t) <= border; });
        std::vector<std::uint32_t> taken(far, triangles.end());
        triangles.erase(far, triangles.end());
        return taken;
    }

    /// A sphere of n triangles has an outline of about 0.93 / sqrt(n) of the length of all its edges; pieces of any
    /// other shape are taken for as rough.
    void measure() {
        std::vector<double> outline(leaves_);
        std::vector<std::vector<std::pair<std::uint32_t, double>>> shared(leaves_);  // leaf -> other leaf, metres
        for (const MeshEdge& edge : topology_.edges) {
            const double length =
                glm::distance(glm::dvec3(mesh_.positions[edge.a]), glm::dvec3(mesh_.positions[edge.b]));
            const std::uint32_t left = tree_.leafOfTriangle[edge.left];
            outline[left] += 0.93 * length / std::sqrt(double(pieces_.sizeOf(edge.left)));
            if (edge.right == MeshEdge::kNoTriangle) continue;
            const std::uint32_t right = tree_.leafOfTriangle[edge.right];
            if (left != right) shared[left].emplace_back(right, length), shared[right].emplace_back(left, length);
        }
        for (ClusterTree::Node& node : tree_.nodes) {
            for (std::uint32_t leaf = node.firstLeaf; leaf < node.firstLeaf + node.leafCount; ++leaf) {
                node.outlineMetres += outline[leaf];
                for (const auto& [other, length] : shared[leaf]) {
                    const bool outside = other < node.firstLeaf || other >= node.firstLeaf + node.leafCount;
                    if (outside) node.borderMetres += length;
                }
            }
        }
    }

    const Mesh& mesh_;
    const MeshTopology& topology_;
    Pieces pieces_;
    std::vector<glm::dvec3> centers_;
    std::uint32_t leaves_ = 0;
    ClusterTree tree_;
};

}  // namespace

ClusterTree buildClusters(const Mesh& mesh, const MeshTopology& topology) {
    return Builder(mesh, topology).take();
}

std::vector<glm::dvec3> extremesOf(std::span<const glm::vec3> points) {
    std::set<std::size_t> kept;
    for (int direction = 0; direction < 27 && !points.empty(); ++direction) {
        const glm::vec3 along(direction % 3 - 1, direction / 3 % 3 - 1, direction / 9 - 1);
        std::size_t farthest = 0;
        for (std::size_t i = 1; i < points.size(); ++i) {
            if (glm::dot(points[i], along) > glm::dot(points[farthest], along)) farthest = i;
        }
        kept.insert(farthest);
    }
    std::vector<glm::dvec3> extremes;
    for (const std::size_t i : kept) extremes.emplace_back(points[i]);
    return extremes;
}

}  // namespace umbrage
