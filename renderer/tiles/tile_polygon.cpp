// SPDX-License-Identifier: Apache-2.0
#include "tiles/tile_polygon.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

namespace umbrage {
namespace {

using glm::cross;
using glm::dot;
using glm::dvec3;
using glm::dvec4;

// A determinant tells nothing where it is less than this share of what the hairs do to it: doubles round less.
constexpr double kTells = 0x1p-13;
constexpr double kFloatRounding = 0x1p-20;  // of a sum of three terms and the offsets within a block, generously

/// What a point of homogeneous view space is to lines on the picture.
dvec3 onPicture(const TileEye& eye, const dvec4& p) {
    return {p.x, p.y, eye.perspective ? p.z : -p.w};
}

/// n . r, r being the view ray (x, y, -1) of a pixel.
PixelFunction alongRays(const TileEye& eye, const dvec3& n) {
    const double x = n.x * eye.rayScale.x, y = n.y * eye.rayScale.y;
    return {x * (2.0 / eye.width), y * (-2.0 / eye.height),
            x * (2.0 * eye.sample.x / eye.width - 1.0) + y * (1.0 - 2.0 * eye.sample.y / eye.height) - n.z};
}

PixelFunction times(const PixelFunction& f, double factor) {
    return {f.x * factor, f.y * factor, f.c * factor};
}

/// The side a sample on the border itself is on: that of a place moved a little along the row, then along the column.
bool zeroIsInside(const TileEye& eye, const PixelFunction& f) {
    for (const double k : {f.x * eye.ties.x, f.y * eye.ties.y, f.c}) {
        if (k != 0.0) return k > 0.0;
    }
    return false;
}

double valueAt(const PixelFunction& f, int column, int row) {
    return f.x * column + f.y * row + f.c;
}

/// To slopes between 1 and 2, by a power of two, which rounds nothing: floats hold it then.
PixelFunction scaled(const PixelFunction& f) {
    constexpr std::uint64_t kExponent = 0x7ff, kBias = 0x3ff;
    const double slope = std::max(std::abs(f.x), std::abs(f.y));
    const std::uint64_t exponent = std::bit_cast<std::uint64_t>(slope) >> 52 & kExponent;
    if (exponent == 0 || exponent >= 2 * kBias) return f;  // none, or nothing that a scene can mean
    return times(f, std::bit_cast<double>((2 * kBias - exponent) << 52));
}

float marginOf(const TileEye& eye, const PixelFunction& f) {
    return float(kFloatRounding * (std::abs(f.x) * eye.width + std::abs(f.y) * eye.height + std::abs(f.c)));
}

/// A distance from a plane with normal n, in units of n, that floats can hold what it divides of.
double notTooSmall(double distance, const dvec3& n) {
    return std::copysign(std::max(std::abs(distance), 1e-25 * length(n)), distance);
}

/// Depth of the plane with normal n through p. @param k  n . p for a perspective eye, -n.z for an orthographic one
PixelFunction depthOf(const TileEye& eye, const dvec3& n, const dvec3& p, double k) {
    if (eye.perspective) return times(alongRays(eye, n), 1.0 / k);
    PixelFunction depth = alongRays(eye, {n.x / k, n.y / k, 0.0});
    depth.c -= dot(n, p) / k;
    return depth;
}

bool missesPicture(const TileEye& eye, const PixelFunction& f) {
    return std::max(f.x, 0.0) * eye.width + std::max(f.y, 0.0) * eye.height + f.c < 0.0;
}

/// See TilePolygon::rows.
std::uint64_t rowsOf(const TileEye& eye, const TilePolygon& polygon) {
    double first = 0.0, last = 63.0;
    for (int i = 0; i < kTileBorders; ++i) {
        // The most that the border is in a row of blocks, and where that is 0.
        const PixelFunction& f = polygon.functions[i];
        const double most = f.c + std::max(f.x, 0.0) * eye.width + std::max(f.y, 0.0) * kBlockSize + polygon.margins[i];
        const double zero = -most / (f.y * kBlockSize);
        if (f.y > 0.0) {
            first = std::max(first, zero);
        } else if (f.y < 0.0) {
            last = std::min(last, zero);
        } else if (most < 0.0) {
            return 0;
        }
    }
    if (last < 0.0 || first > last + 1.0) return 0;
    return ~std::uint64_t(0) << int(std::min(first, 63.0)) & ~std::uint64_t(0) >> (63 - int(last));
}

/// @param inward  1 or -1: sign of the borders inside
std::optional<TilePolygon> polygonOf(const TileEye& eye, const std::array<dvec3, kTileBorders>& borders, double inward,
                                     const PixelFunction& depth, int crossing) {
    TilePolygon polygon;
    polygon.crossing = crossing;
    for (std::size_t i = 0; i < kTileBorders; ++i) {
        const PixelFunction f = scaled(times(alongRays(eye, borders[i]), inward));
        if (missesPicture(eye, f)) return std::nullopt;
        polygon.functions[i] = f;
        polygon.margins[i] = marginOf(eye, f);
        polygon.ownsZero[i] = zeroIsInside(eye, f);
    }
    // A plane seen edge-on is at no depth on its own line, so samples there are moved as zeroIsInside() has it.
    polygon.functions[kTileBorders] = depth;
    polygon.functions[kTileBorders].c += 0x1p-20 * eye.ties.x * depth.x + 0x1p-30 * eye.ties.y * depth.y;
    polygon.margins[kTileBorders] = marginOf(eye, depth);
    polygon.rows = rowsOf(eye, polygon);
    return polygon;
}

/// By 1/256 pixel along its slope, because the rasteriser that found what is seen snapped corners that far, and by what
/// floats round.
PixelFunction pushedBack(const TileEye& eye, PixelFunction depth) {
    depth.c -= 0x1p-8 * std::max(std::abs(depth.x), std::abs(depth.y));
    if (eye.perspective) return times(depth, 1.0 - 0x1p-21);
    depth.c -= 0x1p-22 * std::abs(depth.c);
    return depth;
}

/// So steep that it is before what is seen only where it is before the near plane, of which nothing that is seen is.
PixelFunction beforeTheNear(const TileEye& eye, PixelFunction depth) {
    const double near = eye.perspective ? 1.0 / eye.znear : -eye.znear;
    depth.c -= near;
    depth = times(depth, 0x1p16);
    depth.c += near;
    return depth;
}

/// The line on the picture through two points on it, as onPicture() has them.
/// @param hairP, hairQ  by which they move
dvec3 lineThrough(const dvec3& p, const dvec3& q, const dvec3& hairP, const dvec3& hairQ) {
    const dvec3 line = cross(p, q);
    const double hairs = dot(hairP, hairP) * dot(q, q) + dot(hairQ, hairQ) * dot(p, p);
    if (dot(line, line) > kTells * kTells * hairs) return line;
    return cross(p + hairP, q + hairQ);
}

}  // namespace

double eyeBeside(const TileEye& eye, const dvec3& a, const dvec3& b, const TileSource& source) {
    const double hair = dot(source.eyeHair, source.eyeHair), lightHair = dot(source.lightHair, source.lightHair);
    const double w = source.light.w;
    const dvec3 l(source.light);
    if (eye.perspective) {
        const double beside = dot(cross(a, b), l), aa = dot(a, a), bb = dot(b, b);
        if (beside * beside > kTells * kTells * (hair * (aa + bb) * dot(l, l) + lightHair * aa * bb)) return beside;
        return dot(cross(a + source.eyeHair, b + source.eyeHair), dvec3(source.movedLight()));
    }
    const auto besideOf = [&](const dvec3& light) {
        return w != 0.0 ? cross(a - light, b - light) : cross(b - a, light);
    };
    const dvec3 from = w != 0.0 ? a - l : b - a, to = w != 0.0 ? b - l : l;
    const double beside = -besideOf(l).z;
    if (beside * beside > kTells * kTells * (hair + lightHair) * (dot(from, from) + dot(to, to))) return beside;
    return -besideOf(l + source.lightHair).z;  // differences, which the eye's hair does not change
}

double eyeBehind(const TileEye& eye, const TileCorners& corners, const dvec3& eyeHair) {
    const dvec3 n = cross(corners[1] - corners[0], corners[2] - corners[0]);
    if (!eye.perspective) return -n.z;
    const double behind = dot(n, corners[0]);
    if (std::abs(behind) > kTells * length(eyeHair) * length(n)) return behind;
    return behind + dot(n, eyeHair);
}

bool isBehind(const TilePolygon& polygon, int column, int row, float depth) {
    // In pixels: more than doubles round where three borders meet on a sample, which must all say that it is there.
    constexpr double kOnBorder = 0x1p-30;
    for (int i = 0; i < kTileBorders; ++i) {
        const double value = valueAt(polygon.functions[i], column, row);
        if (std::abs(value) > kOnBorder ? value < 0.0 : !polygon.ownsZero[i]) return false;
    }
    return float(valueAt(polygon.functions[kTileBorders], column, row)) > depth;
}

std::optional<TilePolygon> tileSide(const TileEye& eye, const dvec3& a, const dvec3& b, const TileSource& source,
                                    int times) {
    const dvec3 l(source.light);
    const dvec3 n = source.light.w != 0.0 ? cross(a - l, b - l) : cross(b - a, l);
    const dvec3 pa = onPicture(eye, dvec4(a, 1.0)), pb = onPicture(eye, dvec4(b, 1.0)),
                pl = onPicture(eye, source.light);
    const dvec3 hair = onPicture(eye, dvec4(source.eyeHair, 0.0)),
                lightHair = onPicture(eye, source.movedLight() - source.light);
    const double side = eyeBeside(eye, a, b, source);  // positive: the eye is within
    if (side == 0.0) return std::nullopt;
    // Seen from without, view rays enter the volume there.
    const bool enters = (side < 0.0) == (times > 0);
    return polygonOf(
        eye,
        {lineThrough(pa, pb, hair, hair), lineThrough(pl, pb, lightHair, hair), lineThrough(pa, pl, hair, lightHair)},
        side < 0.0 ? 1.0 : -1.0, depthOf(eye, n, a, notTooSmall(side, n)), enters ? std::abs(times) : -std::abs(times));
}

std::optional<TilePolygon> tileCap(const TileEye& eye, const TileCorners& corners, int light, const dvec3& eyeHair,
                                   CapMissing missing) {
    const auto& [a, b, c] = corners;
    const dvec3 pa = onPicture(eye, dvec4(a, 1.0)), pb = onPicture(eye, dvec4(b, 1.0)),
                pc = onPicture(eye, dvec4(c, 1.0)), hair = onPicture(eye, dvec4(eyeHair, 0.0));
    const dvec3 n = cross(b - a, c - a);
    const double behind = eyeBehind(eye, corners, eyeHair);
    if (behind == 0.0) return std::nullopt;
    const bool enters = (behind < 0.0) == (light > 0);
    const PixelFunction depth = depthOf(eye, n, a, notTooSmall(behind, n));
    return polygonOf(
        eye, {lineThrough(pa, pb, hair, hair), lineThrough(pb, pc, hair, hair), lineThrough(pc, pa, hair, hair)},
        behind > 0.0 ? 1.0 : -1.0, missing == CapMissing::Anywhere ? pushedBack(eye, depth) : beforeTheNear(eye, depth),
        enters ? 1 : -1);
}

}  // namespace umbrage
