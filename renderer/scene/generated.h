// SPDX-License-Identifier: Apache-2.0
// Scenes of any size, made from a few numbers: to see how cost grows with triangles, silhouettes, lights, depth and
// what moves.
#pragma once

#include "job/job.h"
#include "scene/scene.h"

namespace umbrage {

/// A ground of 24 x 24 metres (/Ground), bodies over it (/Body0 ...), point lights above (/Light0 ...), a camera that
/// glides (/Camera) and one animation of two seconds. Triangles are as many as asked for but for those of half a row
/// of a body. The same to the last bit for the same numbers on every machine.
Scene generatedScene(const GeneratedLayer& layer);

/// A closed mesh of 8 k^2 triangles, outside outwards: an octahedron whose edges are cut into k, its vertices pushed
/// onto a sphere and along its radii by noise.
/// @param extents  of the sphere along the axes, metres
/// @param roughness  largest push, in parts of the radius; below 1
Mesh noisyBody(int k, const glm::dvec3& extents, double roughness, std::uint32_t seed);

}  // namespace umbrage
