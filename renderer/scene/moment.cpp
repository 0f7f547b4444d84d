// SPDX-License-Identifier: Apache-2.0
#include "scene/moment.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <unordered_map>
#include <unordered_set>

namespace umbrage {
namespace {

template <class T>
const T& at(const std::vector<T>& vector, Index index) {
    assert(index >= 0 && static_cast<std::size_t>(index) < vector.size());
    return vector[static_cast<std::size_t>(index)];
}

/// What animation replaces: a node's own transform and morph weights.
struct Pose {
    glm::dvec3 translation;
    glm::dquat rotation;
    glm::dvec3 scale;
    const std::optional<glm::dmat4>* matrix;
    std::vector<float> morphWeights;  // empty: not animated
};

std::vector<Pose> restPose(const Scene& scene) {
    std::vector<Pose> poses;
    poses.reserve(scene.nodes.size());
    for (const Node& node : scene.nodes) {
        poses.push_back({node.translation, node.rotation, node.scale, &node.matrix, {}});
    }
    return poses;
}

void apply(const Animation& animation, double timeSeconds, std::vector<Pose>& poses) {
    std::vector<float> value;
    for (const Channel& channel : animation.channels) {
        const Track& track = at(animation.tracks, channel.track);
        value.resize(static_cast<std::size_t>(track.width));
        sample(track, timeSeconds, channel.target == Target::Rotation, value);
        Pose& pose = poses[static_cast<std::size_t>(channel.node)];
        switch (channel.target) {
            case Target::Translation:
                pose.translation = {value[0], value[1], value[2]};
                break;
            case Target::Rotation:
                pose.rotation = glm::normalize(glm::dquat(value[3], value[0], value[1], value[2]));
                break;
            case Target::Scale:
                pose.scale = {value[0], value[1], value[2]};
                break;
            case Target::Weights:
                pose.morphWeights = value;
                break;
        }
    }
}

glm::dmat4 localMatrix(const Pose& pose) {
    if (pose.matrix->has_value()) {
        return **pose.matrix;
    }
    glm::dmat4 matrix = glm::mat4_cast(pose.rotation);
    for (int column = 0; column < 3; ++column) {
        matrix[column] *= pose.scale[column];
    }
    matrix[3] = glm::dvec4(pose.translation, 1.0);
    return matrix;
}

std::vector<glm::dmat4> composeTransforms(const Scene& scene, const std::vector<Pose>& poses) {
    std::vector<glm::dmat4> worldFromNode;
    worldFromNode.reserve(scene.nodes.size());
    for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
        const Index parent = scene.nodes[i].parent;
        const glm::dmat4 local = localMatrix(poses[i]);
        worldFromNode.push_back(parent == kNone ? local : at(worldFromNode, parent) * local);
    }
    return worldFromNode;
}

std::vector<float> morphWeights(const Node& node, const Pose& pose, const Mesh& mesh) {
    std::vector<float> weights = !pose.morphWeights.empty()   ? pose.morphWeights
                                 : !node.morphWeights.empty() ? node.morphWeights
                                                              : mesh.defaultMorphWeights;
    weights.resize(mesh.morphTargets.size());
    return weights;
}

std::vector<Instance> placeInstances(const Scene& scene, const std::vector<Pose>& poses,
                                     const std::vector<glm::dmat4>& worldFromNode) {
    std::unordered_map<Index, Index> displacements;
    for (std::size_t i = 0; i < scene.displacements.size(); ++i) {
        displacements[scene.displacements[i].node] = static_cast<Index>(i);
    }
    std::vector<Instance> instances;
    for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
        const Node& node = scene.nodes[i];
        if (node.mesh == kNone) {
            continue;
        }
        Instance instance;
        instance.node = static_cast<Index>(i);
        instance.mesh = node.mesh;
        instance.morphWeights = morphWeights(node, poses[i], at(scene.meshes, node.mesh));
        if (node.skin == kNone) {
            instance.worldFromModel = worldFromNode[i];
        } else {
            const Skin& skin = at(scene.skins, node.skin);
            for (std::size_t j = 0; j < skin.joints.size(); ++j) {
                instance.worldFromBindPose.push_back(at(worldFromNode, skin.joints[j]) *
                                                     glm::dmat4(skin.jointFromMesh[j]));
            }
        }
        if (const auto found = displacements.find(instance.node); found != displacements.end()) {
            instance.displacement = found->second;
        }
        instances.push_back(std::move(instance));
    }
    return instances;
}

// "/Courtyard/Lamp" -> "Courtyard_Lamp". Different paths can meet ("/A_B", "/A/B"), so a taken name gets an index.
std::string lightId(const std::string& path, std::unordered_set<std::string>& taken) {
    std::string base = path.starts_with('/') ? path.substr(1) : path;
    std::replace(base.begin(), base.end(), '/', '_');
    std::string id = base;
    for (int suffix = 1; !taken.insert(id).second; ++suffix) {
        id = fmt::format("{}_{}", base, suffix);
    }
    return id;
}

void apply(const LightTrack& lightTrack, double timeSeconds, Light& light) {
    std::array<float, 3> value{};
    sample(lightTrack.track, timeSeconds, false,
           std::span(value).first(static_cast<std::size_t>(lightTrack.track.width)));
    switch (lightTrack.property) {
        case LightProperty::Intensity:
            light.intensity = value[0];
            break;
        case LightProperty::Color:
            light.color = {value[0], value[1], value[2]};
            break;
        case LightProperty::Range:
            light.rangeMetres = value[0];
            break;
        case LightProperty::InnerConeAngle:
            light.innerConeAngle = value[0];
            break;
        case LightProperty::OuterConeAngle:
            light.outerConeAngle = value[0];
            break;
    }
}

