// SPDX-License-Identifier: Apache-2.0
// Sides and light caps of shadow volumes on the picture's grid, in double. Host code, no GL.
//
// Neighbours share the borders between them bit by bit: every border is a determinant of the same vectors, whose sign
// turns exactly where they change places. So the centre of a pixel is on one side of it for both, and crossings of a
// view ray add up to nothing (docs/rules.md, G1) without any tolerance.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>

namespace umbrage {

/// A picture's grid and the eye behind it. View space: right, up, towards the viewer.
struct TileEye {
    int width = 0, height = 0;
    glm::dvec2 rayScale{1.0};  // half extent of the picture at distance 1 (perspective) or in metres
    bool perspective = true;
    double znear = 0.0;
    glm::dvec2 sample{0.5};  // where in a pixel it is looked at, from its upper left corner
    glm::dvec2 ties{1.0};    // 1 or -1: to which side samples on a border are moved, along the row and much less along
                             // the column; as whatever found what is seen does it
};

/// A linear function of the pixel (column, row), at its sample.
struct PixelFunction {
    double x = 0.0, y = 0.0, c = 0.0;
};

inline constexpr int kTileSize = 8, kBlockSize = 64;  // pixels along a side
/// One function more than borders: the last is the depth, which is greater where it is nearer: 1/metre along the view
/// axis, or for an orthographic eye metres towards the viewer.
inline constexpr int kTileBorders = 3, kTileFunctions = kTileBorders + 1;
/// In pixels: nearer to a border than this, floats do not tell the side of a sample within their own tile.
inline constexpr float kBorderRounding = 0x1p-16f;

/// Covers samples where every border is positive; samples on a border go to one of both sides. A side has no far
/// border: beyond its horizon it is behind everything. Borders are scaled to slopes between 1 and 2: they are in
/// pixels.
struct TilePolygon {
    PixelFunction functions[kTileFunctions];
    float margins[kTileFunctions]{};  // what rounding may do to each when it is evaluated in float
    bool ownsZero[kTileBorders]{};
    std::int32_t crossing = 0;  // what the count of what lies behind it changes by
    std::uint64_t rows = 0;     // of blocks that it may touch, one bit each; bit 63 stands for all from there on
};

/// Whether a sample is within the borders of a polygon, and what it sees behind it.
bool isBehind(const TilePolygon& polygon, int column, int row, float depth);

/// In view space.
using TileCorners = std::array<glm::dvec3, 3>;

/// A light, and hairs by which eye and light are moved where a determinant would be zero: the eye on a plane, an edge
/// or a corner, or these in line with the light. All polygons of a closed volume need the same.
struct TileSource {
    glm::dvec4 light{0.0};    // view space: a position, or the direction towards it (w = 0)
    glm::dvec3 eyeHair{0.0};  // by which everything else is moved
    glm::dvec3 lightHair{0.0};

    glm::dvec4 movedLight() const { return light + glm::dvec4(light.w * eyeHair + lightHair, 0.0); }
};

/// On which side of the plane through the light and the edge from a to b the eye is: positive where a surface along the
/// edge that faces the light has it in its volume. Changes its sign with the edge's direction.
double eyeBeside(const TileEye& eye, const glm::dvec3& a, const glm::dvec3& b, const TileSource& source);

/// On which side of a triangle the eye is: positive where its corners run clockwise, 0 on it if there is no hair.
double eyeBehind(const TileEye& eye, const TileCorners& corners, const glm::dvec3& eyeHair);

/// The infinite quad behind an edge that the surface facing the light runs along from a to b.
/// @param a, b  view space
/// @param times  multiplicity; negative: it runs from b to a
/// @return  none where nothing of it is in the picture, or it is seen exactly edge-on
std::optional<TilePolygon> tileSide(const TileEye& eye, const glm::dvec3& a, const glm::dvec3& b,
                                    const TileSource& source, int times);

/// Where a light cap is not in the depth buffer though it is the nearest (T1).
enum class CapMissing {
    Anywhere,      // it counts at its own depth, a little pushed back, so that what is seen of itself stays before it
    BeforeTheNear  // only what the near plane cuts off
};

/// A light cap.
/// @param light  +1 if the light is on the side from which the corners run counterclockwise, else -1
std::optional<TilePolygon> tileCap(const TileEye& eye, const TileCorners& corners, int light,
                                   const glm::dvec3& eyeHair = glm::dvec3(0.0),
                                   CapMissing missing = CapMissing::Anywhere);

}  // namespace umbrage
