// SPDX-License-Identifier: Apache-2.0
// over: and lights:.
#include <fmt/core.h>

#include <algorithm>
#include <glm/trigonometric.hpp>
#include <optional>

#include "error.h"
#include "scene/aim.h"
#include "scene/compose_parts.h"
#include "scene/node_paths.h"

namespace umbrage {
namespace {

Node& nodeAt(Scene& scene, Index node) {
    return scene.nodes[static_cast<std::size_t>(node)];
}
Light& lightOn(Scene& scene, Index node) {
    return scene.lights[static_cast<std::size_t>(scene.nodes[static_cast<std::size_t>(node)].light)];
}

/// glTF nodes may share a light, opinions are of one node.
void makeLightUnshared(Scene& scene, Index node) {
    Node& owner = nodeAt(scene, node);
    const auto users = std::count_if(scene.nodes.begin(), scene.nodes.end(),
                                     [&](const Node& other) { return other.light == owner.light; });
    if (users == 1) return;
    scene.lights.push_back(Light(lightOn(scene, node)));
    owner.light = static_cast<Index>(scene.lights.size()) - 1;
}

float* valueOf(Light& light, LightProperty property) {
    switch (property) {
        case LightProperty::Intensity:
            return &light.intensity;
        case LightProperty::Color:
            return &light.color.x;
        case LightProperty::Range:
            return &light.rangeMetres;
        case LightProperty::InnerConeAngle:
            return &light.innerConeAngle;
        case LightProperty::OuterConeAngle:
            return &light.outerConeAngle;
    }
    return nullptr;
}

bool hasProperty(LightType type, LightProperty property) {
    if (property == LightProperty::Range) return type != LightType::Directional;
    if (property == LightProperty::InnerConeAngle || property == LightProperty::OuterConeAngle)
        return type == LightType::Spot;
    return true;
}

bool isTrackOf(const LightTrack& track, Index node, LightProperty property) {
    return track.node == node && track.property == property;
}

template <int N>
void setProperty(Scene& scene, Index node, LightProperty property, const std::optional<Sampled<N>>& opinion,
                 KeyInterpolation interpolation) {
    if (!opinion || !hasProperty(lightOn(scene, node).type, property)) return;
    std::erase_if(scene.lightTracks, [&](const LightTrack& track) { return isTrackOf(track, node, property); });
    const Track track = trackOf(*opinion, interpolation);
    std::copy_n(track.values.begin(), N, valueOf(lightOn(scene, node), property));
    if (opinion->animated()) scene.lightTracks.push_back({node, property, track});
}

const Track* trackFor(const Scene& scene, Index node, LightProperty property) {
    for (const LightTrack& track : scene.lightTracks)
        if (isTrackOf(track, node, property)) return &track.track;
    return nullptr;
}

/// Both angles are linear or constant between the keys of either, so their order at the keys is their order everywhere.
void checkCones(Scene& scene, Index node, const std::string& where) {
    if (lightOn(scene, node).type != LightType::Spot) return;
    const Track* inner = trackFor(scene, node, LightProperty::InnerConeAngle);
    const Track* outer = trackFor(scene, node, LightProperty::OuterConeAngle);
    std::vector<float> times{0.0f};
    for (const Track* track : {inner, outer})
        if (track) times.insert(times.end(), track->timesSeconds.begin(), track->timesSeconds.end());
    for (const float time : times) {
        float innerAngle = lightOn(scene, node).innerConeAngle, outerAngle = lightOn(scene, node).outerConeAngle;
        if (inner) sample(*inner, time, false, {&innerAngle, 1});
        if (outer) sample(*outer, time, false, {&outerAngle, 1});
        if (innerAngle >= outerAngle)
            throw Error(ErrorKind::Input, where,
                        fmt::format("the inner cone of {} ({:.4g} degrees) is not narrower than the outer one ({:.4g})",
                                    nodeAt(scene, node).path, glm::degrees(innerAngle), glm::degrees(outerAngle)),
                        "set both angles");
    }
}

/// The places of a light's cone opinions, else that of the whole.
std::string conePlace(const LightOpinion& opinion, const Place& whole) {
    if (opinion.innerConeAngle) return opinion.innerConeAngle->place.text();
    if (opinion.outerConeAngle) return opinion.outerConeAngle->place.text();
    return whole.text();
}

void applyOpinion(Scene& scene, Index node, const LightOpinion& opinion, const Place& place) {
    const KeyInterpolation interpolation = opinion.interpolation;
    setProperty(scene, node, LightProperty::Intensity, opinion.intensity, interpolation);
    setProperty(scene, node, LightProperty::Color, opinion.color, interpolation);
    setProperty(scene, node, LightProperty::Range, opinion.rangeMetres, interpolation);
    setProperty(scene, node, LightProperty::InnerConeAngle, opinion.innerConeAngle, interpolation);
    setProperty(scene, node, LightProperty::OuterConeAngle, opinion.outerConeAngle, interpolation);
    if (opinion.innerConeAngle || opinion.outerConeAngle) checkCones(scene, node, conePlace(opinion, place));
}

/// An opinion that none of the lights can follow is a mistake.
void requireProperty(Scene& scene, const std::vector<Index>& nodes, LightProperty property,
                     const std::optional<Sampled<1>>& opinion, const char* types) {
    if (!opinion) return;
    for (const Index node : nodes)
        if (hasProperty(lightOn(scene, node).type, property)) return;
    throw Error(ErrorKind::Input, opinion->place.text(),
                fmt::format("this is only for {} lights, and {} is none", types, nodeAt(scene, nodes.front()).path));
}

LightType typeOf(JobLightType type) {
    switch (type) {
        case JobLightType::Point:
            return LightType::Point;
        case JobLightType::Spot:
            return LightType::Spot;
        case JobLightType::Directional:
            return LightType::Directional;
    }
    return {};
}

}  // namespace

void applyOver(Scene& scene, const OverLayer& over) {
    const std::vector<Index> nodes = matchingNodes(scene, over.glob, &Node::light, "light");
    requireProperty(scene, nodes, LightProperty::Range, over.light.rangeMetres, "point and spot");
    requireProperty(scene, nodes, LightProperty::InnerConeAngle, over.light.innerConeAngle, "spot");
    requireProperty(scene, nodes, LightProperty::OuterConeAngle, over.light.outerConeAngle, "spot");
    for (const Index node : nodes) {
        makeLightUnshared(scene, node);
        applyOpinion(scene, node, over.light, over.glob.place);
    }
}

void addLight(Scene& scene, const JobLight& light) {
    const Index node = addNode(scene, kNone, light.name.value, freePath(scene, "/lights/" + light.name.value));
    nodeAt(scene, node).light = static_cast<Index>(scene.lights.size());
    scene.lights.push_back({.name = light.name.value, .type = typeOf(light.type)});
    applyOpinion(scene, node, light.light, light.name.place);
    aim(scene, node, light.position, light.type == JobLightType::Point ? nullptr : &light.target,
        light.light.interpolation);
}

}  // namespace umbrage
