// SPDX-License-Identifier: Apache-2.0
// What can be told from casters' boxes alone, on the host, in double, on the safe side.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "shadow/eye.h"
#include "shadow/geometry.h"

namespace umbrage {

using BoxCorners = std::array<glm::dvec3, 8>;
/// Bit k of a corner's number: high along axis k.
BoxCorners cornersOf(const Geometry::Bounds& box);

/// Per instance: part of it may be nearer than the near plane (T1).
std::vector<bool> nearerThanNearPlane(const Geometry& geometry, std::span<const Geometry::Bounds> modelBounds,
                                      const Eye& eye);

/// Boxes with the world's axes around the instances.
std::vector<Geometry::Bounds> worldBounds(const Geometry& geometry, std::span<const Geometry::Bounds> modelBounds);

/// Whether a box lies wholly out of a light's range. Whatever stands between such a light and a point in its range is
/// in range too, so skipping the rest as caster and receiver changes no pixel (docs/rules.md, G6).
bool outOfReach(const Geometry::Bounds& worldBox, const glm::dvec3& lightPosition, double rangeMetres);

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
