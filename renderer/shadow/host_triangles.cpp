// SPDX-License-Identifier: Apache-2.0
#include "shadow/host_triangles.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace umbrage {
namespace {

// The compiler makes SIMD of these loops, for several instruction sets; no sum depends on their width.
#define EVERY_WIDTH __attribute__((target_clones("avx512f", "avx2", "default")))

struct Arrays {
    const float *nx, *ny, *nz, *ax, *ay, *az;
    const std::uint32_t* even;
};

EVERY_WIDTH void faceAll(const Arrays& t, std::uint32_t count, float lx, float ly, float lz, float lw,
                         std::uint32_t bit, std::uint32_t* __restrict front, std::uint32_t* __restrict back) {
    for (std::uint32_t k = 0; k < count; ++k) {
        const float dx = lx - lw * t.ax[k], dy = ly - lw * t.ay[k], dz = lz - lw * t.az[k];
        const float side = t.nx[k] * dx + t.ny[k] * dy + t.nz[k] * dz;
        const std::uint32_t isFront = side > 0.0f ? ~0u : 0u, isBack = side < 0.0f ? ~0u : t.even[k];
        front[k] |= isFront & bit;
        back[k] |= isBack & ~isFront & bit;
    }
}

EVERY_WIDTH void planesOf(const Arrays& t, std::uint32_t count, const gpu::InstanceData& instance,
                          gpu::vec4* __restrict out) {
    const glm::vec4* n = instance.normalFromModel;
    const glm::vec4* v = instance.viewFromModel;
    for (std::uint32_t k = 0; k < count; ++k) {
        const float x = n[0].x * t.nx[k] + n[0].y * t.ny[k] + n[0].z * t.nz[k];
        const float y = n[1].x * t.nx[k] + n[1].y * t.ny[k] + n[1].z * t.nz[k];
        const float z = n[2].x * t.nx[k] + n[2].y * t.ny[k] + n[2].z * t.nz[k];
        const float px = v[0].x * t.ax[k] + v[0].y * t.ay[k] + v[0].z * t.az[k] + v[0].w;
        const float py = v[1].x * t.ax[k] + v[1].y * t.ay[k] + v[1].z * t.az[k] + v[1].w;
        const float pz = v[2].x * t.ax[k] + v[2].y * t.ay[k] + v[2].z * t.az[k] + v[2].w;
        const float length = std::sqrt(x * x + y * y + z * z), scale = length > 1e-37f ? length : 1e-37f;
        const float ux = x / scale, uy = y / scale, uz = z / scale;
        out[k] = {ux, uy, uz, -(ux * px + uy * py + uz * pz)};
    }
}

}  // namespace

void HostTriangles::update(const Geometry& geometry) {
    const bool first = first_.empty();
    if (first || geometry.deforms()) positions_ = geometry.readPositions();
    if (first) {
        std::map<std::pair<std::uint32_t, std::uint32_t>, First> known;  // by vertices and triangles
        std::size_t triangles = 0;
        std::vector<std::uint32_t> made;
        for (std::uint32_t i = 0; i < geometry.instanceCount(); ++i) {
            const gpu::InstanceData& instance = geometry.instances()[i];
            const auto [at, isNew] =
                known.insert({{instance.vertexBase, instance.triangleBase}, {triangles, known.size()}});
            first_.push_back(at->second);
            if (geometry.hasOwnVertices(i)) own_.push_back(i);
            if (!isNew) continue;
            made.push_back(i);
            triangles += instance.triangleCount;
        }
        for (std::vector<float>* values : {&nx_, &ny_, &nz_, &ax_, &ay_, &az_}) values->resize(triangles);
        even_.resize(triangles);
        boxes_.resize(known.size());
        for (const std::uint32_t i : made) set(geometry, i);
    } else {
        for (const std::uint32_t i : own_) set(geometry, i);
    }
}

void HostTriangles::set(const Geometry& geometry, std::uint32_t i) {
    const gpu::InstanceData& instance = geometry.instances()[i];
    const std::size_t base = first_[i].triangle;
    tbb::parallel_for(tbb::blocked_range<std::uint32_t>(0, instance.triangleCount, 1024), [&](const auto& range) {
        for (std::uint32_t t = range.begin(); t != range.end(); ++t) {
            const auto [a, b, c] = corners(geometry, i, t);
            const glm::vec3 u = b - a, v = c - a;
            nx_[base + t] = u.y * v.z - u.z * v.y;
            ny_[base + t] = u.z * v.x - u.x * v.z;
            nz_[base + t] = u.x * v.y - u.y * v.x;
            ax_[base + t] = a.x, ay_[base + t] = a.y, az_[base + t] = a.z;
            even_[base + t] = (geometry.triangleFlags()[instance.triangleBase + t] & TRIANGLE_EVEN) != 0 ? ~0u : 0u;
        }
    });
    Geometry::Bounds box{glm::dvec3(HUGE_VAL), glm::dvec3(-HUGE_VAL)};
    for (std::uint32_t v = 0; v < geometry.vertexCountOf(i); ++v) {
        const glm::dvec3 p = position(instance.vertexBase + v);
        box.low = glm::min(box.low, p);
        box.high = glm::max(box.high, p);
    }
    boxes_[first_[i].box] = box;
}

glm::vec3 HostTriangles::normal(std::uint32_t instance, std::uint32_t triangle) const {
    const std::size_t at = first_[instance].triangle + triangle;
    return {nx_[at], ny_[at], nz_[at]};
}

std::array<glm::vec3, 3> HostTriangles::corners(const Geometry& geometry, std::uint32_t i,
                                                std::uint32_t triangle) const {
    const gpu::InstanceData& instance = geometry.instances()[i];
    const std::uint32_t* index = &geometry.indices()[3 * std::size_t(instance.triangleBase + triangle)];
    return {position(instance.vertexBase + index[0]), position(instance.vertexBase + index[1]),
            position(instance.vertexBase + index[2])};
}

void HostTriangles::face(std::uint32_t instance, std::uint32_t first, std::uint32_t count, const glm::vec4& light,
                         std::uint32_t bit, std::uint32_t* front, std::uint32_t* back) const {
    const std::size_t at = first_[instance].triangle + first;
    const Arrays arrays{&nx_[at], &ny_[at], &nz_[at], &ax_[at], &ay_[at], &az_[at], &even_[at]};
    faceAll(arrays, count, light.x, light.y, light.z, light.w, bit, front, back);
}

void HostTriangles::planes(const gpu::InstanceData& instance, std::uint32_t i, std::uint32_t first, std::uint32_t count,
                           gpu::vec4* out) const {
    const std::size_t at = first_[i].triangle + first;
    planesOf({&nx_[at], &ny_[at], &nz_[at], &ax_[at], &ay_[at], &az_[at], nullptr}, count, instance, out);
}

}  // namespace umbrage
