// SPDX-License-Identifier: Apache-2.0
#include "bench/depth_bounds.h"

#include <algorithm>

namespace umbrage {
namespace {

using glm::dvec3;
using glm::dvec4;
using Outline = std::vector<dvec4>;  // homogeneous, in the eye's space

constexpr double kMargin = 0x1p-20;  // what the depth buffer and interpolation round (docs/rules.md, T9)

Outline clipped(const Outline& outline, const dvec4& plane) {
    Outline kept;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const dvec4 &p = outline[i], &q = outline[(i + 1) % outline.size()];
        const double atP = glm::dot(plane, p), atQ = glm::dot(plane, q);
        if (atP >= 0.0) kept.push_back(p);
        if ((atP > 0.0 && atQ < 0.0) || (atP < 0.0 && atQ > 0.0)) kept.push_back(p + (q - p) * (atP / (atP - atQ)));
    }
    return kept;
}

/// A world-axis box between a light and what it hides.
class ShadowedBox {
public:
    ShadowedBox(const std::array<dvec3, 2>& box, const dvec4& light) : box_(box), light_(light) {}

    /// Face `side` (0 low, 1 high) across an axis.
    bool faces(int axis, int side) const {
        const double towards = light_[axis] - light_.w * box_[std::size_t(side)][axis];
        return side != 0 ? towards > 0.0 : towards < 0.0;
    }
    /// Bit k of `which`: high along axis k.
    dvec4 corner(int which) const {
        return {box_[std::size_t(which & 1)].x, box_[std::size_t(which >> 1 & 1)].y, box_[std::size_t(which >> 2)].z,
                1.0};
    }
    dvec4 shadowOf(const dvec4& corner) const { return corner * light_.w - light_; }

    /// All faces of the box and of its shadow.
    std::vector<Outline> outlines() const;
    bool hides(const dvec3& p) const;

private:
    std::array<dvec3, 2> box_;
    dvec4 light_;
};

std::vector<Outline> ShadowedBox::outlines() const {
    std::vector<Outline> all;
    for (int axis = 0; axis < 3; ++axis) {
        const int u = 1 << (axis + 1) % 3, v = 1 << (axis + 2) % 3;
        for (int side = 0; side < 2; ++side) {
            const int base = side << axis;
            all.push_back({corner(base), corner(base + u), corner(base + u + v), corner(base + v)});
            if (!faces(axis, side)) continue;
            Outline shadow = all.back();
            for (dvec4& p : shadow) p = shadowOf(p);
            all.push_back(shadow);
        }
        for (int edge = 0; edge < 4; ++edge) {  // along the axis, between a face across u and one across v
            const int highU = edge & 1, highV = edge >> 1;
            if (faces((axis + 1) % 3, highU) == faces((axis + 2) % 3, highV)) continue;
            const dvec4 a = corner(highU * u + highV * v), b = corner(highU * u + highV * v + (1 << axis));
            all.push_back({a, b, shadowOf(b), shadowOf(a)});
        }
    }
    return all;
}

/// Whether the way from p to the light meets the box.
bool ShadowedBox::hides(const dvec3& p) const {
    double begin = 0.0, end = light_.w != 0.0 ? 1.0 : HUGE_VAL;
    const dvec3 way = dvec3(light_) - light_.w * p;
    for (int axis = 0; axis < 3; ++axis) {
        const double low = box_[0][axis] - p[axis], high = box_[1][axis] - p[axis];
        if (way[axis] == 0.0) {
            if (low > 0.0 || high < 0.0) return false;
            continue;
        }
        const double one = low / way[axis], other = high / way[axis];
        begin = std::max(begin, std::min(one, other));
        end = std::min(end, std::max(one, other));
    }
    return begin <= end;
}

}  // namespace

std::array<dvec3, 2> boxOf(const TileCaster& caster) {
    std::array<dvec3, 2> box{dvec3(HUGE_VAL), dvec3(-HUGE_VAL)};
    for (const CastingTriangle& triangle : caster.triangles) {
        for (const dvec3& p : triangle.corners) box = {glm::min(box[0], p), glm::max(box[1], p)};
    }
    return box;
}

DepthBounds depthBoundsOf(const TileCaster& caster, const dvec4& light, const TileView& view) {
    DepthBounds bounds{HUGE_VAL, 0.0};
    const auto add = [&](double inverseDepth) {
        bounds.least = std::min(bounds.least, inverseDepth * (1.0 - kMargin));
        bounds.most = std::max(bounds.most, inverseDepth * (1.0 + kMargin));
    };
    const ShadowedBox box(boxOf(caster), light);
    const dvec3 source(light);
    if (light.w != 0.0 && box.hides(source)) {  // the light is in the box: everything may be in its shadow
        add(0.0);
        add(1.0 / view.near());
        return bounds;
    }
    const glm::dvec2 scale = view.rayScale();
    const std::array<dvec4, 5> frustum{dvec4{0, 0, 1, -view.near()},
                                       {1, 0, scale.x, 0},
                                       {-1, 0, scale.x, 0},
                                       dvec4{0, 1, scale.y, 0},
                                       {0, -1, scale.y, 0}};
    for (Outline outline : box.outlines()) {
        for (dvec4& p : outline) p = view.toEye(p);
        for (const dvec4& plane : frustum) outline = clipped(outline, plane);
        for (const dvec4& p : outline) {
            if (p.z > 0.0) add(p.w / p.z);
        }
    }
    for (const dvec3& corner : view.nearCorners()) {
        if (box.hides(corner)) add(1.0 / view.near());
    }
    return bounds;
}

}  // namespace umbrage
