// SPDX-License-Identifier: Apache-2.0
#include "shadow/caster_parts.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "scene/node_paths.h"

namespace umbrage {
namespace {

std::optional<SplitPlaneKind> kindNamed(const std::string& name) {
    if (name == "auto") return {};
    return name == "point-point-light" ? SplitPlaneKind::PointPointLight : SplitPlaneKind::PointCameraLight;
}

std::vector<glm::dvec3> transformed(std::span<const glm::dvec3> points, const glm::dmat4& m) {
    std::vector<glm::dvec3> result;
    for (const glm::dvec3& p : points) result.emplace_back(m * glm::dvec4(p, 1.0));
    return result;
}

}  // namespace

/// From where a light's volumes are seen.
struct CasterParts::View {
    const Homogeneous& light;
    const Eye& eye;
    std::span<const DepthSample> samples;
};

CasterParts::CasterParts(const Scene& scene, const Moment& first, const Geometry& geometry, const JobParts& wanted)
    : automatic_(wanted.automatic), parts_(groupInstances(scene, first.instances, wanted.globs)) {
    readGroups(scene, first, wanted);
    makeClusters(scene, geometry);
}

bool CasterParts::wantsSamples() const {
    return std::any_of(groups_.begin(), groups_.end(),
                       [](const Group& group) { return group.tree || (!group.choice.kind && !group.choice.points); });
}

void CasterParts::readGroups(const Scene& scene, const Moment& first, const JobParts& wanted) {
    groups_.resize(parts_.count());
    for (std::uint32_t i = 0; i < first.instances.size(); ++i) groups_[parts_.ofInstance[i]].instances.push_back(i);
    for (std::uint32_t g = 0; g < groups_.size(); ++g) groups_[g].choice.kind = kindNamed(wanted.splitPlane);
    for (const JobSplitPlane& own : wanted.ownSplitPlanes) {
        bool any = false;
        std::vector<std::string> paths;
        for (std::uint32_t g = 0; g < groups_.size(); ++g) {
            paths.push_back(scene.nodes[std::size_t(parts_.nodes[g])].path);
            if (!matchesGlob(own.glob.value, paths.back())) continue;
            any = true;
            groups_[g].choice = {kindNamed(own.plane), {}};
            if (!own.points) continue;
            groups_[g].pointsNode = parts_.nodes[g];
            const auto& [p, q] = *own.points;
            groups_[g].choice.points = {glm::dvec3(p[0], p[1], p[2]), glm::dvec3(q[0], q[1], q[2])};
        }
        if (!any) refuseGlob(own.glob, "part of the casters to itself", paths);
    }
}

void CasterParts::makeClusters(const Scene& scene, const Geometry& geometry) {
    trees_.resize(scene.meshes.size());
    extremesOfMeshes_.resize(scene.meshes.size());
    std::vector<std::uint32_t> ofPlaced(geometry.placedTriangleCount());
    std::uint32_t clusters = 0;
    for (Group& group : groups_) {
        group.firstCluster = clusters;
        for (const std::uint32_t i : group.instances) {
            const gpu::InstanceData& instance = geometry.instances()[i];
            const std::uint32_t mesh = geometry.meshOf(i);
            const bool rigid = !geometry.hasOwnVertices(i);
            if (rigid && extremesOfMeshes_[mesh].empty()) {
                extremesOfMeshes_[mesh] = extremesOf(scene.meshes[mesh].positions);
            }
            if (rigid && automatic_ && !group.choice.points) {
                if (trees_[mesh].nodes.empty()) {
                    trees_[mesh] = buildClusters(scene.meshes[mesh], geometry.topologies()[mesh]);
                }
                group.tree = &trees_[mesh];
            }
            for (std::uint32_t t = 0; t < instance.triangleCount; ++t) {
                ofPlaced[instance.placedTriangleBase + t] =
                    group.firstCluster + (group.tree ? group.tree->leafOfTriangle[t] : 0);
            }
        }
        clusters += group.tree ? group.tree->nodes[0].leafCount : 1;
    }
    onDevice_.setClusters(std::move(ofPlaced), clusters);
}

std::vector<glm::dvec3> CasterParts::pointsOf(const Group& group, const Moment& moment, const Geometry& geometry,
                                              std::span<const Geometry::Bounds> bounds) const {
    std::vector<glm::dvec3> points;
    for (const std::uint32_t i : group.instances) {
        std::vector<glm::dvec3> own;
        if (!geometry.hasOwnVertices(i)) {
            own = transformed(extremesOfMeshes_[geometry.meshOf(i)], moment.instances[i].worldFromModel);
        } else {
            own = transformed(cornersOf(bounds[i]), geometry.worldFromModel(i));
        }
        points.insert(points.end(), own.begin(), own.end());
    }
    return points;
}

void CasterParts::choose(const Moment& moment, const Geometry& geometry, std::span<const Geometry::Bounds> modelBounds,
                         std::span<const Homogeneous> lights, std::uint32_t firstLight, const Eye& eye,
                         std::span<const DepthSample> samples) {
    chosen_.assign(lights.size(), {});
    for (LightParts& light : chosen_) light.ofCluster.resize(onDevice_.clusterCount());
    for (const Group& group : groups_) {
        SplitChoice choice = group.choice;
        if (choice.points) {
            const glm::dmat4& worldFromNode = moment.worldFromNode[std::size_t(group.pointsNode)];
            for (glm::dvec3& p : *choice.points) p = glm::dvec3(worldFromNode * glm::dvec4(p, 1.0));
        }
        const std::vector<glm::dvec3> points = pointsOf(group, moment, geometry, modelBounds);
        for (std::size_t l = 0; l < lights.size(); ++l) {
            addParts(group, choice, points, {lights[l], eye, samples},
                     moment.instances[group.instances[0]].worldFromModel, chosen_[l]);
        }
    }
    onDevice_.set(chosen_, firstLight, eye);
}

/// The plane of a part that changes fewest counts.
CasterParts::Candidate CasterParts::best(const SplitChoice& choice, const PartOutline& outline, const View& view) {
    const PartShape shape = shapeOf(outline.extremes);
    const auto guessed = [&](const SplitPoints& made) -> Candidate {
        const ScreenPlane plane = screenPlane(made, view.light, view.eye);
        return {made, expectedUpdates(outline, plane, view.light, view.eye, view.samples)};
    };
    if (choice.kind || choice.points || view.samples.empty()) return guessed(splitPoints(shape, choice, view.light));
    Candidate best = guessed({{}, SplitPoints::Kind::Nowhere});
    for (const SplitPlaneKind kind : {SplitPlaneKind::PointCameraLight, SplitPlaneKind::PointPointLight}) {
        const Candidate tried = guessed(splitPoints(shape, {kind, {}}, view.light));
        if (tried.updates < best.updates) best = tried;
    }
    return best;
}

/// @param points  of the whole group
void CasterParts::addParts(const Group& group, const SplitChoice& choice, std::span<const glm::dvec3> points,
                           const View& view, const glm::dmat4& worldFromModel, LightParts& parts) const {
    if (!group.tree || group.tree->nodes.size() == 1) {
        const PartOutline outline{{points.begin(), points.end()}, 0.0};
        parts.ofCluster[group.firstCluster] = std::uint32_t(parts.parts.size());
        parts.parts.push_back(best(choice, outline, view).plane);
        parts.extremes.push_back(outline.extremes);
        return;
    }
    constexpr double kWorthIt = 0.95;  // a division that is guessed to save less is not made
    const std::vector<ClusterTree::Node>& nodes = group.tree->nodes;
    const double scale = std::cbrt(std::abs(glm::determinant(glm::dmat3(worldFromModel))));
    std::vector<Candidate> candidates(nodes.size());
    for (std::size_t n = nodes.size(); n-- > 0;) {  // children first
        const double sides = scale * (nodes[n].outlineMetres + nodes[n].borderMetres);
        candidates[n] = best(choice, {transformed(nodes[n].extremes, worldFromModel), sides}, view);
        if (nodes[n].isLeaf()) continue;
        const double apart = candidates[nodes[n].children[0]].updates + candidates[nodes[n].children[1]].updates;
        if (apart < kWorthIt * candidates[n].updates) candidates[n] = {candidates[n].plane, apart, true};
    }
    const std::function<void(std::uint32_t)> add = [&](std::uint32_t n) {
        if (candidates[n].divided) {
            for (const std::uint32_t child : nodes[n].children) add(child);
            return;
        }
        for (std::uint32_t leaf = nodes[n].firstLeaf; leaf < nodes[n].firstLeaf + nodes[n].leafCount; ++leaf) {
            parts.ofCluster[group.firstCluster + leaf] = std::uint32_t(parts.parts.size());
        }
        parts.parts.push_back(candidates[n].plane);
        parts.extremes.push_back(transformed(nodes[n].extremes, worldFromModel));
    };
    add(0);
}

}  // namespace umbrage
