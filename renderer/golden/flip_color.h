// SPDX-License-Identifier: Apache-2.0
// FLIP's colour spaces (section 4.1 of the paper), relative to the white of Rec.709, D65.
#pragma once

#include <glm/vec3.hpp>

namespace umbrage::flip {

/// Linear Rec.709 to Y, Cx, Cz: L*a*b* made linear, so that it can be filtered. Y is in [-16, 100] for [0, 1].
glm::vec3 ycxczOf(const glm::vec3& linear);
glm::vec3 linearOf(const glm::vec3& ycxcz);

/// Relative luminance of a linear Rec.709 colour: 1 for white.
float luminanceOf(const glm::vec3& linear);

/// Linear Rec.709 to L*a*b*, with a* and b* scaled for Hunt's effect: colours look less saturated where it is dark.
glm::vec3 huntLabOf(const glm::vec3& linear);

/// The distance of two such colours: |dL| + |(da, db)| (HyAB; Abasi et al. 2019).
float hyab(const glm::vec3& a, const glm::vec3& b);

/// Error of colour in [0, 1]: the distance to the power of 0.7, spread so that most of the range belongs to small ones.
float redistributed(float distance);

}  // namespace umbrage::flip
