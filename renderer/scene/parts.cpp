// SPDX-License-Identifier: Apache-2.0
#include "scene/parts.h"

#include <fmt/core.h>

#include <algorithm>
#include <limits>
#include <map>

#include "error.h"
#include "job/nearest.h"
#include "scene/node_paths.h"

namespace umbrage {
namespace {

/// Directions in which a symmetric matrix stretches most and second most (by Jacobi's rotations).
std::array<glm::dvec3, 2> principalAxes(glm::dmat3 m) {
    glm::dmat3 axes(1.0);
    for (int sweep = 0; sweep < 12; ++sweep) {
        for (int p = 0; p < 2; ++p) {
            for (int q = p + 1; q < 3; ++q) {
                if (m[p][q] == 0.0) continue;
                const double theta = 0.5 * (m[q][q] - m[p][p]) / m[p][q];
                const double t = (theta < 0.0 ? -1.0 : 1.0) / (std::abs(theta) + std::sqrt(theta * theta + 1.0));
                const double c = 1.0 / std::sqrt(t * t + 1.0), s = t * c;
                glm::dmat3 rotation(1.0);
                rotation[p][p] = rotation[q][q] = c;
                rotation[q][p] = s;
                rotation[p][q] = -s;
                m = glm::transpose(rotation) * m * rotation;
                axes = axes * rotation;
            }
        }
    }
    std::array<int, 3> order{0, 1, 2};
    std::sort(order.begin(), order.end(), [&](int i, int j) { return m[i][i] > m[j][j]; });
    return {axes[order[0]], axes[order[1]]};
}

struct Extent {
    double least = std::numeric_limits<double>::max(), most = -least;

    double length() const { return most - least; }
};

Extent extentAlong(std::span<const glm::dvec3> points, const glm::dvec3& origin, const glm::dvec3& axis) {
    Extent extent;
    for (const glm::dvec3& point : points) {
        const double along = glm::dot(point - origin, axis);
        extent.least = std::min(extent.least, along);
        extent.most = std::max(extent.most, along);
    }
    return extent;
}

/// Whether a mesh hangs on a node or below it.
std::vector<bool> nodesAboveMeshes(const Scene& scene) {
    std::vector<bool> above(scene.nodes.size());
    for (std::size_t n = scene.nodes.size(); n-- > 0;) {  // parents come before children
        const Node& node = scene.nodes[n];
        if (node.mesh != kNone) above[n] = true;
        if (above[n] && node.parent != kNone) above[std::size_t(node.parent)] = true;
    }
    return above;
}

}  // namespace

InstanceParts groupInstances(const Scene& scene, std::span<const Instance> instances,
                             std::span<const Located<std::string>> globs) {
    const std::vector<bool> aboveMeshes = nodesAboveMeshes(scene);
    std::vector<bool> matched(scene.nodes.size());
    for (const Located<std::string>& glob : globs) {
        bool any = false;
        for (std::size_t n = 0; n < scene.nodes.size(); ++n) {
            if (!aboveMeshes[n] || !matchesGlob(glob.value, scene.nodes[n].path)) continue;
            matched[n] = any = true;
        }
        if (any) continue;
        std::vector<std::string> paths;
        for (std::size_t n = 0; n < scene.nodes.size(); ++n) {
            if (aboveMeshes[n]) paths.push_back(scene.nodes[n].path);
        }
        throw Error(ErrorKind::Input, glob.place.text(),
                    fmt::format("\"{}\" matches no node with a mesh at or below it", glob.value),
                    paths.empty() ? "the scene has no mesh" : hintForName(glob.value, paths));
    }
    InstanceParts parts;
    std::map<Index, std::uint32_t> partOfNode;
    for (const Instance& instance : instances) {
        Index node = instance.node;
        while (node != kNone && !matched[std::size_t(node)]) node = scene.nodes[std::size_t(node)].parent;
        if (node == kNone) node = instance.node;
        const auto [found, isNew] = partOfNode.emplace(node, parts.count());
        if (isNew) parts.nodes.push_back(node);
        parts.ofInstance.push_back(found->second);
    }
    return parts;
}

PartShape shapeOf(std::span<const glm::dvec3> points) {
    PartShape shape;
    if (points.empty()) return shape;
    shape.low = shape.high = points[0];
    glm::dvec3 mean(0.0);
    for (const glm::dvec3& point : points) {
        shape.low = glm::min(shape.low, point);
        shape.high = glm::max(shape.high, point);
        mean += point / double(points.size());
    }
    glm::dmat3 spread(0.0);
    for (const glm::dvec3& point : points) spread += glm::outerProduct(point - mean, point - mean);
    const auto [axis, next] = principalAxes(spread);
    const Extent extent = extentAlong(points, mean, axis);
    shape.axisEnds[0] = mean + extent.least * axis;
    shape.axisEnds[1] = mean + extent.most * axis;
    const double across = extentAlong(points, mean, next).length();
    if (extent.length() > 0.0) {
        shape.thinness = across > 0.0 ? extent.length() / across : std::numeric_limits<double>::infinity();
    }
    return shape;
}

}  // namespace umbrage
