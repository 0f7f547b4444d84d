// SPDX-License-Identifier: Apache-2.0
#include "geometry.h"

#include <array>
#include <map>

namespace generator {
namespace {

using Key = std::array<double, 3>;
Key keyOf(const dvec3& p) {
    return {p.x + 0.0, p.y + 0.0, p.z + 0.0};
}  // -0 becomes +0

/// Twice the area times the unit normal.
dvec3 areaNormal(const std::vector<dvec3>& corners, std::size_t first) {
    return glm::cross(corners[first + 1] - corners[first], corners[first + 2] - corners[first]);
}

/// A normal per corner: the mean, by area, of the faces there that meet at less than the crease angle.
std::vector<dvec3> cornerNormals(const std::vector<dvec3>& corners, double creaseDegrees) {
    std::map<Key, std::vector<std::size_t>> facesAt;
    for (std::size_t i = 0; i < corners.size(); ++i) facesAt[keyOf(corners[i])].push_back(i / 3 * 3);
    const double limit = cosDegrees(creaseDegrees) - 1e-6;
    std::vector<dvec3> normals(corners.size());
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const dvec3 own = glm::normalize(areaNormal(corners, i / 3 * 3));
        dvec3 sum{0};
        for (const std::size_t face : facesAt[keyOf(corners[i])]) {
            const dvec3 normal = areaNormal(corners, face);
            if (glm::dot(glm::normalize(normal), own) >= limit) sum += normal;
        }
        normals[i] = glm::normalize(sum);
    }
    return normals;
}

/// Rounded, so that two corners of one smooth point agree in spite of the order of additions.
dvec3 rounded(const dvec3& v, double grid) {
    return glm::round(v * grid) / grid + 0.0;
}

void addTangents(Geometry& g) {
    std::vector<dvec3> along(g.positions.size(), dvec3{0}), up = along;
    for (std::size_t i = 0; i < g.indices.size(); i += 3) {
        const std::uint32_t* t = &g.indices[i];
        const dvec3 p1 = dvec3(g.positions[t[1]]) - dvec3(g.positions[t[0]]);
        const dvec3 p2 = dvec3(g.positions[t[2]]) - dvec3(g.positions[t[0]]);
        const dvec2 w1 = dvec2(g.texCoords[t[1]]) - dvec2(g.texCoords[t[0]]);
        const dvec2 w2 = dvec2(g.texCoords[t[2]]) - dvec2(g.texCoords[t[0]]);
        const double area = w1.x * w2.y - w2.x * w1.y;
        if (area == 0) continue;
        for (int k = 0; k < 3; ++k) {
            along[t[k]] += (p1 * w2.y - p2 * w1.y) / area;
            up[t[k]] -= (p2 * w1.x - p1 * w2.x) / area;  // v goes down the image
        }
    }
    for (std::size_t i = 0; i < along.size(); ++i) {
        const dvec3 n = g.normals[i];
        dvec3 t = along[i] - n * glm::dot(n, along[i]);
        if (glm::dot(t, t) < 1e-20) t = glm::cross(n, std::abs(n.x) < 0.7 ? dvec3(1, 0, 0) : dvec3(0, 1, 0));
        const double side = glm::dot(glm::cross(n, t), up[i]) < 0 ? -1 : 1;
        g.tangents.emplace_back(glm::vec3(glm::normalize(t)), side);
    }
}

}  // namespace

Geometry geometryOf(const Shape& shape, const GeometryOptions& options) {
    std::vector<dvec3> positions;
    for (const Corner& corner : shape.corners()) positions.push_back(corner.position);
    const std::vector<dvec3> normals = cornerNormals(positions, options.creaseDegrees);

    std::vector<std::vector<dvec3>> targetPositions, targetNormals;
    for (const auto& target : options.targets) {
        std::vector<dvec3> moved;
        for (const dvec3& p : positions) moved.push_back(snap(target(p)));
        targetNormals.push_back(cornerNormals(moved, options.creaseDegrees));
        targetPositions.push_back(std::move(moved));
    }

    Geometry g;
    g.targets.resize(options.targets.size());
    std::map<std::array<double, 10>, std::uint32_t> vertices;
    for (std::size_t i = 0; i < positions.size(); ++i) {
        const Corner& corner = shape.corners()[i];
        const dvec3 normal = rounded(normals[i], 65536);
        const dvec2 uv = options.texCoords ? dvec2(rounded({corner.uv, 0}, 65536)) : dvec2(0);
        const Influence& f = corner.influence;
        const std::array<double, 10> key{corner.position.x + 0.0,
                                         corner.position.y + 0.0,
                                         corner.position.z + 0.0,
                                         normal.x,
                                         normal.y,
                                         normal.z,
                                         uv.x,
                                         uv.y,
                                         options.joints ? f.first * 256.0 + f.second : 0.0,
                                         options.joints ? f.secondWeight : 0.0};
        const auto [place, isNew] = vertices.try_emplace(key, static_cast<std::uint32_t>(g.positions.size()));
        g.indices.push_back(place->second);
        if (!isNew) continue;
        g.positions.emplace_back(corner.position + 0.0);
        g.normals.emplace_back(glm::normalize(normal));
        if (options.texCoords) g.texCoords.emplace_back(uv);
        if (options.joints) {
            const bool two = f.secondWeight > 0 && f.first != f.second;
            g.joints.emplace_back(f.first, two ? f.second : 0, 0, 0);
            g.weights.emplace_back(two ? 1 - f.secondWeight : 1, two ? f.secondWeight : 0, 0, 0);
        }
        for (std::size_t t = 0; t < g.targets.size(); ++t) {
            g.targets[t].positions.emplace_back(targetPositions[t][i] - corner.position + 0.0);
            g.targets[t].normals.emplace_back(rounded(targetNormals[t][i], 65536) - normal);
        }
    }
    if (options.tangents) addTangents(g);
    return g;
}

}  // namespace generator
