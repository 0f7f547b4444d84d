// SPDX-License-Identifier: Apache-2.0
// What a scene without a camera or without lights gets, so that a bare model gives a picture.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <glm/trigonometric.hpp>

#include "scene/aim.h"
#include "scene/compose_parts.h"
#include "scene/framing.h"
#include "scene/node_paths.h"

namespace umbrage {
namespace {

// A white diffuse surface that faces the key light has a radiance of 1.6, which the ACES view shows as bright but not
// as burnt out. Metals reflect nothing of a light that is not in the mirror direction, so there is an ambient term too.
constexpr float kKeyLux = 4.0f, kFillLux = 1.0f;
constexpr glm::vec3 kAmbientSky{0.35f}, kAmbientGround{0.15f};

void addDirectional(Scene& scene, const std::string& name, float lux, const glm::dvec3& towardsLight) {
    const Index node = addNode(scene, kNone, name, freePath(scene, "/lights/" + name));
    scene.nodes[static_cast<std::size_t>(node)].light = static_cast<Index>(scene.lights.size());
    scene.nodes[static_cast<std::size_t>(node)].rotation = lookRotation(-towardsLight);
    scene.lights.push_back({.name = name, .type = LightType::Directional, .intensity = lux});
}

/// Whether all positions lie behind the eye or all beyond the same edge of the picture.
bool seesNothing(const Scene& scene, const Moment& moment, const PlacedCamera& placed, double aspect) {
    const Camera& camera = placed.camera;
    const glm::dmat4 viewFromWorld = glm::inverse(placed.worldFromCamera);
    const double halfHeight = camera.perspective ? std::tan(0.5 * camera.yfov) : camera.ymag;
    const glm::dvec2 half(halfHeight * aspect, halfHeight);
    bool insideOf[6] = {};
    for (const glm::dvec3& position : positionsOf(scene, moment)) {
        const glm::dvec3 p(viewFromWorld * glm::dvec4(position, 1.0));
        const glm::dvec2 edge = half * (camera.perspective ? -p.z : 1.0);
        const double beyond = camera.zfar > 0.0 ? camera.zfar + p.z : 1.0;
        const double depths[] = {edge.x - p.x, edge.x + p.x, edge.y - p.y, edge.y + p.y, -p.z - camera.znear, beyond};
        for (std::size_t i = 0; i < std::size(depths); ++i) insideOf[i] = insideOf[i] || depths[i] > 0.0;
    }
    return !std::all_of(std::begin(insideOf), std::end(insideOf), [](bool inside) { return inside; });
}

}  // namespace

std::vector<Moment> momentsToFrame(const Scene& scene, std::span<const Index> animations) {
    double seconds = 0.0;
    for (const Index i : animations)
        seconds = std::max(seconds, scene.animations[static_cast<std::size_t>(i)].durationSeconds());
    for (const Animation& driver : scene.drivers) seconds = std::max(seconds, driver.durationSeconds());
    const int intervals = seconds > 0.0 ? 8 : 0;
    std::vector<Moment> moments;
    for (int i = 0; i <= intervals; ++i)
        moments.push_back(evaluate(scene, animations, intervals ? seconds * i / intervals : 0.0));
    return moments;
}

Index addFramingCamera(Scene& scene, std::span<const Moment> moments, double aspect) {
    constexpr double kYfovDegrees = 40.0;
    constexpr double kFilled = 0.9;  // of the picture; the rest is margin, also for bodies that deform
    const double halfHeight = std::tan(0.5 * glm::radians(kYfovDegrees));
    const glm::dvec3 back = glm::normalize(glm::dvec3(0.5, 0.4, 0.8));  // glTF's figures face +Z
    const glm::dmat3 worldFromView = glm::mat3_cast(lookRotation(-back));
    Framing framing;
    for (const Moment& moment : moments)
        for (const glm::dvec3& position : positionsOf(scene, moment)) framing.add(position * worldFromView);
    const Framing::Eye eye = framing.eye(kFilled * halfHeight * glm::dvec2(aspect, 1.0));

    const Index node = addNode(scene, kNone, "camera", freePath(scene, "/camera"));
    Node& placed = scene.nodes[static_cast<std::size_t>(node)];
    placed.translation = worldFromView * eye.position;
    placed.rotation = lookRotation(-back);
    placed.camera = static_cast<Index>(scene.cameras.size());
    scene.cameras.push_back({.name = "camera", .yfov = glm::radians(kYfovDegrees), .znear = 0.1 * eye.nearestDistance});
    scene.notes.push_back(fmt::format("the scene has no camera: one at ({:.4g}, {:.4g}, {:.4g}) sees all of it",
                                      placed.translation.x, placed.translation.y, placed.translation.z));
    return node;
}

void noteIfNothingIsSeen(Scene& scene, std::span<const Moment> moments, Index camera, double aspect) {
    const bool nothing = std::all_of(moments.begin(), moments.end(), [&](const Moment& moment) {
        return seesNothing(scene, moment, placeCamera(scene, moment, camera), aspect);
    });
    if (!nothing || scene.meshes.empty()) return;
    scene.notes.push_back(
        fmt::format("the camera {} sees nothing of the scene, as far as was tried; --camera chooses another, --set "
                    "camera={{position: [x, y, z], target: [x, y, z]}} describes one",
                    scene.nodes[static_cast<std::size_t>(camera)].path));
}

DefaultAmbient addDefaultLights(Scene& scene, const PlacedCamera& camera) {
    const glm::dvec3 right(camera.worldFromCamera[0]), back(camera.worldFromCamera[2]), up(0.0, 1.0, 0.0);
    addDirectional(scene, "key", kKeyLux, glm::normalize(-0.7 * right + 0.9 * up + 0.6 * back));
    addDirectional(scene, "fill", kFillLux, glm::normalize(right + 0.3 * up + 0.4 * back));
    scene.notes.push_back(
        fmt::format("the scene has no lights: /lights/key ({} lux, from the left above) and /lights/fill ({} lux, from "
                    "the right) were added",
                    kKeyLux, kFillLux));
    return {kAmbientSky, kAmbientGround};
}

}  // namespace umbrage
