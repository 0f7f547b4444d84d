// SPDX-License-Identifier: Apache-2.0
#include "shapes.h"

#include <algorithm>

namespace generator {

void Shape::triangle(Corner a, Corner b, Corner c) {
    a.position = snap(a.position);
    b.position = snap(b.position);
    c.position = snap(c.position);
    if (a.position == b.position || b.position == c.position || c.position == a.position) return;
    corners_.insert(corners_.end(), {a, b, c});
}

void Shape::quad(const Corner& a, const Corner& b, const Corner& c, const Corner& d) {
    triangle(a, b, c);
    triangle(a, c, d);
}

Shape& Shape::add(const Shape& other) {
    corners_.insert(corners_.end(), other.corners_.begin(), other.corners_.end());
    return *this;
}

Shape Shape::bent(const std::function<dvec3(const dvec3&)>& position) const {
    Shape result = *this;
    for (Corner& corner : result.corners_) corner.position = snap(position(corner.position));
    return result;
}

Shape Shape::moved(const dvec3& by) const {
    return bent([&](const dvec3& p) { return p + by; });
}
Shape Shape::scaled(const dvec3& by) const {
    return bent([&](const dvec3& p) { return p * by; });
}
Shape Shape::rotated(const dquat& by) const {
    return bent([&](const dvec3& p) { return by * p; });
}

Shape Shape::mirrored() const {
    Shape result = scaled({-1, 1, 1});
    for (std::size_t i = 0; i < result.corners_.size(); i += 3)
        std::swap(result.corners_[i + 1], result.corners_[i + 2]);
    return result;
}

Shape Shape::boxMapped(double metresPerRepeat) const {
    Shape result = *this;
    for (std::size_t i = 0; i < result.corners_.size(); i += 3) {
        Corner* t = &result.corners_[i];
        const dvec3 n = glm::cross(t[1].position - t[0].position, t[2].position - t[0].position);
        const dvec3 size = glm::abs(n);
        for (int k = 0; k < 3; ++k) {
            const dvec3 p = t[k].position / metresPerRepeat;
            if (size.y >= size.x && size.y >= size.z)
                t[k].uv = {p.x, n.y > 0 ? p.z : -p.z};
            else if (size.x >= size.z)
                t[k].uv = {n.x > 0 ? -p.z : p.z, -p.y};
            else
                t[k].uv = {n.z > 0 ? p.x : -p.x, -p.y};
        }
    }
    return result;
}

Shape Shape::influencedBy(const std::function<Influence(const dvec3&)>& influence) const {
    Shape result = *this;
    for (Corner& corner : result.corners_) corner.influence = influence(corner.position);
    return result;
}

Shape box(const dvec3& low, const dvec3& high) {
    return plate({{low.x, low.y}, {high.x, low.y}}, {{low.x, high.y}, {high.x, high.y}}, low.z, high.z);
}

Shape bevelledBox(const dvec3& low, const dvec3& high, double bevel) {
    const dvec3 centre = (low + high) / 2.0, half = (high - low) / 2.0;
    // The three points near the corner with signs s, one in each of the faces that meet there.
    const auto point = [&](const std::array<double, 3>& s, int axis) {
        dvec3 p;
        for (int k = 0; k < 3; ++k) p[k] = centre[k] + s[k] * (half[k] - (k == axis ? 0 : bevel));
        return Corner{.position = p};
    };
    Shape result;
    for (int axis = 0; axis < 3; ++axis) {
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        for (const double side : {-1.0, 1.0}) {
            const auto at = [&](double a, double b) {
                std::array<double, 3> s{};
                s[axis] = side, s[u] = a * side, s[v] = b;
                return point(s, axis);
            };
            result.quad(at(-1, -1), at(1, -1), at(1, 1), at(-1, 1));
        }
        // The four bevels along this axis, between the faces of u and v.
        for (const double a : {-1.0, 1.0})
            for (const double b : {-1.0, 1.0}) {
                std::array<double, 3> s{}, t{};
                s[axis] = -a * b, t[axis] = a * b;
                s[u] = t[u] = a, s[v] = t[v] = b;
                result.quad(point(s, u), point(s, v), point(t, v), point(t, u));
            }
    }
    for (const double x : {-1.0, 1.0})
        for (const double y : {-1.0, 1.0})
            for (const double z : {-1.0, 1.0}) {
                const std::array<double, 3> s{x, y, z};
                const bool even = x * y * z > 0;
                result.triangle(point(s, 0), point(s, even ? 1 : 2), point(s, even ? 2 : 1));
            }
    return result;
}

Shape lathe(const std::vector<dvec2>& profile, int segments, double metresPerRepeat) {
    double widest = 0;
    for (const dvec2& p : profile) widest = std::max(widest, p.x);
    const double repeats = std::max(1.0, std::round(2 * kPi * widest / metresPerRepeat));
    const auto at = [&](std::size_t i, int segment, double length) {
        const double degrees = 360.0 * (segment % segments) / segments;
        return Corner{{profile[i].x * sinDegrees(degrees), profile[i].y, profile[i].x * cosDegrees(degrees)},
                      {repeats * segment / segments, -length / metresPerRepeat}};
    };
    Shape result;
    double length = 0;
    for (std::size_t i = 0; i + 1 < profile.size(); ++i) {
        const double next = length + glm::length(profile[i + 1] - profile[i]);
        for (int s = 0; s < segments; ++s)
            result.quad(at(i, s, length), at(i, s + 1, length), at(i + 1, s + 1, next), at(i + 1, s, next));
        length = next;
    }
    return result;
}

std::vector<dvec2> resampled(const std::vector<dvec2>& profile, int points) {
    double total = 0;
    for (std::size_t i = 0; i + 1 < profile.size(); ++i) total += glm::length(profile[i + 1] - profile[i]);
    std::vector<dvec2> result{profile.front()};
    std::size_t segment = 0;
    double before = 0;
    for (int k = 1; k + 1 < points; ++k) {
        const double wanted = total * k / (points - 1);
        double length = glm::length(profile[segment + 1] - profile[segment]);
        while (before + length < wanted) {
            before += length;
            ++segment;
            length = glm::length(profile[segment + 1] - profile[segment]);
        }
        result.push_back(glm::mix(profile[segment], profile[segment + 1], (wanted - before) / length));
    }
    result.push_back(profile.back());
    return result;
}

Shape sphere(double radius, int segments, int rings) {
    std::vector<dvec2> profile;
    for (int i = 0; i <= rings; ++i) {
        const double degrees = 180.0 * i / rings;
        profile.push_back({radius * sinDegrees(degrees), -radius * cosDegrees(degrees)});
    }
    return lathe(profile, segments);
}

Shape tube(const std::vector<Ring>& rings, int segments, Ends ends, double metresPerRepeat) {
    const auto at = [&](std::size_t i, int segment, double length) {
        const Ring& ring = rings[i % rings.size()];
        const double degrees = 360.0 * (segment % segments) / segments;
        return Corner{ring.centre + ring.x * cosDegrees(degrees) + ring.y * sinDegrees(degrees),
                      {static_cast<double>(segment) / segments, -length / metresPerRepeat}};
    };
    Shape result;
    double length = 0;
    const std::size_t spans = rings.size() - (ends == Ends::Joined ? 0 : 1);
    for (std::size_t i = 0; i < spans; ++i) {
        const double next = length + glm::length(rings[(i + 1) % rings.size()].centre - rings[i].centre);
        for (int s = 0; s < segments; ++s)
            result.quad(at(i, s, length), at(i, s + 1, length), at(i + 1, s + 1, next), at(i + 1, s, next));
        length = next;
    }
    if (ends == Ends::Closed)
        for (int s = 1; s + 1 < segments; ++s) {
            result.triangle(at(0, 0, 0), at(0, s + 1, 0), at(0, s, 0));
            result.triangle(at(spans, 0, length), at(spans, s, length), at(spans, s + 1, length));
        }
    return result;
}

std::vector<Ring> ringsAlong(const std::vector<dvec3>& path, const std::vector<double>& radii) {
    const std::size_t count = path.size();
    std::vector<Ring> rings(count);
    dvec3 x{0};
    for (std::size_t i = 0; i < count; ++i) {
        const dvec3 along = glm::normalize(path[std::min(i + 1, count - 1)] - path[i > 0 ? i - 1 : 0]);
        if (i == 0) x = std::abs(along.y) > 0.9 ? dvec3(1, 0, 0) : glm::cross(dvec3(0, 1, 0), along);
        x = glm::normalize(x - along * glm::dot(x, along));
        rings[i] = {path[i], x * radii[i], glm::cross(along, x) * radii[i]};
    }
    return rings;
}

std::vector<dvec3> splineThrough(const std::vector<dvec3>& control, int points) {
    std::vector<dvec3> result;
    const int spans = static_cast<int>(control.size()) - 1;
    for (int k = 0; k < points; ++k) {
        const double at = static_cast<double>(k) * spans / (points - 1);
        const int i = std::min(static_cast<int>(at), spans - 1);
        const double t = at - i;
        const dvec3 b = control[i], c = control[i + 1];
        const dvec3 a = i > 0 ? control[i - 1] : b * 2.0 - c, d = i + 2 <= spans ? control[i + 2] : c * 2.0 - b;
        result.push_back((2.0 * b + (c - a) * t + (2.0 * a - 5.0 * b + 4.0 * c - d) * t * t +
                          (3.0 * b - a - 3.0 * c + d) * t * t * t) /
                         2.0);
    }
    return result;
}

Shape torus(const dvec2& radii, double thick, double high, int around, int sides) {
    std::vector<Ring> rings;
    for (int i = 0; i < around; ++i) {
        const dvec3 out{cosDegrees(360.0 * i / around), 0, sinDegrees(360.0 * i / around)};
        rings.push_back({out * dvec3(radii.x, 0, radii.y), out * thick, dvec3(0, high, 0)});
    }
    return tube(rings, sides, Ends::Joined);
}

Shape bar(const dvec3& from, const dvec3& to, double radius, int segments) {
    return tube(ringsAlong({from, to}, {radius, radius}), segments);
}

Shape plate(const std::vector<dvec2>& lower, const std::vector<dvec2>& upper, double back, double front) {
    const auto at = [](const dvec2& p, double z) { return Corner{.position = {p, z}}; };
    Shape result;
    for (std::size_t i = 0; i + 1 < lower.size(); ++i) {
        result.quad(at(lower[i], front), at(lower[i + 1], front), at(upper[i + 1], front), at(upper[i], front));
        result.quad(at(lower[i + 1], back), at(lower[i], back), at(upper[i], back), at(upper[i + 1], back));
        result.quad(at(upper[i], front), at(upper[i + 1], front), at(upper[i + 1], back), at(upper[i], back));
        result.quad(at(lower[i], back), at(lower[i + 1], back), at(lower[i + 1], front), at(lower[i], front));
    }
    result.quad(at(lower.front(), back), at(lower.front(), front), at(upper.front(), front), at(upper.front(), back));
    result.quad(at(lower.back(), front), at(lower.back(), back), at(upper.back(), back), at(upper.back(), front));
    return result;
}

Shape sheet(int columns, int rows, const std::function<dvec3(double, double)>& at, const dvec2& uvRepeats) {
    const auto corner = [&](int column, int row) {
        const double u = static_cast<double>(column) / columns, v = static_cast<double>(row) / rows;
        return Corner{.position = at(u, v), .uv = dvec2(u, v) * uvRepeats};
    };
    Shape result;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column)
            result.quad(corner(column, row + 1), corner(column + 1, row + 1), corner(column + 1, row),
                        corner(column, row));
    return result;
}

