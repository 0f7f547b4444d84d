// SPDX-License-Identifier: Apache-2.0
// A job's layers, lights and camera as one Scene.
//
// Layers: without `at` and transform a file's roots are roots of the scene. `at: /A/B` names the node they hang under;
// parts of it that no earlier layer has are made as plain nodes, the last of which carries the layer's transform. A
// transform without `at`, or at a node that was there before, gets a node of its own in between, named after the file.
// Where a path exists already, the newcomer gets an index: /Lamp_1. Opinions (over:) are laid over all layers, in
// order.
#pragma once

#include <vector>

#include "job/job.h"
#include "scene/load_gltf.h"
#include "scene/scene.h"

namespace umbrage {

struct Composition {
    Scene scene;
    Index cameraNode = kNone;
    std::vector<Index> animations;                    // which of the scene's play; its drivers always do
    glm::vec3 ambientSky{0.0f}, ambientGround{0.0f};  // the job's, or that of the default lights
    std::size_t idleChannels = 0;                     // of what plays, left out: see idle_channels.h
};

/// Names of animations stand for all animations of that name; indices count through the layers. A camera's index counts
/// the nodes that have one. What the job leaves open is chosen and said in the scene's notes: a camera framed on
/// what there is, a rig of two lights with an ambient term.
/// @throws Error(Input) with the job's place for what the job names and the scene lacks; as loadGltf()
Composition compose(const Job& job, const GltfOptions& options = {});

}  // namespace umbrage
