// SPDX-License-Identifier: Apache-2.0
// Exact answers to geometric questions about doubles: decided in floating point where a bound on its error allows it,
// else in exact arithmetic; never by a tolerance.
//
// Conventions: a triangle hides what is behind its interior; lines that meet an edge exactly pass beside it as if the
// light (or the ray's direction) were moved by an infinitesimal, the same for all triangles of the edge, so that a
// closed surface has no gaps and counts nothing twice. A triangle in whose plane the light or the point lies hides
// nothing.
#pragma once

#include "oracle/formulas.h"

namespace umbrage::oracle {

/// 1: the light (homogeneous) is in front of the triangle, -1: behind, 0: in its plane, or the triangle has no area.
int sideOfLight(const Corners& t, const glm::dvec4& light);

/// 1: the ray looks at its front, -1: at its back, 0: along its plane.
int sideOfRay(const Corners& t, const Ray& ray);

/// Whether the whole line of the ray, before or behind its origin, passes through the triangle.
bool meets(const Ray& ray, const Corners& t);

/// -1: the ray meets the plane of `t` before that of `other`, 0: at the same place, 1: later. Neither is seen edge-on.
int compareDepth(const Ray& ray, const Corners& t, const Corners& other);
/// The same against a place E + distance * d.
int compareDepth(const Ray& ray, const Corners& t, double distance);

/// The place where a ray meets the plane of the triangle that is seen there, which is not seen edge-on.
class SurfacePoint {
public:
    SurfacePoint(const Ray& ray, const Corners& seen);

    /// At most `within` (metres) and a few units in the last place away.
    glm::dvec3 position(double within) const;

    /// Whether the open segment from here to the light (homogeneous; the half-line, where it is at infinity) passes
    /// through the triangle.
    bool hiddenBy(const Corners& t, const glm::dvec4& light) const;

    /// Whether the triangle holds the point in its plane and is turned away from the eye or from the light, so that its
    /// shadow lies before it.
    bool shadedSideOf(const Corners& t, const glm::dvec4& light) const;

private:
    Ray ray_;
    Corners seen_;
    glm::dvec3 rounded_;
    double error_;  // in each coordinate
};

}  // namespace umbrage::oracle
