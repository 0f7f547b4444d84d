// SPDX-License-Identifier: Apache-2.0
// Geometry by the textbook, in rationals: the parameter where a line meets a plane, then the sides of the three edges.
// Shares nothing with renderer/oracle but its types. Where the line meets an edge, the light (or the direction) really
// is moved, by a number far smaller than any that can matter.
#pragma once

#include <gmpxx.h>

#include <array>

#include "oracle/formulas.h"

namespace umbrage::oracle::rational {

struct Place {
    mpq_class x, y, z;
};

inline Place place(const glm::dvec3& v) {
    return {mpq_class(v.x), mpq_class(v.y), mpq_class(v.z)};
}
inline Place operator-(const Place& a, const Place& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Place along(const Place& p, const mpq_class& s, const Place& d) {
    return {p.x + s * d.x, p.y + s * d.y, p.z + s * d.z};
}
inline mpq_class dot(const Place& a, const Place& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Place cross(const Place& a, const Place& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// v + (e, e^2, e^3)
inline Place nudged(const Place& v) {
    mpz_class inverse;
    mpz_ui_pow_ui(inverse.get_mpz_t(), 2, 3000);
    const mpq_class e(mpz_class(1), inverse);
    return {v.x + e, v.y + e * e, v.z + e * e * e};
}

struct Plane {
    explicit Plane(const Corners& t) : a(place(t[0])), b(place(t[1])), c(place(t[2])), n(cross(b - a, c - a)) {}

    /// Strictly; `q` lies in the plane. On an edge's line and not outside of the others: 0.
    int inside(const Place& q) const {
        const int ab = sgn(dot(n, cross(b - a, q - a))), bc = sgn(dot(n, cross(c - b, q - b)));
        const int ca = sgn(dot(n, cross(a - c, q - c)));
        if (ab < 0 || bc < 0 || ca < 0) return -1;
        return ab != 0 && bc != 0 && ca != 0;
    }

    /// Whether the line through p passes through the triangle, if need be moved as said above.
    bool crossedBy(const Place& p, const Place& way) const {
        const mpq_class height = dot(n, a - p), slope = dot(n, way);
        if (slope != 0) {
            const int side = inside(along(p, mpq_class(height / slope), way));
            if (side != 0) return side > 0;
        }
        const Place moved = nudged(way);
        const mpq_class movedSlope = dot(n, moved);
        return movedSlope != 0 && inside(along(p, mpq_class(height / movedSlope), moved)) > 0;
    }

    Place a, b, c, n;
};

inline int sideOfLight(const Corners& t, const glm::dvec4& light) {
    const Plane plane(t);
    const Place l = place(glm::dvec3(light));
    return sgn(dot(plane.n, light.w != 0.0 ? l - plane.a : l));
}

inline int sideOfRay(const Corners& t, const Ray& ray) {
    return -sgn(dot(Plane(t).n, place(ray.direction)));
}

inline bool meets(const Ray& ray, const Corners& t) {
    return Plane(t).crossedBy(place(ray.origin), place(ray.direction));
}

/// In units of the ray's direction, which is not in the plane.
inline mpq_class depth(const Ray& ray, const Corners& t) {
    const Plane plane(t);
    return dot(plane.n, plane.a - place(ray.origin)) / dot(plane.n, place(ray.direction));
}

inline Place pointOf(const Ray& ray, const Corners& seen) {
    return along(place(ray.origin), depth(ray, seen), place(ray.direction));
}

inline bool hides(const Corners& t, const Place& p, const glm::dvec4& light) {
    const Plane plane(t);
    const Place l = place(glm::dvec3(light)), way = light.w != 0.0 ? l - p : l;
    const mpq_class height = dot(plane.n, plane.a - p), slope = dot(plane.n, way);
    if (height == 0 || slope == 0) return false;
    const mpq_class s = height / slope;
    if (s <= 0 || (light.w != 0.0 && s >= 1)) return false;
    return plane.crossedBy(p, way);
}

}  // namespace umbrage::oracle::rational
