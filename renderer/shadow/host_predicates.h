// SPDX-License-Identifier: Apache-2.0
// What the silhouette passes decide about single triangles and edges, on the host. Same expressions in the same order
// as facing.comp, edges.comp and side_hazards.glsl, in an instance's model space.
#pragma once

#include <array>
#include <glm/glm.hpp>

#include "shaders/shared.h"

namespace umbrage {

using TriangleCorners = std::array<glm::vec3, 3>;

/// As in shaders/caster_lists.glsl.
bool mayHoldFarEnds(const gpu::InstanceData& instance, const gpu::CasterState& caster, std::uint32_t l);

/// Which side of the triangle with normal `n` a homogeneous point is on: positive in front.
float sideOf(const glm::vec3& n, const glm::vec3& a, const glm::vec4& p);

/// For a light within the triangle's box, in double: 0 only if it lies in the plane.
float sideOfNearLight(const TriangleCorners& t, const glm::dvec3& light);
bool inBoxOf(const TriangleCorners& t, const glm::vec4& light);

/// Whether the triangle lies between the light and an end of the view rays: the eye, or for an orthographic eye a
/// direction. @param undecided  set where rounding may have decided
bool isOver(const glm::vec4& end, const glm::vec4& light, float lightSide, const TriangleCorners& v, const glm::vec3& n,
            bool& undecided);

/// T4: whether the start of view rays lies on a side, on a triangle.
bool hazardous(const glm::vec4& start, const glm::vec4& light, const glm::vec3& a, const glm::vec3& b);
bool eyeIsOn(const glm::vec4& homogeneousEye, const glm::vec3& n, const TriangleCorners& t);

/// Whether the side behind an edge is seen nearly edge-on.
bool isSliver(const glm::vec4& eye, const glm::vec4& light, const glm::vec3& a, const glm::vec3& b);
/// Whether an end of the view rays lies in the side, as seen from there: it covers nothing and would harm.
bool endsInQuad(const glm::vec4& end, const glm::vec4& light, const glm::vec3& a, const glm::vec3& b);

}  // namespace umbrage
