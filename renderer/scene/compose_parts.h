// SPDX-License-Identifier: Apache-2.0
// The steps of compose(), in their order.
#pragma once

#include <span>

#include "job/job.h"
#include "scene/load_gltf.h"
#include "scene/moment.h"

namespace umbrage {

/// compose_layers.cpp: loads the layer and hangs it into the scene.
void addLayer(Scene& scene, const GltfLayer& layer, GltfOptions options);

/// compose_lights.cpp: over:, then lights:.
void applyOver(Scene& scene, const OverLayer& over);
void addLight(Scene& scene, const JobLight& light);

/// compose_camera.cpp: the node of the job's camera; kNone when it names none and the scene has none.
Index chooseCamera(Scene& scene, const JobCamera& camera);

/// compose_defaults.cpp: what a scene without camera or lights gets; says so in the scene's notes.
/// Moments over the whole of the animations that play, so that a camera framed on them is the same whichever frames are
/// asked for.
std::vector<Moment> momentsToFrame(const Scene& scene, std::span<const Index> animations);
/// @param aspect  width / height
Index addFramingCamera(Scene& scene, std::span<const Moment> moments, double aspect);
void noteIfNothingIsSeen(Scene& scene, std::span<const Moment> moments, Index camera, double aspect);

struct DefaultAmbient {
    glm::vec3 sky, ground;
};
DefaultAmbient addDefaultLights(Scene& scene, const PlacedCamera& camera);

}  // namespace umbrage
