// SPDX-License-Identifier: Apache-2.0
// Where the volumes of a light need not go on: behind everything it can shine on (T2), and out of view. Decided on the
// host from boxes, in double, on the safe side.
#pragma once

#include <array>
#include <span>

#include "shadow/bounds.h"

namespace umbrage {

/// Half space n.x <= offset.
struct HalfSpace {
    glm::dvec3 normal{0.0};
    double offset = 0.0;
};

/// The box around all that a light can shine on and the eye. No view ray leaves it before it meets a receiver, so
/// beyond one of its faces a volume holds nothing. Of an orthographic eye the view rays come in through some faces.
class LightExtent {
public:
    static constexpr std::size_t kFaces = 6;

    /// @param receivers  boxes with the world's axes, a little larger than what is in them
    LightExtent(std::span<const Geometry::Bounds> receivers, const LightReach& reach, const Eye& eye);

    /// The face behind which a caster's volume may end, so that it is short: 1 + its number, or 0 for none. All rays of
    /// the light through the caster pass that face outwards, so the whole end is in one plane: ends in several would
    /// cut the box's edges.
    /// @param caster  of its box in the world
    std::uint32_t endOf(const BoxCorners& caster) const;

    /// In view space, normal and offset: a little outside the box.
    std::array<glm::vec4, kFaces> facesInView(const Eye& eye) const;

private:
    std::array<HalfSpace, kFaces> faces_;
    std::array<bool, kFaces> open_{};  // view rays come in there
    ShadowLight light_;
};

/// Half spaces whose common part is the view: through the eye, or of an orthographic eye parallel.
std::array<HalfSpace, 4> sidesOfView(const Eye& eye);

/// Whether a box lies outside one side of the view.
bool outOfView(const BoxCorners& box, std::span<const HalfSpace> sidesOfView);

/// Whether a caster and its whole volume lie outside one side of the view: then no view ray meets either.
bool outOfView(const BoxCorners& caster, const ShadowLight& light, std::span<const HalfSpace> sidesOfView);

}  // namespace umbrage
