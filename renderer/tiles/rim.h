// SPDX-License-Identifier: Apache-2.0
// Samples beside the image of an edge: there a rasteriser, which snaps corners to its grid, may miss a triangle that
// the view ray meets, and a count that takes it for seen lacks its cap. Host code, no GL.
#pragma once

#include <algorithm>
#include <cmath>

#include "tiles/tile_polygon.h"

namespace umbrage {

/// More than snapping to 1/256 pixel moves a line: sqrt(2)/512, and what floats round.
inline constexpr double kRimPixels = 0x1p-8;

/// Calls visit(column, row) for samples no farther than kRimPixels from the line between two points of view space.
template <class Visit>
void forSamplesBeside(const TileEye& eye, glm::dvec3 a, glm::dvec3 b, const Visit& visit) {
    if (eye.perspective) {
        if (a.z < b.z) std::swap(a, b);
        if (-b.z < eye.znear) return;
        if (-a.z < eye.znear) a += (-eye.znear - a.z) / (b.z - a.z) * (b - a);
    }
    const auto place = [&](const glm::dvec3& p) {
        const glm::dvec2 ndc = glm::dvec2(p) / eye.rayScale / (eye.perspective ? -p.z : 1.0);
        return glm::dvec2(0.5 * (ndc.x + 1.0) * eye.width, 0.5 * (1.0 - ndc.y) * eye.height) - eye.sample;
    };
    glm::dvec2 from = place(a), to = place(b);
    const bool flat = std::abs(to.x - from.x) >= std::abs(to.y - from.y);
    if (!flat) std::swap(from.x, from.y), std::swap(to.x, to.y);
    if (from.x > to.x) std::swap(from, to);
    const int along = flat ? eye.width : eye.height, across = flat ? eye.height : eye.width;
    const double first = std::ceil(std::max(from.x - kRimPixels, 0.0));
    const double last = std::floor(std::min(to.x + kRimPixels, along - 1.0));
    const double slope = to.x > from.x ? (to.y - from.y) / (to.x - from.x) : 0.0;
    const double most = kRimPixels * std::sqrt(1.0 + slope * slope);
    for (double x = first; x <= last; ++x) {
        const double y = from.y + slope * (x - from.x);
        if (!(y > -0.5 && y < across - 0.5)) continue;
        const int nearest = int(y + 0.5);
        if (std::abs(y - nearest) > most) continue;
        if (flat) {
            visit(int(x), nearest);
        } else {
            visit(nearest, int(x));
        }
    }
}

}  // namespace umbrage
