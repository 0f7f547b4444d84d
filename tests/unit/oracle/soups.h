// SPDX-License-Identifier: Apache-2.0
// Random triangles, eyes and lights. On a coarse grid everything that can coincide does; turned and rounded, the same
// scenes miss by the last bits of a float; free ones are ordinary.
#pragma once

#include "draws.h"
#include "oracle/formulas.h"

namespace umbrage::oracle {

enum class Snap { Grid, Turned, Free };

inline rc::Gen<Snap> anySnap() {
    return rc::gen::element(Snap::Grid, Snap::Turned, Snap::Free);
}

/// No axis is aligned, no coordinate is kept.
inline glm::dvec3 turned(const glm::dvec3& p) {
    const glm::dmat3 turn(0.5, 0.7, -0.51, -0.86, 0.42, -0.27, 0.03, 0.57, 0.81);
    return glm::dvec3(glm::vec3(turn * p));
}

inline rc::Gen<double> coordinates(Snap snap) {
    if (snap == Snap::Free) {
        return rc::gen::map(range<long>(-(1L << 40), 1L << 40), [](long i) { return double(i) * 0x1p-39; });
    }
    return rc::gen::map(range(-4, 5), [](int i) { return 0.5 * i; });
}

/// In the cube of half size 2 (turned: a little more).
inline rc::Gen<glm::dvec3> places(Snap snap) {
    const auto c = coordinates(snap);
    return rc::gen::map(rc::gen::tuple(c, c, c), [snap](const std::tuple<double, double, double>& v) {
        const glm::dvec3 p(std::get<0>(v), std::get<1>(v), std::get<2>(v));
        return snap == Snap::Turned ? turned(p) : p;
    });
}

inline rc::Gen<Corners> triangles(Snap snap) {
    return rc::gen::container<Corners>(places(snap));
}

inline rc::Gen<std::vector<Corners>> soups(Snap snap, std::size_t count) {
    return rc::gen::container<std::vector<Corners>>(count, triangles(snap));
}

/// A point, or a direction (w = 0).
inline rc::Gen<glm::dvec4> lights(Snap snap) {
    return rc::gen::map(rc::gen::pair(places(snap), rc::gen::element(0.0, 1.0)), [](const auto& light) {
        const bool nowhere = light.second == 0.0 && light.first == glm::dvec3(0.0);
        return glm::dvec4(nowhere ? glm::dvec3(0, 1, 0) : light.first, light.second);
    });
}

/// From a place towards another.
inline rc::Gen<Ray> rays(Snap snap) {
    return rc::gen::map(rc::gen::pair(places(snap), places(snap)), [](const auto& ends) {
        const glm::dvec3 direction = ends.second - ends.first;
        return Ray{ends.first, direction == glm::dvec3(0.0) ? glm::dvec3(0, 0, -1) : direction};
    });
}

}  // namespace umbrage::oracle
