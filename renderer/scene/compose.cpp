// SPDX-License-Identifier: Apache-2.0
#include "scene/compose.h"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>

#include "error.h"
#include "job/names.h"
#include "scene/aim.h"
#include "scene/append_scene.h"
#include "scene/compose_parts.h"
#include "scene/generated.h"
#include "scene/idle_channels.h"
#include "scene/node_paths.h"

namespace umbrage {
namespace {

std::vector<Index> animationsCalled(const Scene& scene, const Located<std::string>& wanted) {
    std::vector<Index> found;
    std::vector<std::string> listed;
    for (std::size_t i = 0; i < scene.animations.size(); ++i) {
        if (scene.animations[i].name == wanted.value) found.push_back(static_cast<Index>(i));
        listed.push_back(fmt::format("{} \"{}\"", i, scene.animations[i].name));
    }
    if (!found.empty()) return found;
    std::size_t index = 0;
    const char* end = wanted.value.data() + wanted.value.size();
    const auto [rest, status] = std::from_chars(wanted.value.data(), end, index);
    if (status == std::errc{} && rest == end && index < scene.animations.size()) return {static_cast<Index>(index)};
    throw Error(ErrorKind::Input, wanted.place.text(), fmt::format("there is no animation \"{}\"", wanted.value),
                listed.empty() ? "the scene has no animations" : fmt::format("there are: {}", fmt::join(listed, ", ")));
}

std::vector<Index> chooseAnimations(const Scene& scene, const Job& job) {
    if (!job.animations) return scene.animations.empty() ? std::vector<Index>{} : std::vector<Index>{0};
    std::vector<Index> chosen;
    for (const auto& wanted : *job.animations)
        for (const Index animation : animationsCalled(scene, wanted))
            if (std::find(chosen.begin(), chosen.end(), animation) == chosen.end()) chosen.push_back(animation);
    return chosen;
}

glm::vec3 vectorOf(const std::array<double, 3>& value) {
    return glm::vec3(glm::dvec3(value[0], value[1], value[2]));
}

void addDisplacement(Scene& scene, const JobDisplacement& wanted) {
    const auto isIt = [&](const NameAndMeaning& procedure) { return procedure.name == wanted.kind; };
    const auto kind =
        Displacement::Kind(std::find_if(kProcedures.begin(), kProcedures.end(), isIt) - kProcedures.begin());
    Track amplitude = trackOf(wanted.amplitude, wanted.interpolation);
    for (float& value : amplitude.values) {
        if (kind == Displacement::Kind::Twist) value = glm::radians(value);
    }
    for (const Index node : matchingNodes(scene, wanted.glob, &Node::mesh, "mesh")) {
        std::erase_if(scene.displacements, [&](const Displacement& earlier) { return earlier.node == node; });
        scene.displacements.push_back(
            {node, kind, amplitude, glm::normalize(vectorOf(wanted.axis)), wanted.frequency, wanted.speed});
    }
}

}  // namespace

Composition compose(const Job& job, const GltfOptions& options) {
    Composition composition;
    Scene& scene = composition.scene;
    for (const GltfLayer& layer : job.gltfLayers) addLayer(scene, layer, options);
    for (const GeneratedLayer& layer : job.generatedLayers) appendScene(scene, generatedScene(layer), kNone);
    for (const OverLayer& over : job.overLayers) applyOver(scene, over);
    for (const JobLight& light : job.lights) addLight(scene, light);
    for (const JobDisplacement& displacement : job.displacements) addDisplacement(scene, displacement);
    composition.animations = chooseAnimations(scene, job);

    const double aspect = static_cast<double>(job.image.width) / job.image.height;
    composition.cameraNode = chooseCamera(scene, job.camera);
    const std::vector<Moment> moments = momentsToFrame(scene, composition.animations);
    if (composition.cameraNode == kNone)
        composition.cameraNode = addFramingCamera(scene, moments, aspect);
    else
        noteIfNothingIsSeen(scene, moments, composition.cameraNode, aspect);
    composition.ambientSky = vectorOf(job.image.ambientSky);
    composition.ambientGround = vectorOf(job.image.ambientGround);
    if (nodesWith(scene, &Node::light).empty()) {
        const DefaultAmbient ambient = addDefaultLights(
            scene, placeCamera(scene, evaluate(scene, composition.animations, 0.0), composition.cameraNode));
        if (composition.ambientSky == glm::vec3(0.0f) && composition.ambientGround == glm::vec3(0.0f)) {
            composition.ambientSky = ambient.sky;
            composition.ambientGround = ambient.ground;
        }
    }
    // Split planes go through points of any node.
    if (job.shadow.isSkipOn("channels") && job.shadow.parts.ownSplitPlanes.empty()) {
        composition.idleChannels = dropIdleChannels(scene, composition.animations, composition.cameraNode);
    }
    return composition;
}

}  // namespace umbrage
