// SPDX-License-Identifier: Apache-2.0
// The oracle's answers against asking every triangle in rationals, and each of its rules by itself.
#include "oracle/oracle.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>

#include "rational.h"
#include "soups.h"
#include "surfaces.h"

namespace umbrage::oracle {
namespace {

constexpr double kForever = std::numeric_limits<double>::infinity();

std::uint32_t bruteSee(const std::vector<Triangle>& triangles, const EyeRay& ray, std::uint32_t solid) {
    std::uint32_t nearest = kNothing;
    mpq_class least;
    for (std::uint32_t i = 0; i < triangles.size(); ++i) {
        const Triangle& t = triangles[i];
        const int side = rational::sideOfRay(t.corners, ray);
        if (!t.visible || (t.holed && i != solid) || side == 0 || (t.singleSided && side < 0)) continue;
        if (!rational::meets(ray, t.corners)) continue;
        const mpq_class depth = rational::depth(ray, t.corners);
        if (depth < mpq_class(ray.near) || (ray.far < kForever && depth > mpq_class(ray.far))) continue;
        if (nearest != kNothing && depth >= least) continue;
        nearest = i;
        least = depth;
    }
    return nearest;
}

std::vector<bool> bruteHiders(const std::vector<Triangle>& triangles, std::uint32_t seen, const Ray& ray,
                              const glm::dvec4& light) {
    const rational::Place p = rational::pointOf(ray, triangles[seen].corners);
    std::vector<bool> hides(triangles.size());
    for (std::uint32_t i = 0; i < triangles.size(); ++i) {
        hides[i] = i != seen && triangles[i].casts && rational::hides(triangles[i].corners, p, light);
    }
    return hides;
}

rc::Gen<std::vector<Triangle>> scenes(Snap snap) {
    const auto rarely = rc::gen::map(range(0, 4), [](int i) { return i == 0; });
    const auto mostly = rc::gen::map(range(0, 4), [](int i) { return i != 0; });
    return rc::gen::container<std::vector<Triangle>>(
        10,
        rc::gen::build<Triangle>(rc::gen::set(&Triangle::corners, triangles(snap)),
                                 rc::gen::set(&Triangle::casts, mostly), rc::gen::set(&Triangle::visible, mostly),
                                 rc::gen::set(&Triangle::singleSided, rarely), rc::gen::set(&Triangle::holed, rarely)));
}

RC_GTEST_PROP(Oracle, AnswersAsAskingEveryTriangleInRationalsDoes, ()) {
    const Snap snap = *anySnap();
    const double s = *rc::gen::element(1.0, 0x1p-126, 0x1p100);
    const glm::dvec3 offset = *rc::gen::element(0.0, 0.0, 0x1p23) * glm::dvec3(s, -s, 2.0 * s);
    std::vector<Triangle> triangles = *scenes(snap);
    for (Triangle& t : triangles) {
        for (glm::dvec3& p : t.corners) p = s * p + offset;
    }
    const Oracle oracle(triangles);
    const std::vector<glm::dvec4> lamps = draw(3, lights(snap));
    for (const Ray& drawn : draw(6, rays(snap))) {
        EyeRay ray;
        ray.origin = s * drawn.origin + offset;
        ray.direction = s * drawn.direction;
        ray.near = *rc::gen::element(0.0, 0.25, 0.5);
        ray.far = *rc::gen::element(kForever, 1.0, 2.0);
        const std::uint32_t solid = *range<std::uint32_t>(0, 20);
        const std::uint32_t seen = oracle.see(ray, solid);
        RC_ASSERT(seen == bruteSee(triangles, ray, solid));
        if (seen == kNothing) continue;
        for (const glm::dvec4& lamp : lamps) {
            const glm::dvec4 light(lamp.w != 0.0 ? s * glm::dvec3(lamp) + offset : glm::dvec3(lamp), lamp.w);
            const int side = rational::sideOfLight(triangles[seen].corners, light);
            RC_ASSERT(oracle.turnedTo(light, seen, ray) ==
                      (side != 0 && side == rational::sideOfRay(triangles[seen].corners, ray)));
            const std::vector<bool> hiders = bruteHiders(triangles, seen, ray, light);
            const auto layers = std::count(hiders.begin(), hiders.end(), true);
            const std::uint32_t hider = oracle.hiddenBy(light, seen, ray);
            RC_ASSERT((hider == kNothing) == (layers == 0));
            if (hider != kNothing) RC_ASSERT(hiders[hider]);
            RC_ASSERT(oracle.layersBefore(light, seen, ray) == std::uint32_t(layers));
        }
    }
}

TEST(Oracle, MissesNoCasterWhereTheSurfaceIsSeenAtAGrazingAngle) {
    // The seen point is some thousand metres away, and ordinary arithmetic places it tens of metres wrong. Around it
    // are small casters, one of them between it and the light.
    const glm::dvec3 u = turned({1, 0, 0}), v = turned({0, 0, 1}), up = glm::normalize(glm::cross(v, u));
    std::vector<Triangle> triangles{{.corners = {-1e5 * u - 1e5 * v, 3e5 * v - 1e5 * u, 3e5 * u - 1e5 * v}}};
    EyeRay ray;
    ray.origin = 1e-9 * up;
    ray.direction = 0.6 * u + 0.7 * v - 0x1p-42 * up;
    ray.far = kForever;
    const Bounded distance = distanceAlong(ray, triangles[0].corners);
    ASSERT_GT(distance.error, 10.0);
    const rational::Place exact = rational::pointOf(ray, triangles[0].corners);
    const glm::dvec3 p(exact.x.get_d(), exact.y.get_d(), exact.z.get_d());
    const glm::dvec3 above = p + 0.001 * up;
    for (int i = -20; i <= 20; ++i) {
        const glm::dvec3 c = above + 0.002 * double(i) * u;
        triangles.push_back(
            {.corners = {c - 0.001 * u - 0.001 * v, c - 0.001 * u + 0.002 * v, c + 0.002 * u - 0.001 * v}});
    }
    const Oracle oracle(triangles);
    for (const glm::dvec4& light : {glm::dvec4(up, 0.0), glm::dvec4(p + up, 1.0)}) {
        const std::vector<bool> hiders = bruteHiders(triangles, 0, ray, light);
        const auto layers = std::count(hiders.begin(), hiders.end(), true);
        ASSERT_GE(layers, 1);
        EXPECT_NE(oracle.hiddenBy(light, 0, ray), kNothing);
        EXPECT_EQ(oracle.layersBefore(light, 0, ray), std::uint32_t(layers));
    }
}

RC_GTEST_PROP(Oracle, SeesTheNearestOfTrianglesThatLieCloseTogether, ()) {
    std::vector<Triangle> triangles;
    for (const Corners& t : draw(30, oracle::triangles(Snap::Free))) {
        Corners flat = t;
        for (glm::dvec3& p : flat) p.z *= 1e-5;
        triangles.push_back({.corners = flat});
    }
    const Oracle oracle(triangles);
    for (const glm::dvec3& aim : draw(10, places(Snap::Free))) {
        EyeRay ray;
        ray.origin = {0.1, 0.2, 10.0};
        ray.direction = 0.3 * glm::dvec3(aim.x, aim.y, 0.0) - ray.origin;
        ray.far = kForever;
        RC_ASSERT(oracle.see(ray) == bruteSee(triangles, ray, kNothing));
    }
}

RC_GTEST_PROP(Oracle, OfTrianglesInOnePlaneTheFirstIsSeenHoweverTheirDepthsRound, ()) {
    // The same triangle from each of its corners: one plane, three roundings.
    const Corners t = *oracle::triangles(Snap::Turned);
    std::vector<Triangle> triangles{{.corners = {t[1], t[2], t[0]}}, {.corners = t}, {.corners = {t[2], t[0], t[1]}}};
    const Oracle oracle(triangles);
    for (const Ray& drawn : draw(10, rays(Snap::Turned))) {
        EyeRay ray;
        ray.origin = drawn.origin;
        ray.direction = (t[0] + t[1] + t[2]) / 3.0 - drawn.origin;
        ray.far = kForever;
        if (ray.direction == glm::dvec3(0.0) || rational::sideOfRay(t, ray) == 0) continue;
        RC_ASSERT(oracle.see(ray) == bruteSee(triangles, ray, kNothing));
    }
}

// Rules.

EyeRay down(double x, double z, double near = 0.0, double far = kForever) {
    EyeRay ray;
    ray.origin = {x, 10, z};
    ray.direction = {0, -1, 0};
    ray.near = near;
    ray.far = far;
    return ray;
}

/// A square of half size 1 around the y axis, its front up.
std::vector<Triangle> plate(double y) {
    std::vector<Triangle> triangles;
    for (const Corners& t : quad({-1, y, -1}, {-1, y, 1}, {1, y, 1}, {1, y, -1})) triangles.push_back({.corners = t});
    return triangles;
}

Corners flipped(const Corners& t) {
    return {t[0], t[2], t[1]};
}

TEST(Oracle, SeesBacksOnlyOfWhatHasTwoSides) {
    std::vector<Triangle> triangles = plate(1);
    triangles[0].singleSided = true;
    triangles.push_back({.corners = plate(0)[0].corners});
    EXPECT_EQ(Oracle(triangles).see(down(-0.25, 0.25)), 0u);
    triangles[0].corners = flipped(triangles[0].corners);
    EXPECT_EQ(Oracle(triangles).see(down(-0.25, 0.25)), 2u);
    triangles[0].singleSided = false;
    EXPECT_EQ(Oracle(triangles).see(down(-0.25, 0.25)), 0u);
}

TEST(Oracle, SeesWhatLiesBetweenNearAndFarEndsIncluded) {
    std::vector<Triangle> triangles{plate(6)[0], plate(4)[0], plate(2)[0]};
    const Oracle oracle(triangles);
    EXPECT_EQ(oracle.see(down(-0.25, 0.25, 4.0, 8.0)), 0u);
    EXPECT_EQ(oracle.see(down(-0.25, 0.25, std::nextafter(4.0, 5.0), 8.0)), 1u);
    EXPECT_EQ(oracle.see(down(-0.25, 0.25, 7.0, 8.0)), 2u);
    EXPECT_EQ(oracle.see(down(-0.25, 0.25, 7.0, std::nextafter(8.0, 7.0))), kNothing);
    EXPECT_EQ(oracle.see(down(-0.25, 0.25, 9.0)), kNothing);
}

TEST(Oracle, LooksThroughHoledTrianglesButForTheOneThatIsSaidToBeSolid) {
    std::vector<Triangle> triangles{plate(2)[0], plate(1)[0], plate(0)[0]};
    triangles[0].holed = triangles[1].holed = true;
    const Oracle oracle(triangles);
    EXPECT_EQ(oracle.see(down(-0.25, 0.25)), 2u);
    EXPECT_EQ(oracle.see(down(-0.25, 0.25), 0), 0u);
    EXPECT_EQ(oracle.see(down(-0.25, 0.25), 1), 1u);
    EXPECT_EQ(oracle.layersBefore({0, 1, 0, 0}, 2, down(-0.25, 0.25)), 2u);  // they cast as wholes
}

TEST(Oracle, OfCoincidentTrianglesTheFirstIsSeenAndNoneHidesAnother) {
    std::vector<Triangle> triangles{plate(3)[0], plate(1)[0], plate(1)[0], plate(1)[0]};
    triangles[0].visible = false;
    triangles[2].corners = flipped(triangles[2].corners);
    std::swap(triangles[0], triangles[3]);
    const Oracle oracle(triangles);
    EXPECT_EQ(oracle.see(down(-0.25, 0.25)), 0u);
    EXPECT_EQ(oracle.layersBefore({0, 1, 0, 0}, 0, down(-0.25, 0.25)), 1u);
    EXPECT_EQ(oracle.hiddenBy({0, 1, 0, 0}, 0, down(-0.25, 0.25)), 3u);  // what is not seen casts
}

TEST(Oracle, OnlyWhatCastsHides) {
    std::vector<Triangle> triangles{plate(1)[0], plate(2)[0]};
    triangles[1].visible = false;
    EXPECT_EQ(Oracle(triangles).hiddenBy({0, 1, 0, 0}, 0, down(-0.25, 0.25)), 1u);
    triangles[1].casts = false;
    EXPECT_EQ(Oracle(triangles).hiddenBy({0, 1, 0, 0}, 0, down(-0.25, 0.25)), kNothing);
}

TEST(Oracle, CountsEveryLayer) {
    std::vector<Triangle> triangles = plate(0);
    for (int i = 1; i <= 300; ++i) triangles.push_back(plate(0.01 * i)[0]);
    const Oracle oracle(triangles);
    EXPECT_EQ(oracle.layersBefore({0, 1, 0, 0}, 0, down(-0.25, 0.25)), 300u);
    EXPECT_EQ(oracle.layersBefore({-0.25, 1.005, 0.25, 1}, 0, down(-0.25, 0.25)), 100u);
}

TEST(Oracle, ASurfaceIsTurnedToALightOnTheSideItIsSeenFrom) {
    const Oracle oracle(plate(0));
    EyeRay up = down(-0.25, 0.25);
    up.origin.y = -10;
    up.direction.y = 1;
    EXPECT_TRUE(oracle.turnedTo({0, 5, 0, 1}, 0, down(-0.25, 0.25)));
    EXPECT_FALSE(oracle.turnedTo({0, 5, 0, 1}, 0, up));
    EXPECT_TRUE(oracle.turnedTo({0, -5, 0, 1}, 0, up));
    EXPECT_TRUE(oracle.turnedTo({0, -1, 0, 0}, 0, up));
    EXPECT_FALSE(oracle.turnedTo({9, 0, 9, 1}, 0, up));
    EXPECT_FALSE(oracle.turnedTo({9, 0, 9, 1}, 0, down(-0.25, 0.25)));
}

TEST(EyeRays, GoThroughPixelCentresCountedFromTheUpperLeft) {
    PlacedCamera placed;
    placed.camera.yfov = 2.0 * std::atan(1.0);  // half extent 1
    placed.camera.znear = 0.5;
    placed.worldFromCamera[3] = {1, 2, 3, 1};
    const EyeRays rays(placed, 40, 20);
    const EyeRay first = rays.at(0.5, 0.5), middle = rays.at(20, 10);
    EXPECT_EQ(first.origin, glm::dvec3(1, 2, 3));
    EXPECT_NEAR(first.direction.x, -2.0 + 0.05, 1e-15);  // the picture's aspect, square pixels
    EXPECT_NEAR(first.direction.y, 1.0 - 0.05, 1e-15);
    EXPECT_EQ(first.direction.z, -1.0);
    EXPECT_EQ(first.near, 0.5);
    EXPECT_EQ(first.far, kForever);
    EXPECT_NEAR(glm::length(middle.direction - glm::dvec3(0, 0, -1)), 0.0, 1e-15);
}

TEST(EyeRays, OfOrthographicCamerasAreParallelAndEndAtZfar) {
    PlacedCamera placed;
    placed.camera.perspective = false;
    placed.camera.xmag = 99.0;
    placed.camera.ymag = 2.0;
    placed.camera.znear = 0.0;
    placed.camera.zfar = 7.0;
    const EyeRays rays(placed, 40, 20);
    EXPECT_EQ(rays.at(3, 4).direction, glm::dvec3(0, 0, -1));
    EXPECT_NEAR(rays.at(0, 0).origin.x, -4.0, 1e-15);
    EXPECT_NEAR(rays.at(0, 0).origin.y, 2.0, 1e-15);
    EXPECT_EQ(rays.at(3, 4).far, 7.0);
}

TEST(Oracle, LightsStandWhereTheyArePlaced) {
    PlacedLight light;
    light.position = {1, 2, 3};
    light.direction = {0, -1, 0};
    light.light.type = LightType::Spot;
    EXPECT_EQ(placeOf(light), glm::dvec4(1, 2, 3, 1));
    light.light.type = LightType::Directional;
    EXPECT_EQ(placeOf(light), glm::dvec4(0, 1, 0, 0));
}

}  // namespace
}  // namespace umbrage::oracle
