// SPDX-License-Identifier: Apache-2.0
#include "golden/flip_color.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

namespace umbrage::flip {
namespace {

/// XYZ of the linear colour, over that of white; from the chromaticities of Rec.709 (ITU-R BT.709, D65).
glm::dmat3 makeRelativeXyzFromLinear() {
    const auto xyz = [](double x, double y) { return glm::dvec3(x / y, 1.0, (1.0 - x - y) / y); };
    const glm::dmat3 primaries(xyz(0.64, 0.33), xyz(0.30, 0.60), xyz(0.15, 0.06));
    const glm::dvec3 white = xyz(0.3127, 0.3290);
    const glm::dvec3 scale = glm::inverse(primaries) * white;
    glm::dmat3 matrix(scale.x * primaries[0], scale.y * primaries[1], scale.z * primaries[2]);
    for (int column = 0; column < 3; ++column) matrix[column] /= white;
    return matrix;
}

const glm::dmat3 kRelativeXyzFromLinear = makeRelativeXyzFromLinear();
const glm::mat3 kXyz(kRelativeXyzFromLinear);
const glm::mat3 kLinear(glm::inverse(kRelativeXyzFromLinear));

/// CIE 1976: the cube root, with a line for what is dark.
float lightnessOf(float share) {
    constexpr float kKnee = 6.0f / 29.0f;
    return share > kKnee * kKnee * kKnee ? std::cbrt(share) : share / (3.0f * kKnee * kKnee) + 4.0f / 29.0f;
}

constexpr float kExponent = 0.7f, kBendDistance = 0.4f, kBendError = 0.95f;

/// The largest distance of two colours that a display can show, green and blue, to the power of kExponent.
float largestPower() {
    static const float power = std::pow(hyab(huntLabOf({0, 1, 0}), huntLabOf({0, 0, 1})), kExponent);
    return power;
}

}  // namespace

glm::vec3 ycxczOf(const glm::vec3& linear) {
    const glm::vec3 xyz = kXyz * linear;
    return {116.0f * xyz.y - 16.0f, 500.0f * (xyz.x - xyz.y), 200.0f * (xyz.y - xyz.z)};
}

glm::vec3 linearOf(const glm::vec3& ycxcz) {
    const float y = (ycxcz.x + 16.0f) / 116.0f;
    return kLinear * glm::vec3(y + ycxcz.y / 500.0f, y, y - ycxcz.z / 200.0f);
}

float luminanceOf(const glm::vec3& linear) {
    return (kXyz * linear).y;
}

glm::vec3 huntLabOf(const glm::vec3& linear) {
    const glm::vec3 xyz = kXyz * linear;
    const float x = lightnessOf(xyz.x), y = lightnessOf(xyz.y), z = lightnessOf(xyz.z);
    const float lightness = 116.0f * y - 16.0f, hunt = 0.01f * lightness;
    return {lightness, hunt * 500.0f * (x - y), hunt * 200.0f * (y - z)};
}

float hyab(const glm::vec3& a, const glm::vec3& b) {
    const glm::vec3 d = a - b;
    return std::abs(d.x) + std::sqrt(d.y * d.y + d.z * d.z);
}

float redistributed(float distance) {
    const float power = std::pow(distance, kExponent), largest = largestPower(), bend = kBendDistance * largest;
    if (power < bend) return kBendError / bend * power;
    return std::min(1.0f, kBendError + (power - bend) / (largest - bend) * (1.0f - kBendError));
}

}  // namespace umbrage::flip
