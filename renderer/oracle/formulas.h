// SPDX-License-Identifier: Apache-2.0
// What decides who sees whom, as polynomials in the coordinates of vertices, eye rays and lights. N is Bounded or
// Exact. Only signs matter.
//
// A surface point is the place where an eye ray E + t d meets the plane of the triangle that is seen. In Exact it stays
// homogeneous, (n.d E + n.(A - E) d, n.d), so that nothing is ever divided.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <type_traits>

#include "oracle/numbers.h"

namespace umbrage::oracle {

using Corners = std::array<glm::dvec3, 3>;  // counter-clockwise seen from its front

struct Ray {
    glm::dvec3 origin{0.0}, direction{0.0, 0.0, -1.0};
};

template <class N>
struct Vector {
    N x, y, z;
};

template <class N>
Vector<N> vectorOf(const glm::dvec3& v) {
    return {v.x, v.y, v.z};
}
template <class N>
Vector<N> operator-(const Vector<N>& a, const Vector<N>& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class N>
Vector<N> operator+(const Vector<N>& a, const Vector<N>& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class N>
Vector<N> operator*(const N& s, const Vector<N>& v) {
    return {s * v.x, s * v.y, s * v.z};
}
template <class N>
Vector<N> cross(const Vector<N>& a, const Vector<N>& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class N>
N dot(const Vector<N>& a, const Vector<N>& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class N>
Vector<N> normalOf(const Corners& t) {
    const Vector<N> a = vectorOf<N>(t[0]);
    return cross(vectorOf<N>(t[1]) - a, vectorOf<N>(t[2]) - a);
}

/// v / w; w is positive, and 1 in Bounded.
template <class N>
struct Point {
    Vector<N> v;
    N w = 1.0;
};

/// w * (a - p).
template <class N>
Vector<N> fromPoint(const Point<N>& p, const glm::dvec3& a) {
    return p.w * vectorOf<N>(a) - p.v;
}

/// w * (the way from p to a light); the light is homogeneous: a point, or w = 0 and the direction towards it.
template <class N>
Vector<N> towards(const Point<N>& p, const glm::dvec4& light) {
    if (light.w != 0.0) return fromPoint(p, glm::dvec3(light));
    return p.w * vectorOf<N>(glm::dvec3(light));
}

/// > 0: the light is in front of the triangle.
template <class N>
N facing(const Corners& t, const glm::dvec4& light) {
    const Vector<N> l = vectorOf<N>(glm::dvec3(light));
    return dot(normalOf<N>(t), light.w != 0.0 ? l - vectorOf<N>(t[0]) : l);
}

/// > 0: the ray looks at the triangle's back.
template <class N>
N against(const Corners& t, const Ray& ray) {
    return dot(normalOf<N>(t), vectorOf<N>(ray.direction));
}

/// n.(A - E): the ray meets the plane at E + (offset / against) d.
template <class N>
N offset(const Corners& t, const Ray& ray) {
    return dot(normalOf<N>(t), vectorOf<N>(t[0]) - vectorOf<N>(ray.origin));
}

/// Where the ray meets the plane, in units of its direction. An infinite error where they may be parallel.
inline Bounded distanceAlong(const Ray& ray, const Corners& t) {
    const Vector<Bounded> n = normalOf<Bounded>(t), d = vectorOf<Bounded>(ray.direction);
    return dot(n, vectorOf<Bounded>(t[0]) - vectorOf<Bounded>(ray.origin)) / dot(n, d);
}

template <class N>
Point<N> surfacePoint(const Corners& seen, const Ray& ray) {
    const Vector<N> e = vectorOf<N>(ray.origin), d = vectorOf<N>(ray.direction);
    if constexpr (std::is_same_v<N, Bounded>) return {e + distanceAlong(ray, seen) * d, 1.0};
    const N along = offset<N>(seen, ray), den = against<N>(seen, ray);
    Point<N> p{den * e + along * d, den};
    if (den.sign() < 0) p = {N(-1.0) * p.v, -den};
    return p;
}

/// How a triangle lies between a point p and a light, seen along r, the way to the light.
template <class N>
struct Crossing {
    std::array<N, 3> edges;  // r.(a x b) of the edges ab, bc, ca, from p: all of one sign where the line crosses
    N atPoint;               // n.(A - p): 0: p is in the triangle's plane
    N atLight;               // n.(L - A): 0: the light is
};

template <class N>
Crossing<N> crossing(const Point<N>& p, const Corners& t, const glm::dvec4& light) {
    const Vector<N> a = fromPoint(p, t[0]), b = fromPoint(p, t[1]), c = fromPoint(p, t[2]), r = towards(p, light);
    const Vector<N> bc = cross(b, c);
    Crossing<N> result{{dot(r, cross(a, b)), dot(r, bc), dot(r, cross(c, a))}, dot(a, bc), {}};
    const N through = result.edges[0] + result.edges[1] + result.edges[2];  // n.r
    result.atLight = light.w != 0.0 ? through - result.atPoint : through;
    return result;
}

/// For a line through p that meets the edge ab exactly: the side it passes on if the light were moved by an
/// infinitesimal (e, e^2, e^3). The same for both triangles of an edge, so one of the two is met. 0: p is on the edge's
/// line.
template <class N>
int besideEdge(const Point<N>& p, const glm::dvec3& a, const glm::dvec3& b) {
    const Vector<N> n = cross(fromPoint(p, a), fromPoint(p, b));
    for (const N* component : {&n.x, &n.y, &n.z}) {
        if (component->sign() != 0) return component->sign();
    }
    return 0;
}

}  // namespace umbrage::oracle
