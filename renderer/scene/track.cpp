// SPDX-License-Identifier: Apache-2.0
// The value of a track at a time, by glTF 2.0, appendix C.
#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstring>
#include <glm/gtc/quaternion.hpp>
#include <limits>

#include "scene/moment.h"

namespace umbrage {
namespace {

glm::dquat quaternionOf(const float* v) {
    return {v[3], v[0], v[1], v[2]};
}

void store(const glm::dquat& q, std::span<float> result) {
    result[0] = static_cast<float>(q.x);
    result[1] = static_cast<float>(q.y);
    result[2] = static_cast<float>(q.z);
    result[3] = static_cast<float>(q.w);
}

/// The key's value, without its tangents.
const float* valueOf(const Track& track, std::size_t key) {
    const auto width = static_cast<std::size_t>(track.width);
    return track.interpolation == Interpolation::CubicSpline ? &track.values[(3 * key + 1) * width]
                                                             : &track.values[key * width];
}

void hold(const Track& track, std::size_t key, bool spherical, std::span<float> result) {
    const float* value = valueOf(track, key);
    if (spherical) {
        store(glm::normalize(quaternionOf(value)), result);
    } else {
        std::copy_n(value, result.size(), result.begin());
    }
}

void interpolateLinear(const float* a, const float* b, double s, std::span<float> result) {
    for (std::size_t i = 0; i < result.size(); ++i) {
        result[i] = static_cast<float>((1.0 - s) * a[i] + s * b[i]);
    }
}

// glm's slerp takes the shorter way and is a plain mix where the sine would vanish.
void interpolateSpherical(const float* a, const float* b, double s, std::span<float> result) {
    store(glm::normalize(glm::slerp(glm::normalize(quaternionOf(a)), glm::normalize(quaternionOf(b)), s)), result);
}

// Hermite spline whose tangents are per second, so that they are scaled by the distance of the keys.
void interpolateCubic(const Track& track, std::size_t key, double s, std::span<float> result) {
    const auto width = static_cast<std::size_t>(track.width);
    const double distance = double{track.timesSeconds[key + 1]} - double{track.timesSeconds[key]};
    const double s2 = s * s, s3 = s2 * s;
    const float* value = valueOf(track, key);
    const float* outTangent = value + width;
    const float* nextInTangent = outTangent + width;
    const float* nextValue = nextInTangent + width;
    for (std::size_t i = 0; i < width; ++i) {
        const double sum = (2.0 * s3 - 3.0 * s2 + 1.0) * value[i] + distance * (s3 - 2.0 * s2 + s) * outTangent[i] +
                           (-2.0 * s3 + 3.0 * s2) * nextValue[i] + distance * (s3 - s2) * nextInTangent[i];
        // Huge tangents overshoot what a float can hold; an infinity would spread into every transform.
        constexpr double kLargest = std::numeric_limits<float>::max();
        result[i] = static_cast<float>(std::clamp(sum, -kLargest, kLargest));
    }
}

// A spline between opposite quaternions can pass through zero, where no direction is left to normalise.
void normalizeSpline(const Track& track, std::size_t key, std::span<float> result) {
    const glm::dquat q = quaternionOf(result.data());
    const double length = glm::length(q);
    if (length > 0.0 && std::isfinite(length)) {
        store(q / length, result);
    } else {
        hold(track, key, true, result);
    }
}

/// Whether nothing moves between a key and the next.
bool isStill(const Track& track, std::size_t key) {
    const auto width = static_cast<std::size_t>(track.width);
    const float *value = valueOf(track, key), *next = valueOf(track, key + 1);
    if (std::memcmp(value, next, width * sizeof *value) != 0) return false;
    if (track.interpolation != Interpolation::CubicSpline) return true;
    const auto isZero = [](float tangent) { return tangent == 0.0f; };
    return std::all_of(value + width, value + 2 * width, isZero) && std::all_of(next - width, next, isZero);
}

}  // namespace

bool isConstant(const Track& track) {
    for (std::size_t key = 0; key + 1 < track.timesSeconds.size(); ++key) {
        if (!isStill(track, key)) return false;
    }
    return true;
}

void sample(const Track& track, double timeSeconds, bool spherical, std::span<float> result) {
    assert(result.size() == static_cast<std::size_t>(track.width) && (!spherical || track.width == 4));
    const std::vector<float>& times = track.timesSeconds;
    const auto after = std::upper_bound(times.begin(), times.end(), timeSeconds);
    if (after == times.begin()) {
        return hold(track, 0, spherical, result);
    }
    const auto key = static_cast<std::size_t>(after - times.begin()) - 1;
    // Interpolated, what stands still would differ by its rounding from frame to frame.
    if (after == times.end() || track.interpolation == Interpolation::Step || isStill(track, key)) {
        return hold(track, key, spherical, result);
    }
    const double s = (timeSeconds - times[key]) / (double{times[key + 1]} - double{times[key]});
    if (track.interpolation == Interpolation::CubicSpline) {
        interpolateCubic(track, key, s, result);
        if (spherical) {
            normalizeSpline(track, key, result);
        }
    } else if (spherical) {
        interpolateSpherical(valueOf(track, key), valueOf(track, key + 1), s, result);
    } else {
        interpolateLinear(valueOf(track, key), valueOf(track, key + 1), s, result);
    }
}

}  // namespace umbrage
