// SPDX-License-Identifier: Apache-2.0
#include "scene/idle_channels.h"

#include <map>
#include <utility>
#include <vector>

#include "scene/moment.h"

namespace umbrage {
namespace {

/// Per node: something that a picture depends on is placed by it or by a node below.
std::vector<bool> nodesThatPlace(const Scene& scene, Index cameraNode) {
    std::vector<bool> places(scene.nodes.size());
    for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
        const Node& node = scene.nodes[i];
        // Skinned meshes stand where their joints are, wherever their own node is.
        places[i] =
            places[i] || node.light != kNone || Index(i) == cameraNode || (node.mesh != kNone && node.skin == kNone);
        if (node.mesh == kNone || node.skin == kNone) continue;
        for (const Index joint : scene.skins[std::size_t(node.skin)].joints) places[std::size_t(joint)] = true;
    }
    for (std::size_t i = scene.nodes.size(); i-- > 0;) {  // parents come before children
        const Index parent = scene.nodes[i].parent;
        if (parent != kNone && places[i]) places[std::size_t(parent)] = true;
    }
    return places;
}

bool morphs(const Scene& scene, const Node& node) {
    return node.mesh != kNone && !scene.meshes[std::size_t(node.mesh)].morphTargets.empty();
}

void setTo(const Track& track, Target target, Node& node) {
    std::vector<float> value(std::size_t(track.width));
    sample(track, track.timesSeconds.front(), target == Target::Rotation, value);
    switch (target) {
        case Target::Translation:
            node.translation = {value[0], value[1], value[2]};
            break;
        case Target::Rotation:
            node.rotation = glm::normalize(glm::dquat(value[3], value[0], value[1], value[2]));
            break;
        case Target::Scale:
            node.scale = {value[0], value[1], value[2]};
            break;
        case Target::Weights:
            node.morphWeights = value;
            break;
    }
}

}  // namespace

std::size_t dropIdleChannels(Scene& scene, std::span<const Index> playing, Index cameraNode) {
    const std::vector<bool> places = nodesThatPlace(scene, cameraNode);
    std::vector<Animation*> all;
    for (const Index animation : playing) all.push_back(&scene.animations[std::size_t(animation)]);
    for (Animation& driver : scene.drivers) all.push_back(&driver);
    std::map<std::pair<Index, Target>, int> uses;  // the last of several wins
    for (const Animation* animation : all) {
        for (const Channel& channel : animation->channels) ++uses[{channel.node, channel.target}];
    }

    std::size_t dropped = 0;
    for (Animation* animation : all) {
        dropped += std::erase_if(animation->channels, [&](const Channel& channel) {
            Node& node = scene.nodes[std::size_t(channel.node)];
            const bool weights = channel.target == Target::Weights;
            if (weights ? !morphs(scene, node) : !places[std::size_t(channel.node)]) return true;
            const Track& track = animation->tracks[std::size_t(channel.track)];
            if (uses[{channel.node, channel.target}] > 1 || !isConstant(track)) return false;
            setTo(track, channel.target, node);
            return true;
        });
    }
    return dropped;
}

}  // namespace umbrage
