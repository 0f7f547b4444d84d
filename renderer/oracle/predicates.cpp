// SPDX-License-Identifier: Apache-2.0
#include "oracle/predicates.h"

#include <algorithm>
#include <glm/gtx/component_wise.hpp>

namespace umbrage::oracle {
namespace {

/// The sign of a formula, given as a generic lambda over the kind of number.
template <class Formula>
int signOf(const Formula& formula) {
    const Bounded fast = formula.template operator()<Bounded>();
    return fast.signKnown() ? fast.sign() : formula.template operator()<Exact>().sign();
}

bool passesThrough(const std::array<int, 3>& edges) {
    return edges[0] != 0 && edges[0] == edges[1] && edges[1] == edges[2];
}

/// Signs of the three edges, none of them 0 but where p is on an edge's line.
std::array<int, 3> edgeSides(const Crossing<Exact>& exact, const Point<Exact>& p, const Corners& t) {
    std::array<int, 3> sides{};
    for (std::size_t k = 0; k < 3; ++k) {
        sides[k] = exact.edges[k].sign();
        if (sides[k] == 0) sides[k] = besideEdge(p, t[k], t[(k + 1) % 3]);
    }
    return sides;
}

double largest(const glm::dvec3& v) {
    return glm::compMax(glm::abs(v));
}

/// Crossing in plain doubles, with one bound for its edges and one for the rest: decides nearly all that is asked.
///
/// With |a|, |b|, |c| <= m wrong by at most y m, and |r| <= s by x s, a determinant of six products is wrong by
/// 6 s m^2 ((1 + x) (1 + y)^2 - 1), at most 7 s m^2 (x + 2 y) while x and y are below 1/16, and by its own five
/// roundings of each product.
struct Glance {
    /// @param errorP, errorR  of p and r, in each coordinate
    Glance(const glm::dvec3& p, double errorP, const glm::dvec3& r, double errorR, const Corners& t) {
        a = t[0] - p;
        const glm::dvec3 b = t[1] - p, c = t[2] - p;
        bc = glm::cross(b, c);
        edges = {glm::dot(r, glm::cross(a, b)), glm::dot(r, bc), glm::dot(r, glm::cross(c, a))};
        const double s = largest(r), m = std::max({largest(a), largest(b), largest(c)});
        const double error = errorP + kHalfUlp * m;
        const bool ordinary = inRange(s * m * m) && inRange(m * m * m) && 16.0 * error < m && 16.0 * errorR < s;
        if (!ordinary) return;
        edgeBound = 8.0 * m * (m * errorR + 2.0 * s * error + 8.0 * kHalfUlp * s * m);
        pointBound = 8.0 * m * m * (3.0 * error + 8.0 * kHalfUlp * m);
    }

    bool beside() const {
        const auto [least, most] = std::minmax({edges[0], edges[1], edges[2]});
        return least < -edgeBound && most > edgeBound;
    }
    bool through() const {
        const auto [least, most] = std::minmax({edges[0], edges[1], edges[2]});
        return least > edgeBound || most < -edgeBound;
    }

    /// Of the open segment to the light, which goes through: 1: it is crossed, -1: it is not, 0: not known.
    int reaches(bool finite) const {
        const double atPoint = glm::dot(a, bc), sum = edges[0] + edges[1] + edges[2];
        const double atLight = finite ? sum - atPoint : sum;
        const double bound = 4.0 * edgeBound + 2.0 * pointBound;
        if (!(std::abs(atPoint) > pointBound && std::abs(atLight) > bound)) return 0;
        return (atPoint > 0.0) == (atLight > 0.0) ? 1 : -1;
    }

    /// Nothing has overflowed, and what may have underflowed is nothing next to it.
    static bool inRange(double product) { return product > 0x1p-900 && product < 0x1p900; }

    glm::dvec3 a, bc;
    std::array<double, 3> edges;
    double edgeBound = std::numeric_limits<double>::infinity(), pointBound = edgeBound;
};

}  // namespace

int sideOfLight(const Corners& t, const glm::dvec4& light) {
    return signOf([&]<class N>() { return facing<N>(t, light); });
}

int sideOfRay(const Corners& t, const Ray& ray) {
    return -signOf([&]<class N>() { return against<N>(t, ray); });
}

bool meets(const Ray& ray, const Corners& t) {
    const Glance glance(ray.origin, 0.0, ray.direction, 0.0, t);
    if (glance.beside()) return false;
    if (glance.through()) return true;
    const glm::dvec4 direction(ray.direction, 0.0);
    const Point<Exact> origin{vectorOf<Exact>(ray.origin)};
    return passesThrough(edgeSides(crossing<Exact>(origin, t, direction), origin, t));
}

int compareDepth(const Ray& ray, const Corners& t, const Corners& other) {
    // offset / against of the one minus that of the other, times both denominators.
    const int order = signOf([&]<class N>() {
        return offset<N>(t, ray) * against<N>(other, ray) - offset<N>(other, ray) * against<N>(t, ray);
    });
    return order * sideOfRay(t, ray) * sideOfRay(other, ray);
}

int compareDepth(const Ray& ray, const Corners& t, double distance) {
    const int order = signOf([&]<class N>() { return offset<N>(t, ray) - N(distance) * against<N>(t, ray); });
    return -order * sideOfRay(t, ray);
}

SurfacePoint::SurfacePoint(const Ray& ray, const Corners& seen) : ray_(ray), seen_(seen) {
    const Vector<Bounded> p = surfacePoint<Bounded>(seen, ray).v;
    rounded_ = {p.x.value, p.y.value, p.z.value};
    error_ = p.x.error + p.y.error + p.z.error;  // a sum, so that none is lost that is not a number
}

glm::dvec3 SurfacePoint::position(double within) const {
    if (error_ <= within) return rounded_;
    const Point<Exact> exact = surfacePoint<Exact>(seen_, ray_);
    return {quotient(exact.v.x, exact.w), quotient(exact.v.y, exact.w), quotient(exact.v.z, exact.w)};
}

bool SurfacePoint::hiddenBy(const Corners& t, const glm::dvec4& light) const {
    const glm::dvec3 l(light), way = light.w != 0.0 ? l - rounded_ : l;
    const Glance glance(rounded_, error_, way, light.w != 0.0 ? error_ + kHalfUlp * largest(way) : 0.0, t);
    if (glance.beside()) return false;
    if (glance.through()) {
        const int reaches = glance.reaches(light.w != 0.0);
        if (reaches != 0) return reaches > 0;
    }
    const Point<Exact> p = surfacePoint<Exact>(seen_, ray_);
    const Crossing<Exact> exact = crossing(p, t, light);
    if (exact.atPoint.sign() == 0 || exact.atPoint.sign() != exact.atLight.sign()) return false;
    return passesThrough(edgeSides(exact, p, t));
}

bool SurfacePoint::shadedSideOf(const Corners& t, const glm::dvec4& light) const {
    if (sideOfLight(t, light) * sideOfRay(t, ray_) >= 0) return false;
    if (t == seen_) return true;
    const Point<Exact> p = surfacePoint<Exact>(seen_, ray_);
    const Crossing<Exact> exact = crossing(p, t, light);
    return exact.atPoint.sign() == 0 && passesThrough(edgeSides(exact, p, t));
}

}  // namespace umbrage::oracle
