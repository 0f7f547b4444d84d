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
/// @param aspect  width / height
Index addFramingCamera(Scene& scene, const Moment& moment, double aspect);
void addDefaultLights(Scene& scene, const PlacedCamera& camera);

}  // namespace umbrage
