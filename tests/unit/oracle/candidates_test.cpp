// SPDX-License-Identifier: Apache-2.0
// No triangle that a ray meets is ever left out, at any size, from any distance, along faces and through edges.
#include "oracle/candidates.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>
#include <random>
#include <set>

#include "oracle/predicates.h"
#include "soups.h"
#include "surfaces.h"

namespace umbrage::oracle {
namespace {

constexpr double kForever = std::numeric_limits<double>::infinity();

std::set<std::uint32_t> visited(const Candidates& candidates, const Ray& ray, double length) {
    std::set<std::uint32_t> result;
    candidates.along(ray, length, [&](std::uint32_t i) {
        result.insert(i);
        return length;
    });
    return result;
}

void expectNoneMissed(const std::vector<Corners>& soup, const Candidates& candidates, const Ray& ray, double length,
                      const glm::dvec3& displacement = glm::dvec3(0.0)) {
    const std::set<std::uint32_t> found = visited(candidates, {ray.origin + displacement, ray.direction}, length);
    for (std::uint32_t i = 0; i < soup.size(); ++i) {
        if (sideOfRay(soup[i], ray) == 0 || !meets(ray, soup[i]) || compareDepth(ray, soup[i], 0.0) < 0) continue;
        if (length < kForever && compareDepth(ray, soup[i], length) > 0) continue;
        RC_ASSERT(found.count(i) == 1u);
    }
}

/// Triangles on few planes, boxes that are all but flat, or anything.
rc::Gen<std::vector<Corners>> crowds() {
    const auto slivers =
        rc::gen::map(rc::gen::container<std::vector<std::pair<glm::dvec3, glm::dvec3>>>(
                         6, rc::gen::pair(places(Snap::Grid), places(Snap::Grid))),
                     [](const auto& boxes) {
                         std::vector<Corners> soup;
                         for (const auto& [low, extent] : boxes) {
                             append(soup, box(low, low + glm::dvec3(extent.x, extent.y, 1e-6 * extent.z)));
                         }
                         return soup;
                     });
    return rc::gen::oneOf(soups(Snap::Grid, 60), soups(Snap::Turned, 60), soups(Snap::Free, 60), slivers);
}

RC_GTEST_PROP(Candidates, MissNothingAtAnySize, ()) {
    const double s = *rc::gen::element(1.0, 1e-38, 1e-300, 1e30, 1e-6, 1e6);
    const auto scale = [&](const glm::dvec3& p) { return s * p; };
    const std::vector<Corners> soup = moved(*crowds(), scale);
    const Candidates candidates(soup);
    for (const Snap snap : {Snap::Grid, Snap::Turned, Snap::Free}) {
        for (const Ray& ray : draw(6, rays(snap))) {
            expectNoneMissed(soup, candidates, {s * ray.origin, ray.direction}, kForever);
            expectNoneMissed(soup, candidates, {s * ray.origin, s * ray.direction}, 1.0);
            expectNoneMissed(soup, candidates, {s * ray.origin, s * ray.direction}, 0.5);
        }
    }
}

RC_GTEST_PROP(Candidates, MissNothingFarFromTheWorldsOrigin, ()) {
    const glm::dvec3 far = *rc::gen::element(1e7, -1e7, 1e12, 0x1p53) * glm::dvec3(1.0, 0.5, -0.25);
    const auto move = [&](const glm::dvec3& p) { return p + far; };
    const std::vector<Corners> soup = moved(*crowds(), move);
    const Candidates candidates(soup);
    for (const Ray& ray : draw(8, rays(*anySnap()))) {
        expectNoneMissed(soup, candidates, {move(ray.origin), ray.direction}, kForever);
        expectNoneMissed(soup, candidates, {move(ray.origin), ray.direction}, 1.0);
    }
}

RC_GTEST_PROP(Candidates, MissNothingThatIsLookedAtFromAfar, ()) {
    const std::vector<Corners> soup = *crowds();
    const Candidates candidates(soup);
    const double distance = *rc::gen::element(10.0, 1e3, 1e7, 1e10, 1e15);
    for (int i = 0; i < 8; ++i) {
        // From far away through a vertex or the middle of an edge or a face.
        const Corners& t = soup[*range<std::size_t>(0, soup.size())];
        const glm::dvec3 aim = *rc::gen::element(t[0], 0.5 * (t[1] + t[2]), 0.25 * (t[0] + t[1] + 2.0 * t[2]));
        const glm::dvec3 from = aim + distance * *places(Snap::Free);
        const glm::dvec3 way = *rc::gen::element(1.0, 1e-3, 1e5) * (aim - from);
        if (way == glm::dvec3(0.0)) continue;
        expectNoneMissed(soup, candidates, {from, way}, kForever);
        expectNoneMissed(soup, candidates, {from, aim - from}, 1.0);
    }
}

RC_GTEST_PROP(Candidates, MissNothingAlongTheAxes, ()) {
    const std::vector<Corners> soup = *crowds();
    const Candidates candidates(soup);
    for (int i = 0; i < 10; ++i) {
        Ray ray{soup[*range<std::size_t>(0, soup.size())][0], glm::dvec3(0.0)};
        const int axis = *range(0, 3);
        ray.direction[axis] = *rc::gen::element(1.0, -1.0, 1e-20, -1e20);
        ray.origin[axis] = *rc::gen::element(ray.origin[axis], -2.0, 2.0, -5.0, 5.0, 1e6);
        expectNoneMissed(soup, candidates, ray, kForever);
        // Nearly along: a component that floats cannot tell from nothing.
        ray.direction[(axis + 1) % 3] = *rc::gen::element(1e-30, -1e-9) * ray.direction[axis];
        expectNoneMissed(soup, candidates, ray, kForever);
    }
}

RC_GTEST_PROP(Candidates, MissNothingWhenTheOriginIsOffByTheTolerance, ()) {
    const std::vector<Corners> soup = *crowds();
    const Candidates candidates(soup);
    for (const Ray& ray : draw(8, rays(*anySnap()))) {
        glm::dvec3 off(0.0);
        for (int k = 0; k < 3; ++k) off[k] = *rc::gen::element(-1.0, 1.0) * candidates.tolerance();
        expectNoneMissed(soup, candidates, ray, kForever, off);
    }
}

RC_GTEST_PROP(Candidates, AlwaysComeToTheNearestWhenTheLengthIsCutToIt, ()) {
    const std::vector<Corners> soup = *crowds();
    const Candidates candidates(soup);
    for (const Ray& ray : draw(10, rays(*anySnap()))) {
        const auto met = [&](std::uint32_t i) {
            return sideOfRay(soup[i], ray) != 0 && meets(ray, soup[i]) && compareDepth(ray, soup[i], 0.0) >= 0;
        };
        const auto nearer = [&](std::uint32_t i, std::uint32_t than) {
            return than == soup.size() || compareDepth(ray, soup[i], soup[than]) < 0;
        };
        std::uint32_t nearest = std::uint32_t(soup.size()), found = nearest;
        for (std::uint32_t i = 0; i < soup.size(); ++i) {
            if (met(i) && nearer(i, nearest)) nearest = i;
        }
        double length = kForever;
        candidates.along(ray, length, [&](std::uint32_t i) {
            if (met(i) && nearer(i, found)) {
                found = i;
                const Bounded distance = distanceAlong(ray, soup[i]);
                length = std::min(length, distance.value + distance.error);
            }
            return length;
        });
        RC_ASSERT((found == soup.size()) == (nearest == soup.size()));
        if (found != nearest) RC_ASSERT(compareDepth(ray, soup[found], soup[nearest]) == 0);
    }
}

TEST(Candidates, StopWhenNothingIsOfInterest) {
    std::vector<Corners> stack;
    for (int i = 0; i < 50; ++i) {
        append(stack, quad({0, i, 0}, {0, i, 1}, {1, i, 1}, {1, i, 0}));
    }
    const Candidates candidates(stack);
    int calls = 0;
    candidates.along({{0.5, 60, 0.25}, {0, -1, 0}}, kForever, [&](std::uint32_t) {
        ++calls;
        return -1.0;
    });
    EXPECT_GE(calls, 1);
    EXPECT_LE(calls, 4);  // what was in the same leaf
    EXPECT_LT(visited(candidates, {{0.5, 60, 0.25}, {0, -1, 0}}, 20.5).size(), 30u);
}

TEST(Candidates, AreFew) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> place(-10.0, 10.0), small(-0.1, 0.1);
    std::vector<Corners> soup(5000);
    for (Corners& t : soup) {
        const glm::dvec3 p(place(random), place(random), place(random));
        for (glm::dvec3& corner : t) corner = p + glm::dvec3(small(random), small(random), small(random));
    }
    const Candidates candidates(soup);
    std::size_t sum = 0;
    for (int i = 0; i < 200; ++i) {
        const Ray ray{{place(random), place(random), 30.0}, {small(random), small(random), -1.0}};
        sum += visited(candidates, ray, kForever).size();
    }
    EXPECT_LT(double(sum) / 200.0, 10.0);
}

TEST(Candidates, OfNothingAreNone) {
    EXPECT_TRUE(visited(Candidates({}), {{0, 0, 0}, {0, 0, -1}}, kForever).empty());
}

}  // namespace
}  // namespace umbrage::oracle
