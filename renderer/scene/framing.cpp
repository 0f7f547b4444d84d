// SPDX-License-Identifier: Apache-2.0
#include "scene/framing.h"

#include <algorithm>
#include <limits>

namespace umbrage {
namespace {

using Points = std::vector<glm::dvec2>;

double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// The convex hull's corners (Andrew's monotone chains).
Points hullOf(Points points) {
    std::sort(points.begin(), points.end(),
              [](const glm::dvec2& a, const glm::dvec2& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
    points.erase(std::unique(points.begin(), points.end()), points.end());
    if (points.size() < 3) return points;
    Points hull;
    for (int chain = 0; chain < 2; ++chain) {
        const std::size_t begin = hull.size();
        for (const glm::dvec2& point : points) {
            while (hull.size() >= begin + 2 && turn(hull[hull.size() - 2], hull.back(), point) <= 0.0) hull.pop_back();
            hull.push_back(point);
        }
        hull.pop_back();  // the other chain begins with it
        std::reverse(points.begin(), points.end());
    }
    return hull;
}

/// How far off the eye must be at least for an axis's points to fit.
double distanceFor(const Points& points, double halfExtent) {
    constexpr double kLeast = std::numeric_limits<double>::lowest();
    double positive = kLeast, negative = kLeast;
    for (const glm::dvec2& point : points) {
        positive = std::max(positive, halfExtent * point.y + point.x);
        negative = std::max(negative, halfExtent * point.y - point.x);
    }
    return (positive + negative) / (2.0 * halfExtent);
}

/// Where the eye must be along the axis for the picture to have equal room on both sides.
double middleFor(const Points& points, double eyeZ) {
    double low = points.front().x, high = low;
    for (const glm::dvec2& point : points) {
        low = std::min(low, point.x);
        high = std::max(high, point.x);
    }
    for (int step = 0; step < 60; ++step) {
        const double middle = 0.5 * (low + high);
        double least = 0.0, most = 0.0;
        for (const glm::dvec2& point : points) {
            const double projected = (point.x - middle) / (eyeZ - point.y);
            least = std::min(least, projected);
            most = std::max(most, projected);
        }
        (most + least > 0.0 ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

}  // namespace

void Framing::add(const glm::dvec3& point) {
    for (int axis = 0; axis < 2; ++axis) {
        Points& outline = outlines_[static_cast<std::size_t>(axis)];
        outline.emplace_back(point[axis], point.z);
        std::size_t& reduceAt = reduceAt_[static_cast<std::size_t>(axis)];
        if (outline.size() < reduceAt) continue;
        outline = hullOf(std::move(outline));
        reduceAt = std::max<std::size_t>(1024, 2 * outline.size());
    }
}

Framing::Eye Framing::eye(const glm::dvec2& halfExtents) const {
    if (outlines_[0].empty()) return {{0.0, 0.0, 1.0}, 1.0};
    glm::dvec3 low(std::numeric_limits<double>::infinity()), high(-low);
    for (int axis = 0; axis < 2; ++axis) {
        for (const glm::dvec2& point : outlines_[static_cast<std::size_t>(axis)]) {
            low[axis] = std::min(low[axis], point.x);
            high[axis] = std::max(high[axis], point.x);
            low.z = std::min(low.z, point.y);
            high.z = std::max(high.z, point.y);
        }
    }
    const double size = glm::length(high - low) > 0.0 ? glm::length(high - low) : 1.0;
    const Points x = hullOf(outlines_[0]), y = hullOf(outlines_[1]);
    constexpr double kClosest = 0.1;  // of the size: also a line along the view is looked at from outside
    const double z = std::max({distanceFor(x, halfExtents.x), distanceFor(y, halfExtents.y), high.z + kClosest * size});
    return {{middleFor(x, z), middleFor(y, z), z}, z - high.z};
}

}  // namespace umbrage
