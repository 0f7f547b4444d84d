// SPDX-License-Identifier: Apache-2.0
// Where a perspective eye of a given direction has to stand to see everything, as large as it gets.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <vector>

namespace umbrage {

/// Fed with points one after the other, in any number: only the outlines of their projections along x and along y are
/// kept, which is all that matters. Coordinates are those of the view's axes, x right, y up, z towards the viewer.
class Framing {
public:
    void add(const glm::dvec3& point);

    struct Eye {
        glm::dvec3 position;
        double nearestDistance;  // along the view, of the nearest point; positive
    };

    /// The nearest eye whose picture holds all points, with equal room on opposite sides. Without points, or with a
    /// single one, it looks at it from some way off.
    /// @param halfExtents  of the picture at distance 1
    Eye eye(const glm::dvec2& halfExtents) const;

private:
    std::array<std::vector<glm::dvec2>, 2> outlines_;  // (x, z) and (y, z): hulls, then points not yet looked at
    std::array<std::size_t, 2> reduceAt_{1024, 1024};
};

}  // namespace umbrage