glm::dvec3 unitOr(const glm::dvec3& vector, const glm::dvec3& otherwise) {
    const double length = glm::length(vector);
    return length > 0.0 ? vector / length : otherwise;
}

std::vector<PlacedLight> placeLights(const Scene& scene, const std::vector<glm::dmat4>& worldFromNode,
                                     double timeSeconds) {
    std::vector<PlacedLight> lights;
    std::unordered_map<Index, std::size_t> lightOfNode;
    std::unordered_set<std::string> ids;
    for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
        const Node& node = scene.nodes[i];
        if (node.light == kNone) {
            continue;
        }
        PlacedLight placed;
        placed.node = static_cast<Index>(i);
        placed.id = lightId(node.path, ids);
        placed.light = at(scene.lights, node.light);
        placed.position = worldFromNode[i][3];
        // A node scaled to nothing has no direction left; the light's own is as good as any.
        placed.direction = unitOr(-glm::dvec3(worldFromNode[i][2]), {0.0, 0.0, -1.0});
        lightOfNode[placed.node] = lights.size();
        lights.push_back(std::move(placed));
    }
    for (const LightTrack& track : scene.lightTracks) {
        const auto found = lightOfNode.find(track.node);
        assert(found != lightOfNode.end());
        apply(track, timeSeconds, lights[found->second].light);
    }
    return lights;
}

glm::dvec3 morphedPosition(const Mesh& mesh, const Instance& instance, std::size_t vertex) {
    glm::dvec3 position(mesh.positions[vertex]);
    for (std::size_t target = 0; target < mesh.morphTargets.size(); ++target) {
        const double weight = instance.morphWeights[target];
        const std::vector<glm::vec3>& displacements = mesh.morphTargets[target].positions;
        if (weight != 0.0 && !displacements.empty()) {
            position += weight * glm::dvec3(displacements[vertex]);
        }
    }
    return position;
}

glm::dvec3 worldPosition(const Mesh& mesh, const Instance& instance, std::size_t vertex) {
    const glm::dvec4 position(morphedPosition(mesh, instance, vertex), 1.0);
    if (!instance.skinned()) {
        return glm::dvec3(instance.worldFromModel * position);
    }
    glm::dvec4 result(0.0);
    const std::size_t sets = mesh.influenceSets();
    for (std::size_t entry = vertex * sets; entry < (vertex + 1) * sets; ++entry) {
        for (int c = 0; c < 4; ++c) {
            const double weight = mesh.weights[entry][c];
            if (weight != 0.0) {
                result += weight * (instance.worldFromBindPose[mesh.joints[entry][c]] * position);
            }
        }
    }
    return glm::dvec3(result);
}

}  // namespace

Moment evaluate(const Scene& scene, std::span<const Index> animations, double timeSeconds) {
    std::vector<Pose> poses = restPose(scene);
    for (const Index animation : animations) {
        apply(at(scene.animations, animation), timeSeconds, poses);
    }
    for (const Animation& driver : scene.drivers) {
        apply(driver, timeSeconds, poses);
    }
    Moment moment;
    moment.timeSeconds = timeSeconds;
    moment.worldFromNode = composeTransforms(scene, poses);
    moment.instances = placeInstances(scene, poses, moment.worldFromNode);
    moment.lights = placeLights(scene, moment.worldFromNode, timeSeconds);
    return moment;
}

PlacedCamera placeCamera(const Scene& scene, const Moment& moment, Index node) {
    const glm::dmat4& world = at(moment.worldFromNode, node);
    // The view direction is kept exactly, the up direction as far as it stays at right angles to it; mirroring is lost.
    const glm::dvec3 backward = unitOr(world[2], {0.0, 0.0, 1.0});
    const glm::dvec3 up(world[1]);
    const glm::dvec3 anyUp = std::abs(backward.y) < 0.9 ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(1.0, 0.0, 0.0);
    const glm::dvec3 right = unitOr(glm::cross(up, backward), glm::normalize(glm::cross(anyUp, backward)));
    PlacedCamera placed;
    placed.camera = at(scene.cameras, at(scene.nodes, node).camera);
    placed.worldFromCamera = glm::dmat4(glm::dvec4(right, 0.0), glm::dvec4(glm::cross(backward, right), 0.0),
                                        glm::dvec4(backward, 0.0), glm::dvec4(glm::dvec3(world[3]), 1.0));
    return placed;
}

std::vector<glm::dvec3> positionsOf(const Scene& scene, const Moment& moment) {
    std::vector<glm::dvec3> positions;
    for (const Instance& instance : moment.instances) {
        const Mesh& mesh = at(scene.meshes, instance.mesh);
        for (std::size_t vertex = 0; vertex < mesh.positions.size(); ++vertex) {
            positions.push_back(worldPosition(mesh, instance, vertex));
        }
    }
    return positions;
}

std::array<glm::dvec3, 2> boundsOf(const Scene& scene, const Moment& moment) {
    const std::vector<glm::dvec3> positions = positionsOf(scene, moment);
    if (positions.empty()) {
        return {};
    }
    std::array<glm::dvec3, 2> bounds{positions.front(), positions.front()};
    for (const glm::dvec3& position : positions) {
        bounds[0] = glm::min(bounds[0], position);
        bounds[1] = glm::max(bounds[1], position);
    }
    return bounds;
}

}  // namespace umbrage
