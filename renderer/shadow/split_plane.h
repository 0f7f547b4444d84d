// SPDX-License-Identifier: Apache-2.0
// Split planes (Laine 2005): a plane through a part's shadow volume says at which pixels the part is counted by z-pass
// (what is seen there lies on the eye's side) and at which by z-fail. Any plane gives the same shadows as long as all
// polygons of the part meet the same decision at a pixel; a good one leaves few of them between itself and what is
// seen. Pure functions, in double; the device builds its planes by the same formulas (split_planes.comp).
#pragma once

#include <array>
#include <optional>

#include "scene/parts.h"
#include "shadow/eye.h"

namespace umbrage {

/// n.p + d = 0 as (n, d). Not normalised; all zero where a construction is degenerate, which decides as any plane does.
using Plane = glm::dvec4;

/// A homogeneous point: (position, 1), or (direction towards it, 0) for a directional light or an orthographic eye.
using Homogeneous = glm::dvec4;

/// Through the light and `p`, turned as far towards the eye as that leaves (his section 4.1).
Plane pointCameraLight(const glm::dvec3& p, const Homogeneous& eye, const Homogeneous& light);

/// Through the light and two points: for what is long and thin (his section 4.2).
Plane pointPointLight(const glm::dvec3& p1, const glm::dvec3& p2, const Homogeneous& light);

enum class SplitPlaneKind { PointCameraLight, PointPointLight };

/// How a part's plane is chosen; nothing given: automatically.
struct SplitChoice {
    std::optional<SplitPlaneKind> kind;
    std::optional<std::array<glm::dvec3, 2>> points;  // instead of the ends of its longest axis; imply PointPointLight
};

/// Point-point-light for parts that are thin (at least 4 times as long as wide) as the light sees them, too.
SplitPlaneKind automaticKind(const PartShape& shape, const Homogeneous& light);

/// All in one space.
Plane splitPlane(const PartShape& shape, const SplitChoice& choice, const Homogeneous& eye, const Homogeneous& light);

/// A plane as pixels are held against it: the inner product with (NDC x, NDC y, depth, 1) is positive where what has
/// that depth lies on the eye's side. NDC are the picture's, -1 to 1, y up; depth is the depth buffer's: reversed, 1 at
/// the near plane, 0 at infinity (perspective) or at zfar.
struct ScreenPlane {
    glm::dvec4 plane{0.0};

    /// The split test: true counts by z-pass, false by z-fail. Division-free (his section 4.3); an eye in the plane
    /// makes all pixels z-fail.
    bool passes(const glm::dvec2& ndc, double depth) const {
        return plane.x * ndc.x + plane.y * ndc.y + plane.z * depth + plane.w > 0.0;
    }
};

/// @param plane  in the space that `eye.viewFromWorld` starts from
ScreenPlane screenPlane(const Plane& plane, const Eye& eye);

/// What stands for a tile in its split test; his tests took the farthest, which favours z-fail.
enum class SplitAgainst { Farthest, Nearest };

/// The split test of a whole tile, at its centre (his section 5.2).
/// @param nearestDepth, farthestDepth  in the tile; reversed: nearest is the larger
inline bool tilePasses(const ScreenPlane& plane, const glm::dvec2& centerNdc, double nearestDepth, double farthestDepth,
                       SplitAgainst against) {
    return plane.passes(centerNdc, against == SplitAgainst::Farthest ? farthestDepth : nearestDepth);
}

}  // namespace umbrage
