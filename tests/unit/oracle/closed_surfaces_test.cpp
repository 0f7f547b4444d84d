// SPDX-License-Identifier: Apache-2.0
// A closed surface has neither gaps nor double edges: what goes in comes out, exactly through vertices and edges too.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "oracle/predicates.h"
#include "soups.h"
#include "surfaces.h"

namespace umbrage::oracle {
namespace {

glm::dvec3 rounded(const glm::dvec3& p) {
    return 0.5 * glm::round(2.0 * p);
}

/// Boxes and icospheres within half size 4, on the grid: some parts flat, folded or without area, all closed.
rc::Gen<std::vector<Corners>> closedSurfaces() {
    const auto boxes = rc::gen::map(rc::gen::pair(places(Snap::Grid), places(Snap::Grid)),
                                    [](const auto& c) { return box(c.first, c.second); });
    const auto spheres = [](Snap snap) {
        return rc::gen::map(rc::gen::tuple(range(0, 3), range(1, 5), places(snap)), [snap](const auto& s) {
            return moved(icosphere(std::get<0>(s)), [&](const glm::dvec3& p) {
                const glm::dvec3 q = 0.5 * std::get<1>(s) * p + std::get<2>(s);
                return snap == Snap::Grid ? rounded(q) : q;
            });
        });
    };
    return rc::gen::oneOf(boxes, spheres(Snap::Grid), spheres(Snap::Free));
}

/// A place that is one of the surface's vertices, or the middle of an edge, or on the grid.
glm::dvec3 target(const std::vector<Corners>& surface) {
    const Corners& t = surface[*range<std::size_t>(0, surface.size())];
    switch (*range(0, 3)) {
        case 0:
            return t[0];
        case 1:
            return 0.5 * (t[0] + t[1]);
        default:
            return *places(Snap::Grid);
    }
}

/// On the grid, outside of everything.
glm::dvec3 outside() {
    glm::dvec3 p = *places(Snap::Grid);
    p[*range(0, 3)] = *rc::gen::element(-8.0, 8.0);
    return p;
}

RC_GTEST_PROP(ClosedSurfaces, AnyLineLeavesThemAsOftenAsItEntersThem, ()) {
    const std::vector<Corners> surface = *closedSurfaces();
    for (int i = 0; i < 10; ++i) {
        const glm::dvec3 from = outside(), direction = target(surface) - from;
        int crossings = 0, entered = 0;
        for (const Corners& t : surface) {
            if (!meets({from, direction}, t)) continue;
            ++crossings;
            entered += sideOfRay(t, {from, direction});
        }
        RC_ASSERT(crossings % 2 == 0);
        RC_ASSERT(entered == 0);
    }
}

/// The way from a point of a small surface around `at` to a light.
SurfacePoint pointAt(const glm::dvec3& at) {
    const Corners around{at + glm::dvec3(-0.25, 0, -0.25), at + glm::dvec3(0.5, 0, 0), at + glm::dvec3(0, 0, 0.5)};
    return SurfacePoint({at + glm::dvec3(0, 1, 0), {0, -1, 0}}, around);
}

RC_GTEST_PROP(ClosedSurfaces, HideAnEvenNumberOfTimesBetweenPlacesOutside, ()) {
    const std::vector<Corners> surface = *closedSurfaces();
    for (int i = 0; i < 10; ++i) {
        const glm::dvec3 from = outside(), aim = target(surface);
        const SurfacePoint point = pointAt(from);
        // The light beyond the target, as far again: exact, for all are on the grid or near it.
        const glm::dvec4 light =
            *rc::gen::element(glm::dvec4(aim + 4.0 * (aim - from), 1.0), glm::dvec4(aim - from, 0.0));
        int crossings = 0, entered = 0;
        for (const Corners& t : surface) {
            if (!point.hiddenBy(t, light)) continue;
            ++crossings;
            entered += sideOfLight(t, light);
        }
        RC_ASSERT(crossings % 2 == 0);
        RC_ASSERT(entered == 0);
    }
}

RC_GTEST_PROP(ClosedSurfaces, HideAnOddNumberOfTimesFromALightInside, ()) {
    const glm::dvec3 centre = *places(Snap::Free);
    const std::vector<Corners> sphere =
        moved(icosphere(*range(0, 3)), [&](const glm::dvec3& p) { return rounded(1.5 * p) + rounded(centre); });
    const glm::dvec4 light(rounded(centre) + 0.25 * *places(Snap::Grid), 1.0);
    RC_PRE(glm::length(glm::dvec3(light) - rounded(centre)) < 0.7);  // within the faces of the snapped sphere
    for (int i = 0; i < 10; ++i) {
        const SurfacePoint point = pointAt(outside());
        int crossings = 0;
        for (const Corners& t : sphere) crossings += point.hiddenBy(t, light);
        RC_ASSERT(crossings % 2 == 1);
    }
}

}  // namespace
}  // namespace umbrage::oracle
