// SPDX-License-Identifier: Apache-2.0
// Numbers that are the same on every machine: random numbers, sine and cosine from +, -, * and / alone, and the grid
// that positions lie on. The C library's sin() may differ in the last bit, and the scenes must not.
#pragma once

#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

namespace generator {

using glm::dmat4;
using glm::dquat;
using glm::dvec2;
using glm::dvec3;

inline constexpr double kPi = 3.14159265358979323846;

/// Rounds to a multiple of 2^-16 (15 micrometres at our scale): exact in float up to 256 m, and a point computed in
/// two ways becomes one point.
inline double snap(double value) {
    return std::round(value * 65536.0) / 65536.0;
}
inline dvec3 snap(const dvec3& value) {
    return {snap(value.x), snap(value.y), snap(value.z)};
}

/// Exact at multiples of 90 degrees, where shapes close.
inline double sinDegrees(double degrees) {
    double turns = degrees / 360.0;
    turns -= std::floor(turns + 0.5);  // [-1/2, 1/2]
    if (turns > 0.25) turns = 0.5 - turns;
    if (turns < -0.25) turns = -0.5 - turns;
    const double x = turns * 2.0 * kPi, squared = x * x;
    double term = x, sum = x;
    for (int power = 3; power < 24; power += 2) {
        term *= -squared / (power * (power - 1.0));
        sum += term;
    }
    constexpr double grid = 1099511627776.0;  // 2^40
    return std::round(sum * grid) / grid;
}
inline double cosDegrees(double degrees) {
    return sinDegrees(degrees + 90.0);
}

/// A rotation about a unit axis.
inline dquat turn(double degrees, const dvec3& axis) {
    const double s = sinDegrees(degrees / 2);
    return {cosDegrees(degrees / 2), axis.x * s, axis.y * s, axis.z * s};
}

inline double mix(double a, double b, double t) {
    return a + (b - a) * t;
}
inline double smooth(double t) {
    return t * t * (3 - 2 * t);
}

/// PCG32 (O'Neill 2014): small, fast, and defined to the last bit, unlike the distributions of <random>. Draw at most
/// one number per argument list: compilers evaluate arguments in different orders (braces keep theirs).
class Random {
public:
    explicit Random(std::uint64_t seed) : state_(seed * 6364136223846793005u + kIncrement) { next(); }

    std::uint32_t next() {
        const std::uint64_t old = state_;
        state_ = old * 6364136223846793005u + kIncrement;
        const auto shifted = static_cast<std::uint32_t>(((old >> 18u) ^ old) >> 27u);
        const auto rotation = static_cast<std::uint32_t>(old >> 59u);
        return (shifted >> rotation) | (shifted << ((32u - rotation) & 31u));
    }
    double between(double low, double high) { return low + (high - low) * (next() / 4294967296.0); }

private:
    static constexpr std::uint64_t kIncrement = 1442695040888963407u;
    std::uint64_t state_;
};

}  // namespace generator
