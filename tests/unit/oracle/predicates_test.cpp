// SPDX-License-Identifier: Apache-2.0
// Every predicate against the textbook in rationals, where degeneracies abound and where they are missed by a bit.
#include "oracle/predicates.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <random>

#include "rational.h"
#include "soups.h"

namespace umbrage::oracle {
namespace {

/// All sizes of scenes meet the same predicates: a power of two, so that what coincides still does. At the largest and
/// the smallest, products of three coordinates overflow or lose their bits.
double anyScale() {
    return std::ldexp(1.0, *rc::gen::element(0, 0, -126, 100, -20, 23, -350, 340));
}

Corners scaled(const Corners& t, double s) {
    return {s * t[0], s * t[1], s * t[2]};
}

RC_GTEST_PROP(Predicates, SidesAreTheTextbooks, ()) {
    const Snap snap = *anySnap();
    const double s = anyScale();
    for (const Corners& t : draw(10, triangles(snap))) {
        for (const glm::dvec4& light : draw(3, lights(snap))) {
            const glm::dvec4 l(s * glm::dvec3(light), light.w);
            RC_ASSERT(sideOfLight(scaled(t, s), l) == rational::sideOfLight(scaled(t, s), l));
        }
        for (const Ray& ray : draw(3, rays(snap))) {
            RC_ASSERT(sideOfRay(scaled(t, s), ray) == rational::sideOfRay(scaled(t, s), ray));
        }
    }
}

RC_GTEST_PROP(Predicates, LinesMeetWhatTheyMeetWhenMovedByNextToNothing, ()) {
    const Snap snap = *anySnap();
    const double s = anyScale();
    for (const Corners& t : draw(10, triangles(snap))) {
        for (const Ray& drawn : draw(10, rays(snap))) {
            const Ray ray{s * drawn.origin, s * drawn.direction};
            RC_ASSERT(meets(ray, scaled(t, s)) == rational::meets(ray, scaled(t, s)));
        }
    }
}

RC_GTEST_PROP(Predicates, DepthsAreOrderedAsRationalsAre, ()) {
    const Snap snap = *anySnap();
    const double s = anyScale();
    const std::vector<Corners> soup = draw(6, triangles(snap));
    for (const Ray& drawn : draw(4, rays(snap))) {
        const Ray ray{s * drawn.origin, drawn.direction};
        for (const Corners& one : soup) {
            const Corners t = scaled(one, s);
            if (rational::sideOfRay(t, ray) == 0) continue;
            const mpq_class depth = rational::depth(ray, t);
            for (const double distance : {0.0, s, 0.5 * s, depth.get_d()}) {
                RC_ASSERT(compareDepth(ray, t, distance) == sgn(mpq_class(depth - mpq_class(distance))));
            }
            for (const Corners& another : soup) {
                const Corners other = scaled(another, s);
                if (rational::sideOfRay(other, ray) == 0) continue;
                RC_ASSERT(compareDepth(ray, t, other) == sgn(mpq_class(depth - rational::depth(ray, other))));
            }
        }
    }
}

RC_GTEST_PROP(Predicates, HidingIsTheTextbooksWhenTheLightIsMovedByNextToNothing, ()) {
    const Snap snap = *anySnap();
    const double s = anyScale();
    const std::vector<Corners> soup = draw(6, triangles(snap));
    const std::vector<glm::dvec4> lamps = draw(4, lights(snap));
    for (const Ray& drawn : draw(4, rays(snap))) {
        const Ray ray{s * drawn.origin, drawn.direction};
        for (const Corners& seen : soup) {
            if (rational::sideOfRay(scaled(seen, s), ray) == 0) continue;
            const SurfacePoint point(ray, scaled(seen, s));
            const rational::Place p = rational::pointOf(ray, scaled(seen, s));
            for (const Corners& t : soup) {
                for (const glm::dvec4& lamp : lamps) {
                    const glm::dvec4 light(s * glm::dvec3(lamp), lamp.w);
                    RC_ASSERT(point.hiddenBy(scaled(t, s), light) == rational::hides(scaled(t, s), p, light));
                }
            }
        }
    }
}

/// Vertices of a grid, an eye and a light on it: what a random campaign of the properties above is made of.
TEST(Predicates, TheSnappedScenesAreDegenerateOftenEnough) {
    std::mt19937 random(7);
    std::uniform_int_distribution<int> grid(-4, 4);
    const auto place = [&] { return 0.5 * glm::dvec3(grid(random), grid(random), grid(random)); };
    int noArea = 0, edgeOn = 0, inPlane = 0, onEdge = 0, total = 4000;
    for (int i = 0; i < total; ++i) {
        const Corners t{place(), place(), place()};
        const glm::dvec4 light(place(), 1.0);
        const Ray ray{place(), place()};
        const Crossing<Exact> exact = crossing<Exact>({vectorOf<Exact>(ray.origin)}, t, glm::dvec4(ray.direction, 0.0));
        noArea += t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
        edgeOn += sideOfRay(t, ray) == 0;
        inPlane += sideOfLight(t, light) == 0;
        onEdge += exact.edges[0].sign() == 0 || exact.edges[1].sign() == 0 || exact.edges[2].sign() == 0;
    }
    EXPECT_GT(noArea, 10);
    EXPECT_GT(edgeOn, 100);
    EXPECT_GT(inPlane, 100);
    EXPECT_GT(onEdge, 300);
}

RC_GTEST_PROP(Predicates, LightsNextToTheHidingTriangleAreOnTheRightSideOfIt, ()) {
    const Snap snap = *anySnap();
    for (const Corners& t : draw(10, triangles(snap))) {
        const Ray ray = *rays(snap);
        const Corners seen = *triangles(snap);
        if (rational::sideOfRay(seen, ray) == 0) continue;
        const rational::Place p = rational::pointOf(ray, seen);
        const glm::dvec3 inside = 0.25 * (t[0] + t[1] + 2.0 * t[2]);
        for (int ulps = -2; ulps <= 2; ++ulps) {
            const glm::dvec4 light(inside.x, inside.y + ulps * 0x1p-53, inside.z, 1.0);
            RC_ASSERT(SurfacePoint(ray, seen).hiddenBy(t, light) == rational::hides(t, p, light));
        }
    }
}

RC_GTEST_PROP(Predicates, HidingIsRightWhereDoublesDoNotKnowTheSeenPointAtAll, ()) {
    // The plane is parallel to the ray, but for the last bits of its corners; the ray to an axis.
    const Corners seen{{{0, 0, 0}, {0.1, 0.7, 1}, {0.3, 2.1, -1}}};
    const Ray ray{1e-17 * *places(Snap::Free), {0, 0, -1}};
    RC_ASSERT(rational::sideOfRay(seen, ray) != 0);
    const rational::Place p = rational::pointOf(ray, seen);
    const SurfacePoint point(ray, seen);
    for (const Corners& t : draw(20, triangles(Snap::Turned))) {
        const glm::dvec4 light = *lights(Snap::Free);
        RC_ASSERT(point.hiddenBy(t, light) == rational::hides(t, p, light));
    }
}

// The conventions, each in its simplest case.

const Corners kFloor{{{0, 0, 0}, {4, 0, 4}, {4, 0, 0}}};  // front up
const Ray kDown{{2, 5, 1}, {0, -1, 0}};

TEST(Predicates, FrontIsWhereCornersRunCounterClockwise) {
    EXPECT_EQ(sideOfLight(kFloor, {1, 2, 1, 1}), 1);
    EXPECT_EQ(sideOfLight(kFloor, {1, -2, 1, 1}), -1);
    EXPECT_EQ(sideOfLight(kFloor, {9, 0, 9, 1}), 0);
    EXPECT_EQ(sideOfLight(kFloor, {0, 1, 0, 0}), 1);
    EXPECT_EQ(sideOfRay(kFloor, kDown), 1);
    EXPECT_EQ(sideOfRay(kFloor, {{2, -5, 1}, {0, 1, 0}}), -1);
    EXPECT_EQ(sideOfRay(kFloor, {{2, 5, 1}, {1, 0, 0}}), 0);
}

TEST(Predicates, TheSegmentToTheLightIsOpen) {
    const SurfacePoint point(kDown, kFloor);
    const Corners above{{{0, 1, 0}, {4, 1, 4}, {4, 1, 0}}};
    EXPECT_TRUE(point.hiddenBy(above, {2, 3, 1, 1}));
    EXPECT_TRUE(point.hiddenBy(above, {0, 1, 0, 0}));
    EXPECT_FALSE(point.hiddenBy(above, {2, 1, 1, 1}));            // ends at it
    EXPECT_FALSE(point.hiddenBy(above, {2, 1 - 0x1p-52, 1, 1}));  // before it
    EXPECT_TRUE(point.hiddenBy(above, {2, 1 + 0x1p-52, 1, 1}));   // behind it
    EXPECT_FALSE(point.hiddenBy(above, {0, -1, 0, 0}));           // on its other side
    EXPECT_FALSE(point.hiddenBy(kFloor, {2, 3, 1, 1}));           // begins at it
    const Corners coincident{{{-4, 0, -4}, {8, 0, 8}, {8, 0, -4}}};
    EXPECT_FALSE(point.hiddenBy(coincident, {2, 3, 1, 1}));
}

TEST(Predicates, ExactlyOneOfTwoTrianglesHidesAtTheirEdge) {
    const SurfacePoint point(kDown, kFloor);
    const Corners left{{{2, 1, 0}, {0, 1, 1}, {2, 1, 2}}}, right{{{2, 1, 2}, {4, 1, 1}, {2, 1, 0}}};
    for (const glm::dvec4& light : {glm::dvec4(2, 3, 1, 1), glm::dvec4(0, 1, 0, 0)}) {
        EXPECT_NE(point.hiddenBy(left, light), point.hiddenBy(right, light));
    }
}

TEST(Predicates, ExactlyOneOfSixTrianglesHidesAtTheirVertex) {
    const SurfacePoint point(kDown, kFloor);
    const glm::dvec3 hub(2, 1, 1);
    const std::array<glm::dvec3, 6> rim{{{3, 1, 1}, {3, 1, 2}, {2, 1, 2}, {1, 1, 1}, {1, 1, 0}, {2, 1, 0}}};
    int hiding = 0;
    for (std::size_t i = 0; i < 6; ++i) {
        hiding += point.hiddenBy({hub, rim[i], rim[(i + 1) % 6]}, {2, 3, 1, 1});
    }
    EXPECT_EQ(hiding, 1);
}

TEST(Predicates, TheRoundedPositionIsTheExactOneToTheLastBitsWhateverTheAngle) {
    // Seen from 2^-40 above its plane the point is ten thousand metres away; the formula in doubles is off by metres.
    const glm::dvec3 u = turned({1, 0, 0}), v = turned({0, 0, 1});
    const Corners seen{-1e5 * u, 1e5 * v, 1e5 * (u - v)};
    const Ray ray{glm::dvec3(0.3, 0x1p-30, 0.1), 0.5 * u + 0.25 * v + glm::dvec3(0, -0x1p-46, 0)};
    ASSERT_NE(rational::sideOfRay(seen, ray), 0);
    const rational::Place exact = rational::pointOf(ray, seen);
    const glm::dvec3 p = SurfacePoint(ray, seen).position(1e-9);
    const double size = std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    EXPECT_NEAR(p.x, exact.x.get_d(), 1e-9 + size * 0x1p-52);
    EXPECT_NEAR(p.y, exact.y.get_d(), 1e-9 + size * 0x1p-52);
    EXPECT_NEAR(p.z, exact.z.get_d(), 1e-9 + size * 0x1p-52);
}

}  // namespace
}  // namespace umbrage::oracle
