// SPDX-License-Identifier: Apache-2.0
// From where and how wide the faces of a light's shadow map look. Host code, no GL.
#pragma once

#include <vector>

#include "shadow/bounds.h"

namespace umbrage {

inline constexpr double kWidestSpot = 1.2;  // radians from the axis: wider, and a flat map is mostly border

/// @param boxes  of what is there, in the world
/// @param unseen  of them, those out of the eye's view
/// @return eyes in the light or, of a directional one, before everything that casts: one, or six with the world's
///         axes (+X, -X, +Y ...), or none where nothing is seen
std::vector<Eye> shadowMapFaces(const PlacedLight& light, std::span<const Geometry::Bounds> boxes,
                                const std::vector<bool>& unseen, const Eye& eye);

}  // namespace umbrage
