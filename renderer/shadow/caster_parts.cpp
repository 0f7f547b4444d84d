// SPDX-License-Identifier: Apache-2.0
#include "shadow/caster_parts.h"

#include <algorithm>
#include <set>

#include "error.h"
#include "scene/node_paths.h"

namespace umbrage {
namespace {

/// Those points that lie farthest in 26 directions: what boxes, axes and outlines need.
std::vector<glm::dvec3> extremesOf(std::span<const glm::vec3> points) {
    std::set<std::size_t> kept;
    for (int x = -1; x <= 1 && !points.empty(); ++x) {
        for (int y = -1; y <= 1; ++y) {
            for (int z = -1; z <= 1; ++z) {
                const glm::vec3 direction(x, y, z);
                std::size_t farthest = 0;
                for (std::size_t i = 1; i < points.size(); ++i) {
                    if (glm::dot(points[i], direction) > glm::dot(points[farthest], direction)) farthest = i;
                }
                if (x != 0 || y != 0 || z != 0) kept.insert(farthest);
            }
        }
    }
    std::vector<glm::dvec3> extremes;
    for (const std::size_t i : kept) extremes.emplace_back(points[i]);
    return extremes;
}

std::optional<SplitPlaneKind> kindNamed(const std::string& name) {
    if (name == "auto") return {};
    return name == "point-point-light" ? SplitPlaneKind::PointPointLight : SplitPlaneKind::PointCameraLight;
}

}  // namespace

CasterParts::CasterParts(const Scene& scene, const Moment& first, const Geometry& geometry, const JobParts& wanted)
    : groups_(groupInstances(scene, first.instances, wanted.globs)) {
    given_.resize(groups_.count());
    for (std::uint32_t g = 0; g < groups_.count(); ++g) {
        given_[g].choice.kind = kindNamed(wanted.splitPlane);
        for (const JobSplitPlane& own : wanted.ownSplitPlanes) {
            if (!matchesGlob(own.glob.value, scene.nodes[std::size_t(groups_.nodes[g])].path)) continue;
            given_[g].choice.kind = kindNamed(own.plane);
            if (!own.points) continue;
            given_[g].pointsNode = groups_.nodes[g];
            given_[g].choice.points.emplace();
            for (std::size_t k = 0; k < 2; ++k) {
                const std::array<double, 3>& p = (*own.points)[k];
                (*given_[g].choice.points)[k] = {p[0], p[1], p[2]};
            }
        }
    }
    clustersOf_.resize(groups_.count());
    std::vector<std::uint32_t> ofPlaced(geometry.placedTriangleCount());
    for (std::uint32_t i = 0; i < geometry.instanceCount(); ++i) {
        const gpu::InstanceData& instance = geometry.instances()[i];
        const auto cluster = std::uint32_t(clusters_.size());
        clustersOf_[groups_.ofInstance[i]].push_back(cluster);
        clusters_.push_back({i, {}});
        if (!geometry.hasOwnVertices(i)) {
            clusters_.back().extremes = extremesOf(scene.meshes[geometry.meshOf(i)].positions);
        }
        for (std::uint32_t t = 0; t < instance.triangleCount; ++t) {
            ofPlaced[instance.placedTriangleBase + t] = cluster;
        }
    }
    onDevice_.setClusters(std::move(ofPlaced), std::uint32_t(clusters_.size()));
}

std::vector<glm::dvec3> CasterParts::pointsOf(std::span<const std::uint32_t> clusters, const Moment& moment,
                                              const Geometry& geometry) const {
    std::vector<glm::dvec3> points;
    for (const std::uint32_t c : clusters) {
        const std::uint32_t i = clusters_[c].instance;
        for (const glm::dvec3& p : clusters_[c].extremes) {
            points.emplace_back(moment.instances[i].worldFromModel * glm::dvec4(p, 1.0));
        }
        if (!clusters_[c].extremes.empty()) continue;
        for (int corner = 0; corner < 8; ++corner) {
            glm::dvec4 p(bounds_[i].low, 1.0);
            for (int k = 0; k < 3; ++k) {
                if (corner >> k & 1) p[k] = bounds_[i].high[k];
            }
            points.emplace_back(geometry.worldFromModel(i) * p);
        }
    }
    return points;
}

void CasterParts::choose(const Moment& moment, const Geometry& geometry, std::span<const Homogeneous> lights,
                         std::uint32_t firstLight, const Eye& eye) {
    bounds_ = geometry.modelBounds();
    std::vector<LightParts> chosen(lights.size());
    for (LightParts& light : chosen) light.ofCluster.resize(clusters_.size());
    for (std::uint32_t g = 0; g < groups_.count(); ++g) {
        SplitChoice choice = given_[g].choice;
        if (choice.points) {
            for (glm::dvec3& p : *choice.points) {
                p = glm::dvec3(moment.worldFromNode[std::size_t(given_[g].pointsNode)] * glm::dvec4(p, 1.0));
            }
        }
        const PartShape shape = shapeOf(pointsOf(clustersOf_[g], moment, geometry));
        for (std::size_t l = 0; l < lights.size(); ++l) {
            for (const std::uint32_t c : clustersOf_[g]) chosen[l].ofCluster[c] = std::uint32_t(chosen[l].parts.size());
            chosen[l].parts.push_back(splitPoints(shape, choice, lights[l]));
        }
    }
    onDevice_.set(chosen, firstLight, eye);
}

}  // namespace umbrage
