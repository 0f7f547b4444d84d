// SPDX-License-Identifier: Apache-2.0
#include "oracle/predicates.h"

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

/// Known to miss: two edges' signs are known and differ.
bool surelyBeside(const std::array<Bounded, 3>& edges) {
    bool positive = false, negative = false;
    for (const Bounded& edge : edges) {
        positive = positive || edge.value > edge.error;
        negative = negative || -edge.value > edge.error;
    }
    return positive && negative;
}

bool surelyThrough(const std::array<Bounded, 3>& edges) {
    for (const Bounded& edge : edges) {
        if (!(std::abs(edge.value) > edge.error)) return false;
    }
    return true;  // and not surelyBeside()
}

}  // namespace

int sideOfLight(const Corners& t, const glm::dvec4& light) {
    return signOf([&]<class N>() { return facing<N>(t, light); });
}

int sideOfRay(const Corners& t, const Ray& ray) {
    return -signOf([&]<class N>() { return against<N>(t, ray); });
}

bool meets(const Ray& ray, const Corners& t) {
    const glm::dvec4 direction(ray.direction, 0.0);
    const Crossing<Bounded> fast = crossing<Bounded>({vectorOf<Bounded>(ray.origin)}, t, direction);
    if (surelyBeside(fast.edges)) return false;
    if (surelyThrough(fast.edges)) return true;
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

SurfacePoint::SurfacePoint(const Ray& ray, const Corners& seen)
    : ray_(ray), seen_(seen), bounded_(surfacePoint<Bounded>(seen, ray)) {}

glm::dvec3 SurfacePoint::position() const {
    return {bounded_.v.x.value, bounded_.v.y.value, bounded_.v.z.value};
}

bool SurfacePoint::hiddenBy(const Corners& t, const glm::dvec4& light) const {
    const Crossing<Bounded> fast = crossing(bounded_, t, light);
    if (surelyBeside(fast.edges)) return false;
    if (surelyThrough(fast.edges) && fast.atPoint.signKnown() && fast.atLight.signKnown()) {
        return fast.atPoint.sign() != 0 && fast.atPoint.sign() == fast.atLight.sign();
    }
    const Point<Exact> p = surfacePoint<Exact>(seen_, ray_);
    const Crossing<Exact> exact = crossing(p, t, light);
    if (exact.atPoint.sign() == 0 || exact.atPoint.sign() != exact.atLight.sign()) return false;
    return passesThrough(edgeSides(exact, p, t));
}

}  // namespace umbrage::oracle
