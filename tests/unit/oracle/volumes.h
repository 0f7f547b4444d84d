// SPDX-License-Identifier: Apache-2.0
// Shadow volumes as chains of polygons, exactly: what the renderer draws, without rasterising anything. The volume of a
// triangle is what lies behind it, seen from the light; its boundary is the triangle itself (light cap), a quad from
// each edge away from the light, and the triangle's image at infinity (dark cap). A triangle counts with a whole
// number, its weight, in the direction it is wound; quads come from the scene's topology, with multiplicities.
#pragma once

#include <optional>
#include <vector>

#include "oracle/formulas.h"
#include "scene/topology.h"

namespace umbrage::oracle {

using Direction = Vector<Exact>;

/// A vertex: a place, or a point at infinity.
struct Corner {
    Direction v;
    bool finite;

    Direction from(const glm::dvec3& p) const { return finite ? v - vectorOf<Exact>(p) : v; }
};

/// Convex.
struct Polygon {
    std::vector<Corner> corners;
    int times;
};

/// 1: p is behind the polygon's plane, -1: in front, 0: in it. At infinity: whether it runs counter-clockwise seen from
/// outside of the sky.
inline int behind(const glm::dvec3& p, const Polygon& polygon) {
    return dot(polygon.corners[0].from(p), cross(polygon.corners[1].from(p), polygon.corners[2].from(p))).sign();
}

/// 1, -1: the whole line through p, before and behind it, passes the polygon along or against its normal; 0: not at
/// all. Lines that meet an edge pass as if their direction were moved by an infinitesimal (e, e^2, e^3).
inline int passes(const glm::dvec3& p, const Direction& way, const Polygon& polygon) {
    int direction = 0;
    for (std::size_t i = 0; i < polygon.corners.size(); ++i) {
        const Corner &a = polygon.corners[i], &b = polygon.corners[(i + 1) % polygon.corners.size()];
        const Direction n = cross(a.from(p), b.from(p));
        int side = dot(way, n).sign();
        for (const Exact* component : {&n.x, &n.y, &n.z}) {
            if (side == 0) side = component->sign();
        }
        if (side == 0 || (direction != 0 && side != direction)) return 0;
        direction = side;
    }
    return direction;
}

class Volumes {
public:
    Volumes(const Mesh& mesh, const glm::dvec4& light)
        : mesh_(mesh), topology_(buildTopology(mesh, {})), light_(light) {
        facing_.resize(mesh.triangleCount());
        for (std::uint32_t t = 0; t < mesh.triangleCount(); ++t) {
            if (topology_.casts[t]) facing_[t] = oracle::facing<Exact>(corners(t), light).sign();
        }
        setWeights(facing_);
    }

    /// Per triangle. At first they are facing(): two-sided counting.
    void setWeights(const std::vector<int>& weights) {
        caps_.clear();
        darkCaps_.clear();
        sides_.clear();
        for (std::uint32_t t = 0; t < weights.size(); ++t) {
            if (!topology_.casts[t] || weights[t] == 0) continue;
            const Corners c = corners(t);
            caps_.push_back({{near(c[0]), near(c[1]), near(c[2])}, weights[t]});
            darkCaps_.push_back({{far(c[2]), far(c[1]), far(c[0])}, weights[t]});
        }
        for (const MeshEdge& edge : topology_.edges) {
            int times = edge.leftReversed ? -weights[edge.left] : weights[edge.left];
            if (edge.right != MeshEdge::kNoTriangle) {
                times += edge.rightReversed ? -weights[edge.right] : weights[edge.right];
            }
            if (times == 0) continue;
            // A triangle that runs from a to b borders on a side that runs from b to a.
            const glm::dvec3 a = place(edge.a), b = place(edge.b);
            sides_.push_back({{near(b), near(a), far(a)}, times});
            if (light_.w != 0.0) sides_.back().corners.push_back(far(b));  // else both ends are the same point
        }
    }

    /// The sum of the weights of volumes p is in; nothing, where p is on the boundary of one.
    std::optional<int> count(const glm::dvec3& p) const {
        const Direction l = vectorOf<Exact>(glm::dvec3(light_)), way = light_.w != 0.0 ? l - vectorOf<Exact>(p) : l;
        int sum = 0;
        for (const Polygon& cap : caps_) {
            const std::array<Corner, 4> c{cap.corners[0], cap.corners[1], cap.corners[2], cap.corners[0]};
            for (std::size_t i = 0; i < 3; ++i) {
                if (dot(way, cross(c[i].from(p), c[i + 1].from(p))).sign() == 0) return {};
            }
            const int side = behind(p, cap), lightSide = facingOf(cap);
            if (side == 0) return {};
            if (side == lightSide && passes(p, way, cap) == lightSide) sum += lightSide * cap.times;
        }
        return sum;
    }

    enum class Part { Before, Beyond, Everywhere };

    /// Volumes entered through these polygons less volumes left, on the line from `eye` to `end`: between them, beyond
    /// `end`, or along the whole line.
    static int entered(const std::vector<Polygon>& polygons, const glm::dvec3& eye, const glm::dvec3& end, Part part) {
        const Direction way = vectorOf<Exact>(end) - vectorOf<Exact>(eye);
        int sum = 0;
        for (const Polygon& polygon : polygons) {
            const int direction = passes(eye, way, polygon);
            if (direction == 0) continue;
            const bool ahead = behind(eye, polygon) == direction, beyond = behind(end, polygon) == direction;
            if (part == Part::Before && (!ahead || beyond)) continue;
            if (part == Part::Beyond && !beyond) continue;
            sum -= direction * polygon.times;
        }
        return sum;
    }

    const std::vector<Polygon>& sides() const { return sides_; }
    const std::vector<Polygon>& caps() const { return caps_; }
    const std::vector<Polygon>& darkCaps() const { return darkCaps_; }
    /// Per triangle: 1: the light is in front of it, -1: behind, 0: in its plane, or it does not cast.
    const std::vector<int>& facing() const { return facing_; }

    Corners corners(std::uint32_t t) const {
        return {place(mesh_.indices[3 * t]), place(mesh_.indices[3 * t + 1]), place(mesh_.indices[3 * t + 2])};
    }

private:
    glm::dvec3 place(std::uint32_t v) const { return glm::dvec3(mesh_.positions[v]); }
    static Corner near(const glm::dvec3& p) { return {vectorOf<Exact>(p), true}; }
    Corner far(const glm::dvec3& p) const {
        const Direction l = vectorOf<Exact>(glm::dvec3(light_));
        return {(light_.w != 0.0 ? vectorOf<Exact>(p) : vectorOf<Exact>(glm::dvec3(0.0))) - l, false};
    }
    int facingOf(const Polygon& cap) const {
        const Direction a = cap.corners[0].v, l = vectorOf<Exact>(glm::dvec3(light_));
        const Direction n = cross(cap.corners[1].v - a, cap.corners[2].v - a);
        return dot(n, light_.w != 0.0 ? l - a : l).sign();
    }

    const Mesh& mesh_;
    MeshTopology topology_;
    glm::dvec4 light_;
    std::vector<int> facing_;
    std::vector<Polygon> caps_, darkCaps_, sides_;
};

}  // namespace umbrage::oracle
