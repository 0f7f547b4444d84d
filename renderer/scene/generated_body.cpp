// SPDX-License-Identifier: Apache-2.0
// The bodies of generated scenes.
#include <cmath>

#include "scene/generated.h"
#include "scene/topology.h"

namespace umbrage {
namespace {

/// From -1 to 1, another for each lattice point. Multiplications by odd numbers and shifts mix the bits.
double latticeValue(const glm::ivec3& at, std::uint32_t seed) {
    std::uint32_t h = seed;
    for (int axis = 0; axis < 3; ++axis) {
        h = (h ^ std::uint32_t(at[axis])) * 0x9e3779b1u;
        h ^= h >> 15u;
    }
    h *= 0x85ebca6bu;
    h ^= h >> 13u;
    return double(h) / 2147483647.5 - 1.0;
}

/// Value noise: lattice values, interpolated with quintic weights.
double noise(const glm::dvec3& at, std::uint32_t seed) {
    const glm::dvec3 base = glm::floor(at), t = at - base;
    const glm::dvec3 weight = t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
    double sum = 0.0;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::ivec3 step(corner & 1, (corner >> 1) & 1, corner >> 2);
        const glm::dvec3 share = glm::mix(1.0 - weight, weight, glm::dvec3(step));
        sum += share.x * share.y * share.z * latticeValue(glm::ivec3(base) + step, seed);
    }
    return sum;
}

/// Octaves from coarse to fine, each half as strong; from -1 to 1.
double roughSurface(const glm::dvec3& direction, std::uint32_t seed) {
    constexpr int kOctaves = 5;
    double sum = 0.0, strength = 0.5, frequency = 2.0;
    for (int octave = 0; octave < kOctaves; ++octave, strength *= 0.5, frequency *= 2.0) {
        sum += strength * noise(direction * frequency, seed + std::uint32_t(octave));
    }
    return sum;
}

/// The octahedron's vertices lie in rings about its upright axis: 4 m in the ring m cuts below its upper tip, down to
/// 4 k at the middle, and as many below it.
class Rings {
public:
    explicit Rings(int k) : k_(k) {
        std::uint32_t next = 0;
        for (int ring = 0; ring <= 2 * k; ++ring) {
            first_.push_back(next);
            next += std::uint32_t(sizeOf(ring));
        }
        vertexCount_ = next;
    }

    std::uint32_t vertexCount() const { return vertexCount_; }
    /// Cuts from the nearer tip.
    int fromTip(int ring) const { return std::min(ring, 2 * k_ - ring); }
    int sizeOf(int ring) const { return std::max(1, 4 * fromTip(ring)); }
    std::uint32_t vertex(int ring, int quarter, int step) const {
        return first_[std::size_t(ring)] + std::uint32_t((quarter * fromTip(ring) + step) % sizeOf(ring));
    }
    /// Before it is pushed onto the sphere.
    glm::dvec3 corner(int ring, int index) const {
        const int m = fromTip(ring);
        const double height = k_ - ring;
        if (m == 0) return {0.0, height, 0.0};
        const double along = index % m, rest = m - along;
        const glm::dvec3 quarters[] = {
            {rest, height, along}, {-along, height, rest}, {-rest, height, -along}, {along, height, -rest}};
        return quarters[index / m];
    }

private:
    int k_;
    std::vector<std::uint32_t> first_;
    std::uint32_t vertexCount_ = 0;
};

/// Between each ring and the next one, a quarter at a time.
std::vector<std::uint32_t> trianglesOf(const Rings& rings, int k) {
    std::vector<std::uint32_t> indices;
    indices.reserve(std::size_t(24) * std::size_t(k) * std::size_t(k));
    for (int gap = 0; gap < 2 * k; ++gap) {
        const bool upper = gap < k;
        const int narrow = upper ? gap : gap + 1, wide = upper ? gap + 1 : gap;
        const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
            indices.insert(indices.end(), {a, upper ? b : c, upper ? c : b});
        };
        const int m = rings.fromTip(narrow);
        for (int quarter = 0; quarter < 4; ++quarter) {
            for (int i = 0; i <= m; ++i) {
                add(rings.vertex(narrow, quarter, i), rings.vertex(wide, quarter, i + 1),
                    rings.vertex(wide, quarter, i));
                if (i == m) continue;
                add(rings.vertex(narrow, quarter, i), rings.vertex(narrow, quarter, i + 1),
                    rings.vertex(wide, quarter, i + 1));
            }
        }
    }
    return indices;
}

}  // namespace

Mesh noisyBody(int k, const glm::dvec3& extents, double roughness, std::uint32_t seed) {
    const Rings rings(k);
    Mesh mesh;
    mesh.positions.reserve(rings.vertexCount());
    for (int ring = 0; ring <= 2 * k; ++ring) {
        for (int i = 0; i < rings.sizeOf(ring); ++i) {
            const glm::dvec3 direction = glm::normalize(rings.corner(ring, i));
            const double radius = roughness > 0.0 ? 1.0 + roughness * roughSurface(direction, seed) : 1.0;
            mesh.positions.emplace_back(direction * radius * extents + 0.0);  // never -0
        }
    }
    mesh.indices = trianglesOf(rings, k);
    Primitive& all = mesh.primitives.emplace_back();
    all.indexCount = std::uint32_t(mesh.indices.size());
    all.vertexCount = std::uint32_t(mesh.positions.size());
    mesh.normals = normalsOf(mesh);
    all.hasNormals = true;
    return mesh;
}

}  // namespace umbrage
