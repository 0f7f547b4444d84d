// SPDX-License-Identifier: Apache-2.0
// How much counting by a split plane will cost, guessed from a few places of the picture: what automatic parts and
// planes are chosen by. A wrong guess costs time, never a pixel.
#pragma once

#include <span>
#include <vector>

#include "shadow/split_plane.h"

namespace umbrage {

/// What is seen at a place of the picture.
struct DepthSample {
    glm::dvec2 ndc{0.0};
    double depth = 0.0;  // as in the depth buffer
};

/// A part as far as the guess needs it, in the space that `eye.viewFromWorld` starts from.
struct PartOutline {
    std::vector<glm::dvec3> extremes;
    double sidesMetres = 0.0;  // length of the edges whose sides its volume has
};

/// The shadow of a convex hull of points on screen: planes (as ScreenPlane::plane, not turned) that what it holds is on
/// the positive sides of. Empty where the light is so near that the hull surrounds it: then it may be anywhere.
/// @param perimeter  of the hull as the light sees it, in metres where the hull is
std::vector<glm::dvec4> shadowOnScreen(std::span<const glm::dvec3> points, const Homogeneous& light, const Eye& eye,
                                       double& perimeter);

/// Count changes to be expected, summed over the samples: those of the volume's layers, which are taken to be spread
/// evenly through it, that lie between a sample and the plane, and its caps where they are counted.
double expectedUpdates(const PartOutline& part, const ScreenPlane& plane, const Homogeneous& light, const Eye& eye,
                       std::span<const DepthSample> samples);

}  // namespace umbrage
