// SPDX-License-Identifier: Apache-2.0
// What can be told from casters' boxes alone, on the host, in double, on the safe side.
#pragma once

#include <array>
#include <numbers>
#include <span>
#include <vector>

#include "shadow/eye.h"
#include "shadow/geometry.h"
#include "shadow/silhouette.h"

namespace umbrage {

using BoxCorners = std::array<glm::dvec3, 8>;
/// Bit k of a corner's number: high along axis k.
BoxCorners cornersOf(const Geometry::Bounds& box);

/// Per instance: part of it may be nearer than the near plane (T1).
std::vector<bool> nearerThanNearPlane(const Geometry& geometry, std::span<const Geometry::Bounds> modelBounds,
                                      const Eye& eye);

/// Boxes with the world's axes around the instances.
std::vector<Geometry::Bounds> worldBounds(const Geometry& geometry, std::span<const Geometry::Bounds> modelBounds);

/// What a light can shine on, in the world. It is convex: whatever stands between the light and something in it is in
/// it.
struct LightReach {
    ShadowLight light;
    double rangeMetres = 0.0;             // 0: unlimited
    glm::dvec3 axis{0.0};                 // of a spot: unit, the way it shines
    double coneAngle = std::numbers::pi;  // of a spot: from its axis to where its light ends, at most pi / 2
};

/// The smallest box around it; infinite where it is.
Geometry::Bounds boxOf(const LightReach& reach);

/// Whether a box lies wholly out of a light's range or cone: skipping such casters and receivers changes no pixel
/// (docs/rules.md, G6).
bool outOfReach(const Geometry::Bounds& worldBox, const LightReach& reach);

/// Where counts begin, in view space: the picture's rectangle at a distance along the view axis, and a light,
/// homogeneous.
struct StartRectangle {
    const Eye& eye;
    double distance;
};

/// Whether the volume of something in a box may pass through the rectangle: false only if a plane of the pyramid
/// between light and rectangle has the box on its other side.
/// @param corners  of the box, in view space
bool mayReach(const StartRectangle& rectangle, std::span<const glm::dvec3> corners, const glm::dvec4& lightInView);

/// Half the diagonal of what the boxes span; 0 without any.
double radiusOf(std::span<const Geometry::Bounds> boxes);

}  // namespace umbrage