Shape icosphere(int levels) {
    const double golden = (1 + std::sqrt(5.0)) / 2;
    const std::array<dvec3, 12> points{{{-1, golden, 0},
                                        {1, golden, 0},
                                        {-1, -golden, 0},
                                        {1, -golden, 0},
                                        {0, -1, golden},
                                        {0, 1, golden},
                                        {0, -1, -golden},
                                        {0, 1, -golden},
                                        {golden, 0, -1},
                                        {golden, 0, 1},
                                        {-golden, 0, -1},
                                        {-golden, 0, 1}}};
    const std::array<std::array<int, 3>, 20> faces{{{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                                                    {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                                                    {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                                                    {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}}};
    std::vector<dvec3> triangles;
    for (const auto& face : faces)
        for (const int index : face) triangles.push_back(glm::normalize(points[index]));
    for (int level = 0; level < levels; ++level) {
        std::vector<dvec3> finer;
        for (std::size_t i = 0; i < triangles.size(); i += 3) {
            const dvec3 a = triangles[i], b = triangles[i + 1], c = triangles[i + 2];
            const dvec3 ab = glm::normalize(a + b), bc = glm::normalize(b + c), ca = glm::normalize(c + a);
            finer.insert(finer.end(), {a, ab, ca, ab, b, bc, ca, bc, c, ab, bc, ca});
        }
        triangles = std::move(finer);
    }
    Shape result;
    for (std::size_t i = 0; i < triangles.size(); i += 3)
        result.triangle({.position = triangles[i]}, {.position = triangles[i + 1]}, {.position = triangles[i + 2]});
    return result;
}

}  // namespace generator
