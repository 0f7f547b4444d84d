// SPDX-License-Identifier: Apache-2.0
// A scene at one time: everything animated has its value, everything placed has a world transform in double
// (docs/rules.md, G4).
#pragma once

#include <span>

#include "scene/scene.h"

namespace umbrage {

/// A mesh on a node. Skinned instances ignore their node's transform, as glTF says; their joints carry it.
struct Instance {
    Index node = kNone;
    Index mesh = kNone;
    glm::dmat4 worldFromModel{1.0};
    std::vector<float> morphWeights;            // as many as the mesh has targets
    std::vector<glm::dmat4> worldFromBindPose;  // skinned: one per joint, world * inverse bind; else empty
    Index displacement = kNone;                 // in Scene::displacements

    bool skinned() const { return !worldFromBindPose.empty(); }
};

/// A light with its values at this time; `light` already has them.
struct PlacedLight {
    Index node = kNone;
    std::string id;  // the node's path with '/' as '_' , unique
    Light light;
    glm::dvec3 position{0.0};              // world, metres
    glm::dvec3 direction{0.0, 0.0, -1.0};  // world, unit, the way the light shines
};

struct PlacedCamera {
    Camera camera;
    glm::dmat4 worldFromCamera{1.0};  // rigid: scale of the node's transform is removed
    glm::dvec2 shiftPixels{0.0};  // from where samples lie in their pixels to where the picture is taken: right, down
};

struct Moment {
    double timeSeconds = 0.0;
    std::vector<glm::dmat4> worldFromNode;
    std::vector<Instance> instances;
    std::vector<PlacedLight> lights;
};

/// Which animations play (indices into Scene::animations); drivers always do.
Moment evaluate(const Scene& scene, std::span<const Index> animations, double timeSeconds);

/// The camera on `node` (which must have one) at that moment.
PlacedCamera placeCamera(const Scene& scene, const Moment& moment, Index node);

/// World positions of all vertices of all instances, morphed and skinned but not displaced. Used to frame a default
/// camera, not for culling.
std::vector<glm::dvec3> positionsOf(const Scene& scene, const Moment& moment);

/// Bounds of positionsOf(): {min, max}; {0,0} when there is nothing.
std::array<glm::dvec3, 2> boundsOf(const Scene& scene, const Moment& moment);

/// Evaluates a track at a time; `result` has track.width floats. Rotations are tracks of width 4 (x, y, z, w)
/// interpolated on the sphere when `spherical` is set and normalised.
void sample(const Track& track, double timeSeconds, bool spherical, std::span<float> result);

/// Whether it has the same value at all times, bit for bit.
bool isConstant(const Track& track);

}  // namespace umbrage
