// SPDX-License-Identifier: Apache-2.0
// Shadow volumes of one caster as polygons on the picture's grid, in double: infinite sides with multiplicities, light
// caps, dark caps at infinity, and what the near plane cuts off (Hornus et al. 2005: the casters between the light and
// the near rectangle, projected onto it). Host code, no GL.
//
// Neighbours share the lines between them bit by bit: every line is a determinant of the same vectors, whose sign turns
// exactly where they change places. So a pixel's centre is on one side of it for both, and crossings of a view ray add
// up to nothing (docs/rules.md, G1) without any tolerance.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "shadow/eye.h"

namespace umbrage {

/// A function of the pixel (column, row), whose centre is meant.
struct PixelLine {
    double a = 0.0, b = 0.0, c = 0.0;

    double at(int x, int y) const { return a * x + b * y + c; }
};

/// Pixels [left, right] x [top, bottom].
struct PixelBox {
    int left = 0, top = 0, right = 0, bottom = 0;
};

struct TilePolygon {
    enum class Kind : std::uint8_t { Side, LightCap, DarkCap, NearPart };

    /// Covers pixels where every line is at least its threshold: 0, or the least number above for those that leave
    /// their own zero to the neighbour.
    std::array<PixelLine, 5> lines;
    std::array<double, 5> thresholds{}, errors{};  // errors: what rounding may do to at()
    int lineCount = 0;
    PixelLine inverseDepth;  // 1/metre along the view axis; all zero: infinitely far. Not of a near part.
    double inverseDepthError = 0.0;
    double nearestInverseDepth = 0.0;  // nothing of the polygon is nearer
    Kind kind = Kind::Side;
    std::int8_t entering = 0;  // what a view ray's count of volumes changes by; of a near part, what it begins with
    std::int16_t times = 1;    // so often drawn

    enum class Cover { None, Some, All };
    Cover cover(const PixelBox& box) const;
    bool covers(int x, int y) const;
    /// Least and greatest inverse depth of the plane within the box, widened by what rounding may do.
    std::array<double, 2> inverseDepths(const PixelBox& box) const;
};

/// A triangle that casts, in the world, its front counterclockwise.
struct CastingTriangle {
    std::array<glm::dvec3, 3> corners;
    bool oneSided = false;     // of a closed surface: counted only where its front faces the light (half the fill)
    bool mayBeUnseen = false;  // not in the depth buffer even where it is nearest: its cap keeps its own depth
};

/// What is drawn as one volume: a whole figure, or a part of it. Its triangles may be of several meshes.
struct TileCaster {
    std::string name;
    std::vector<CastingTriangle> triangles;
};

/// A picture's grid and the eye behind it.
class TileView {
public:
    /// @throws Error(Input) for an orthographic eye
    TileView(const Eye& eye, int width, int height);

    int width() const { return width_; }
    int height() const { return height_; }
    double near() const { return near_; }
    /// Into a space with the eye at the origin: right, down, along the view axis; of a direction where w is 0.
    glm::dvec4 toEye(const glm::dvec4& world) const { return fromWorld_ * world; }
    /// n . r + k, r the view ray of a pixel with length 1 along the view axis.
    PixelLine line(const glm::dvec3& n, double k = 0.0) const;
    glm::dvec3 ray(int x, int y) const;
    /// Of the near rectangle, in the world.
    std::array<glm::dvec3, 4> nearCorners() const;
    /// Half extent of the picture at distance 1.
    const glm::dvec2& rayScale() const { return rayScale_; }

private:
    glm::dmat4 fromWorld_;
    glm::dvec2 rayScale_;
    double near_;
    int width_, height_;
};

/// @param light  homogeneous, in the world: a position, or the direction towards it (w = 0)
std::vector<TilePolygon> volumePolygons(const TileCaster& caster, const glm::dvec4& light, const TileView& view);

}  // namespace umbrage
