// SPDX-License-Identifier: Apache-2.0
// What a scene without a camera or without lights gets, so that a bare model gives a picture.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <glm/trigonometric.hpp>

#include "scene/aim.h"
#include "scene/compose_parts.h"
#include "scene/node_paths.h"

namespace umbrage {
namespace {

// White diffuse surfaces that face the key light come out at 0.95 of display white before the view's curve.
constexpr float kKeyLux = 3.0f, kFillLux = 0.8f;

void addDirectional(Scene& scene, const std::string& name, float lux, const glm::dvec3& towardsLight) {
    const Index node = addNode(scene, kNone, name, freePath(scene, "/lights/" + name));
    scene.nodes[static_cast<std::size_t>(node)].light = static_cast<Index>(scene.lights.size());
    scene.nodes[static_cast<std::size_t>(node)].rotation = lookRotation(-towardsLight);
    scene.lights.push_back({.name = name, .type = LightType::Directional, .intensity = lux});
}

}  // namespace

Index addFramingCamera(Scene& scene, const Moment& moment, double aspect) {
    const auto [least, most] = boundsOf(scene, moment);
    const glm::dvec3 center = 0.5 * (least + most);
    const double halfDiagonal = 0.5 * glm::length(most - least);
    const double radius = halfDiagonal > 0.0 ? halfDiagonal : 1.0;

    // The sphere around the bounds touches the narrower side of the picture, less a margin of a twentieth.
    constexpr double kYfovDegrees = 45.0, kMargin = 1.05;
    const double halfY = 0.5 * glm::radians(kYfovDegrees);
    const double halfNarrow = std::min(halfY, std::atan(std::tan(halfY) * aspect));
    const double distance = kMargin * radius / std::sin(halfNarrow);
    const glm::dvec3 fromCenter = glm::normalize(glm::dvec3(0.55, 0.4, 0.75));  // glTF's figures face +Z

    const Index node = addNode(scene, kNone, "camera", freePath(scene, "/camera"));
    Node& placed = scene.nodes[static_cast<std::size_t>(node)];
    placed.translation = center + distance * fromCenter;
    placed.rotation = lookRotation(-fromCenter);
    placed.camera = static_cast<Index>(scene.cameras.size());
    // Deforming meshes may leave their bounds, towards the eye as well as away from it.
    scene.cameras.push_back(
        {.name = "camera", .yfov = 2.0 * halfY, .znear = 0.1 * (distance - radius), .zfar = distance + 10.0 * radius});
    scene.notes.push_back(fmt::format("the scene has no camera: one at ({:.4g}, {:.4g}, {:.4g}) sees all of it",
                                      placed.translation.x, placed.translation.y, placed.translation.z));
    return node;
}

void addDefaultLights(Scene& scene, const PlacedCamera& camera) {
    const glm::dvec3 right(camera.worldFromCamera[0]), back(camera.worldFromCamera[2]), up(0.0, 1.0, 0.0);
    addDirectional(scene, "key", kKeyLux, glm::normalize(-0.7 * right + 0.9 * up + 0.6 * back));
    addDirectional(scene, "fill", kFillLux, glm::normalize(right + 0.3 * up + 0.4 * back));
    scene.notes.push_back(
        fmt::format("the scene has no lights: /lights/key ({} lux, from the left above) and /lights/fill ({} lux, from "
                    "the right) were added",
                    kKeyLux, kFillLux));
}

}  // namespace umbrage
