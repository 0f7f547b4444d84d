// SPDX-License-Identifier: Apache-2.0
#include "shadow/host_predicates.h"

#include <algorithm>
#include <cmath>

#include "shadow/silhouette.h"

namespace umbrage {
namespace {

/// d.(a x b); see determinant3() in facing.comp.glsl.
double determinant3(const glm::dvec3& d, const glm::dvec3& a, const glm::dvec3& b, glm::dvec3& n) {
    n = glm::cross(a, b);
    return d.x * n.x + d.y * n.y + d.z * n.z;
}

bool isRounding(double det, const glm::dvec3& d, const glm::dvec3& a, const glm::dvec3& b) {
    const glm::dvec3 sizes(std::abs(a.y * b.z) + std::abs(a.z * b.y), std::abs(a.z * b.x) + std::abs(a.x * b.z),
                           std::abs(a.x * b.y) + std::abs(a.y * b.x));
    return std::abs(det) < 1e-14 * glm::dot(glm::abs(d), sizes);
}

/// Sign of det[d, a, b]; see exactSign() in facing.comp.glsl.
int exactSign(const glm::dvec3& d, const glm::dvec3& a, const glm::dvec3& b, bool& undecided) {
    glm::dvec3 n;
    const double det = determinant3(d, a, b, n);
    if (det != 0.0) {
        undecided = undecided || isRounding(det, d, a, b);
        return det > 0.0 ? 1 : -1;
    }
    for (int i = 0; i < 3; ++i) {
        if (n[i] != 0.0) return n[i] > 0.0 ? 1 : -1;
    }
    return -1;
}

bool crosses(const glm::dvec3& origin, const glm::dvec3& d, const TriangleCorners& v, bool& undecided) {
    int sign[3];
    for (int i = 0; i < 3; ++i) {
        sign[i] = exactSign(d, glm::dvec3(v[i]) - origin, glm::dvec3(v[(i + 1) % 3]) - origin, undecided);
    }
    return sign[0] == sign[1] && sign[1] == sign[2];
}

/// See edges.comp.glsl.
bool inWedge(const glm::vec4& eye, const glm::vec4& light, const glm::vec3& a, const glm::vec3& b) {
    const glm::vec3 l(light), p(eye);
    const glm::vec3 e = eye.w == 0.0f ? p : light.w == 0.0f ? p - a : p - l;
    const glm::vec3 u = light.w == 0.0f ? b - a : a - l, v = light.w == 0.0f ? -l : b - l;
    const glm::vec3 n = glm::cross(u, v);
    const float squared = glm::dot(n, n);
    constexpr float kMargin = 0x1p-6f;
    const float alongU = glm::dot(glm::cross(e, v), n) / squared;
    const float alongV = glm::dot(glm::cross(u, e), n) / squared;
    if (eye.w == 0.0f) {
        return alongU * glm::length(u) > -kMargin * glm::length(e) &&
               alongV * glm::length(v) > -kMargin * glm::length(e);
    }
    if (light.w == 0.0f) {
        return alongU > -kMargin && alongU < 1.0f + kMargin &&
               alongV * glm::length(v) > -kMargin * (glm::length(u) + glm::length(e));
    }
    return alongU > -kMargin && alongV > -kMargin && alongU + alongV > 1.0f - kMargin;
}

}  // namespace

bool mayHoldFarEnds(const gpu::InstanceData& instance, const gpu::CasterState& caster, std::uint32_t l) {
    return instance.eyeInModel.w == 0.0f && endOfVolume(caster, l) == 0;
}

float sideOf(const glm::vec3& n, const glm::vec3& a, const glm::vec4& p) {
    const glm::vec3 d = glm::vec3(p) - p.w * a;
    return n.x * d.x + n.y * d.y + n.z * d.z;
}

float sideOfNearLight(const TriangleCorners& t, const glm::dvec3& light) {
    const glm::dvec3 a(t[0]), u = glm::dvec3(t[1]) - a, v = glm::dvec3(t[2]) - a, d = light - a;
    glm::dvec3 n;
    const double side = determinant3(d, u, v, n);
    return isRounding(side, d, u, v) ? 0.0f : float(glm::sign(side));
}

bool inBoxOf(const TriangleCorners& t, const glm::vec4& light) {
    const glm::vec3 low = glm::min(t[0], glm::min(t[1], t[2])), high = glm::max(t[0], glm::max(t[1], t[2])), l(light);
    return light.w != 0.0f && glm::all(glm::greaterThanEqual(l, low)) && glm::all(glm::lessThanEqual(l, high));
}

bool hazardous(const glm::vec4& start, const glm::vec4& light, const glm::vec3& a, const glm::vec3& b) {
    if (start.w == 0.0f && light.w == 0.0f) return false;
    const glm::vec3 l(light), p(start);
    const glm::vec3 e = start.w == 0.0f ? p : light.w == 0.0f ? p - a : p - l;
    const glm::vec3 n = light.w == 0.0f ? glm::cross(b - a, -l) : glm::cross(a - l, b - l);
    const float scale =
        start.w == 0.0f ? glm::length(e) : std::max({glm::length(e), glm::distance(p, a), glm::distance(p, b)});
    return std::abs(glm::dot(n, e)) < float(HAZARD) * scale * glm::length(n) && inWedge(start, light, a, b);
}

bool eyeIsOn(const glm::vec4& homogeneousEye, const glm::vec3& n, const TriangleCorners& t) {
    if (homogeneousEye.w == 0.0f) return false;
    const glm::vec3 eye(homogeneousEye);
    const float near =
        float(HAZARD) * std::max({glm::distance(eye, t[0]), glm::distance(eye, t[1]), glm::distance(eye, t[2])});
    const glm::vec3 low = glm::min(t[0], glm::min(t[1], t[2])) - near;
    const glm::vec3 high = glm::max(t[0], glm::max(t[1], t[2])) + near;
    return std::abs(sideOf(n, t[0], homogeneousEye)) <= near * glm::length(n) &&
           glm::all(glm::greaterThanEqual(eye, low)) && glm::all(glm::lessThanEqual(eye, high));
}

bool isSliver(const glm::vec4& eye, const glm::vec4& light, const glm::vec3& a, const glm::vec3& b) {
    const glm::vec3 l = light.w == 0.0f ? glm::vec3(light) : glm::vec3(light) - a;
    const glm::vec3 e = eye.w == 0.0f ? glm::vec3(eye) : glm::vec3(eye) - a;
    return std::abs(glm::dot(glm::cross(b - a, l), e)) <
           float(EDGE_ON_SINE) * glm::length(b - a) * glm::length(l) * glm::length(e);
}

bool endsInQuad(const glm::vec4& end, const glm::vec4& light, const glm::vec3& a, const glm::vec3& b) {
    if (end.w == 0.0f && light.w == 0.0f) return false;
    const glm::vec3 n = glm::cross(b - a, light.w == 0.0f ? glm::vec3(light) : glm::vec3(light) - a);
    const glm::vec3 e = end.w == 0.0f ? glm::vec3(end) : glm::vec3(end) - a;
    return std::abs(glm::dot(n, e)) < float(IN_LINE_SINE) * glm::length(n) * glm::length(e) &&
           inWedge(end, light, a, b);
}

bool isOver(const glm::vec4& end, const glm::vec4& light, float lightSide, const TriangleCorners& v, const glm::vec3& n,
            bool& undecided) {
    const bool orthographic = end.w == 0.0f;
    if (orthographic && light.w == 0.0f) return false;
    const float endSide = sideOf(n, v[0], end);
    if (endSide == 0.0f || (endSide > 0.0f) == (lightSide > 0.0f)) return false;
    const glm::dvec3 e(end), p(light);
    return orthographic ? crosses(p, e, v, undecided) : crosses(e, p - double(light.w) * e, v, undecided);
}

}  // namespace umbrage
