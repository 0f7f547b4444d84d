// SPDX-License-Identifier: Apache-2.0
// Shapes as triangle soups whose shared points are exactly equal; geometry.h makes indexed meshes of them. Lengths in
// metres, +Y up, triangles counter-clockwise seen from outside.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "numbers.h"

namespace generator {

/// Which joints of a skin move a point: `first`, and `second` with the share `secondWeight`.
struct Influence {
    int first = 0, second = 0;
    double secondWeight = 0;
};

struct Corner {
    dvec3 position{0};
    dvec2 uv{0};  // v downwards, as in glTF
    Influence influence{};
};

class Shape {
public:
    /// Snaps the positions; a triangle with two equal positions is left out (poles of a lathe, tips of a tube).
    void triangle(Corner a, Corner b, Corner c);
    void quad(const Corner& a, const Corner& b, const Corner& c, const Corner& d);
    Shape& add(const Shape& other);

    const std::vector<Corner>& corners() const { return corners_; }  // three per triangle
    std::size_t triangleCount() const { return corners_.size() / 3; }

    Shape moved(const dvec3& by) const;
    Shape scaled(const dvec3& by) const;
    Shape rotated(const dquat& by) const;
    /// Every point through `position`, which must keep the orientation.
    Shape bent(const std::function<dvec3(const dvec3&)>& position) const;
    /// The mirror image in the plane x = 0, outside still outside.
    Shape mirrored() const;
    /// Texture coordinates from the side each triangle faces; one repeat is `metresPerRepeat` long.
    Shape boxMapped(double metresPerRepeat) const;
    Shape influencedBy(const std::function<Influence(const dvec3&)>& influence) const;

private:
    std::vector<Corner> corners_;
};

/// 12 triangles, closed.
Shape box(const dvec3& low, const dvec3& high);

/// A box whose edges are cut off by `bevel`: 44 triangles, closed.
Shape bevelledBox(const dvec3& low, const dvec3& high, double bevel);

/// A surface of revolution about Y. The profile (radius, height) goes upwards along the outside; radius 0 at both ends
/// or equal ends close it. One texture repeat is `metresPerRepeat` long.
Shape lathe(const std::vector<dvec2>& profile, int segments, double metresPerRepeat = 1);

/// The profile cut into `points` points evenly along its length, ends kept.
std::vector<dvec2> resampled(const std::vector<dvec2>& profile, int points);

/// A sphere of segments * (rings - 1) + 2 points.
Shape sphere(double radius, int segments, int rings);

/// A cross-section: centre + x cos(a) + y sin(a), with x cross y along the way the tube goes.
struct Ring {
    dvec3 centre{0}, x{0}, y{0};
};

enum class Ends { Closed, Joined, Open };  // capped with polygons; last ring meets the first; left open

Shape tube(const std::vector<Ring>& rings, int segments, Ends ends = Ends::Closed, double metresPerRepeat = 1);

/// Rings along a path with as little twist as can be. A last radius of 0 makes a tip.
std::vector<Ring> ringsAlong(const std::vector<dvec3>& path, const std::vector<double>& radii);

/// A Catmull-Rom spline through the control points, at `points` points evenly in its parameter.
std::vector<dvec3> splineThrough(const std::vector<dvec3>& control, int points);

/// A ring in the plane of x and z, wide `radii`; its own section is an ellipse, `thick` outwards and `high` along y.
Shape torus(const dvec2& radii, double thick, double high, int around, int sides);

/// A straight, closed, round bar.
Shape bar(const dvec3& from, const dvec3& to, double radius, int segments = 6);

/// A plate between two lines of equally many points (x to the right, `upper` above `lower`), from z = back to z =
/// front.
Shape plate(const std::vector<dvec2>& lower, const std::vector<dvec2>& upper, double back, double front);

/// An open sheet of columns x rows cells; `at` maps (u, v) in [0, 1]^2, v downwards, to space.
Shape sheet(int columns, int rows, const std::function<dvec3(double u, double v)>& at, const dvec2& uvRepeats);

/// An icosahedron cut `levels` times, 20 * 4^levels triangles, on the unit sphere.
Shape icosphere(int levels);

}  // namespace generator
