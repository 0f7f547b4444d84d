// SPDX-License-Identifier: Apache-2.0
// Closed surfaces and other shapes for tests, wound counter-clockwise seen from outside.
#pragma once

#include <glm/glm.hpp>
#include <map>
#include <vector>

#include "oracle/formulas.h"

namespace umbrage::oracle {

inline std::vector<Corners> box(const glm::dvec3& low, const glm::dvec3& high) {
    const auto corner = [&](int i) {
        return glm::dvec3(i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z);
    };
    constexpr int kFaces[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
    std::vector<Corners> triangles;
    for (const auto& f : kFaces) {
        triangles.push_back({corner(f[0]), corner(f[1]), corner(f[2])});
        triangles.push_back({corner(f[0]), corner(f[2]), corner(f[3])});
    }
    return triangles;
}

/// Vertices at distance 1 from the origin; 20 * 4^level triangles.
inline std::vector<Corners> icosphere(int level) {
    const double g = 0.5 * (1.0 + std::sqrt(5.0));
    const std::array<glm::dvec3, 12> v{{{-1, g, 0},
                                        {1, g, 0},
                                        {-1, -g, 0},
                                        {1, -g, 0},
                                        {0, -1, g},
                                        {0, 1, g},
                                        {0, -1, -g},
                                        {0, 1, -g},
                                        {g, 0, -1},
                                        {g, 0, 1},
                                        {-g, 0, -1},
                                        {-g, 0, 1}}};
    constexpr std::size_t kFaces[20][3] = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                                           {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                                           {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                                           {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
    std::vector<Corners> triangles;
    for (const auto& f : kFaces) {
        triangles.push_back({glm::normalize(v[f[0]]), glm::normalize(v[f[1]]), glm::normalize(v[f[2]])});
    }
    for (; level > 0; --level) {
        std::vector<Corners> finer;
        for (const Corners& t : triangles) {
            // Sums commute, so both triangles of an edge get the same bits.
            const glm::dvec3 ab = glm::normalize(t[0] + t[1]), bc = glm::normalize(t[1] + t[2]);
            const glm::dvec3 ca = glm::normalize(t[2] + t[0]);
            for (const Corners& part : {Corners{t[0], ab, ca}, {ab, t[1], bc}, {ca, bc, t[2]}, {ab, bc, ca}}) {
                finer.push_back(part);
            }
        }
        triangles = std::move(finer);
    }
    return triangles;
}

template <class Move>
std::vector<Corners> moved(std::vector<Corners> triangles, Move&& move) {
    for (Corners& t : triangles) {
        for (glm::dvec3& p : t) p = move(p);
    }
    return triangles;
}

/// Two triangles, counter-clockwise a, b, c, d.
inline std::vector<Corners> quad(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d) {
    return {Corners{a, b, c}, Corners{a, c, d}};
}

inline void append(std::vector<Corners>& to, const std::vector<Corners>& more) {
    to.insert(to.end(), more.begin(), more.end());
}

}  // namespace umbrage::oracle
