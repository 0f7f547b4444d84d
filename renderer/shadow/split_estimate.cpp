// SPDX-License-Identifier: Apache-2.0
#include "shadow/split_estimate.h"

#include <algorithm>
#include <cmath>

namespace umbrage {
namespace {

/// Counter-clockwise (Andrew 1979).
std::vector<glm::dvec2> convexHull(std::vector<glm::dvec2> points) {
    std::sort(points.begin(), points.end(),
              [](const glm::dvec2& a, const glm::dvec2& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
    std::vector<glm::dvec2> hull;
    const auto turnsRight = [&](const glm::dvec2& p) {
        const glm::dvec2 a = hull[hull.size() - 2], b = hull.back();
        return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x) <= 0.0;
    };
    for (int way = 0; way < 2; ++way) {
        const std::size_t start = hull.size();
        for (const glm::dvec2& p : points) {
            while (hull.size() >= start + 2 && turnsRight(p)) hull.pop_back();
            hull.push_back(p);
        }
        hull.pop_back();
        std::reverse(points.begin(), points.end());
    }
    return hull;
}

/// The convex hull of points on screen; empty where some are not before the eye.
std::vector<glm::dvec2> outlineOnScreen(std::span<const glm::dvec3> points, const Eye& eye) {
    std::vector<glm::dvec2> seen;
    for (const glm::dvec3& p : points) {
        const glm::dvec4 clip = eye.clipFromView * (eye.viewFromWorld * glm::dvec4(p, 1.0));
        if (!(clip.w > 0.0)) return {};
        seen.push_back(VIEWPORT_SCALE * glm::dvec2(clip) / clip.w);
    }
    return convexHull(seen);
}

bool holds(const std::vector<glm::dvec2>& hull, const glm::dvec2& p) {
    for (std::size_t i = 0; i < hull.size(); ++i) {
        const glm::dvec2 a = hull[i], b = hull[(i + 1) % hull.size()];
        if ((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x) < 0.0) return false;
    }
    return true;
}

}  // namespace

std::vector<glm::dvec4> shadowOnScreen(std::span<const glm::dvec3> points, const Homogeneous& light, const Eye& eye,
                                       double& perimeter) {
    perimeter = 0.0;
    if (points.empty()) return {};
    glm::dvec3 mean(0.0);
    for (const glm::dvec3& p : points) mean += p / double(points.size());
    const bool positional = light.w != 0.0;
    const glm::dvec3 origin = positional ? glm::dvec3(light) : mean;
    const glm::dvec3 along = glm::normalize(positional ? mean - origin : -glm::dvec3(light));
    const glm::dvec3 u =
        glm::normalize(glm::cross(along, std::abs(along.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0)));
    const glm::dvec3 v = glm::cross(along, u);
    std::vector<glm::dvec2> seen;
    double nearest = glm::dot(points[0] - origin, along);
    for (const glm::dvec3& p : points) {
        const glm::dvec3 d = p - origin;
        const double distance = glm::dot(d, along);
        nearest = std::min(nearest, distance);
        if (positional && distance < 1e-3 * glm::length(d)) return {};
        seen.push_back(glm::dvec2(glm::dot(d, u), glm::dot(d, v)) / (positional ? distance : 1.0));
    }
    const std::vector<glm::dvec2> hull = convexHull(seen);
    std::vector<glm::dvec4> planes;
    const auto add = [&](const glm::dvec3& normal, double offset) {
        planes.push_back(onScreen(Plane(normal, offset - glm::dot(normal, origin)), eye));
    };
    add(along, -nearest);
    for (std::size_t i = 0; i < hull.size(); ++i) {
        const glm::dvec2 a = hull[i], edge = hull[(i + 1) % hull.size()] - a;
        perimeter += glm::length(edge) * (positional ? glm::dot(mean - origin, along) : 1.0);
        const glm::dvec2 inward(-edge.y, edge.x);
        const double offset = -glm::dot(inward, a);
        add(inward.x * u + inward.y * v + (positional ? offset : 0.0) * along, positional ? 0.0 : offset);
    }
    return planes;
}

double expectedUpdates(const PartOutline& part, const ScreenPlane& plane, const Homogeneous& light, const Eye& eye,
                       std::span<const DepthSample> samples) {
    double perimeter = 0.0;
    const std::vector<glm::dvec4> shadow = shadowOnScreen(part.extremes, light, eye, perimeter);
    const std::vector<glm::dvec2> outline = outlineOnScreen(part.extremes, eye);
    double sides = 0.0, caps = 0.0;
    for (const DepthSample& sample : samples) {
        double nearest = 1.0, farthest = 0.0;  // reversed
        for (const glm::dvec4& p : shadow) {
            const double rest = p.x * sample.ndc.x + p.y * sample.ndc.y + p.w;
            if (p.z > 0.0) farthest = std::max(farthest, -rest / p.z);
            if (p.z < 0.0) nearest = std::min(nearest, -rest / p.z);
            if (p.z == 0.0 && rest < 0.0) nearest = 0.0;
        }
        if (!(nearest > farthest)) continue;
        const double here = std::clamp(sample.depth, farthest, nearest);
        const bool passes = plane.passes(sample.ndc, sample.depth);
        sides += (passes ? nearest - here : here - farthest) / (nearest - farthest);
        if (!passes) caps += int(farthest == 0.0) + int(holds(outline, sample.ndc));
    }
    // A ray crosses a convex outline twice, and more often by as much as the edges are longer than that; caps are those
    // of a front and a back.
    return 2.0 * (caps + sides * (perimeter > 0.0 ? std::max(1.0, part.sidesMetres / perimeter) : 1.0));
}

}  // namespace umbrage
