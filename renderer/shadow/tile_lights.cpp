// SPDX-License-Identifier: Apache-2.0
#include "shadow/tile_lights.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>

#include "shadow/host_predicates.h"

namespace umbrage {
namespace {

template <class T>
void readFirst(const gpu::Buffer& buffer, std::size_t first, std::size_t count, std::vector<T>& to) {
    to.resize(count);
    buffer.read(first * sizeof(T), count * sizeof(T), to.data());
}

/// Concatenates what threads have made: sums have no order.
template <class T>
void takeAll(tbb::enumerable_thread_specific<std::vector<T>>& made, std::vector<T>& to) {
    for (const std::vector<T>& some : made) to.insert(to.end(), some.begin(), some.end());
}

/// An instance's model space, seen from the eye.
class InView {
public:
    explicit InView(const gpu::InstanceData& instance) : mirrored_((instance.flags & INSTANCE_MIRRORED) != 0) {
        for (std::size_t r = 0; r < 3; ++r) rows_[r] = glm::dvec4(instance.viewFromModel[r]);
    }
    glm::dvec4 of(const glm::dvec4& p) const {
        return {glm::dot(rows_[0], p), glm::dot(rows_[1], p), glm::dot(rows_[2], p), p.w};
    }
    glm::dvec3 of(const glm::vec3& p) const { return glm::dvec3(of(glm::dvec4(p, 1.0))); }
    bool mirrored() const { return mirrored_; }

private:
    std::array<glm::dvec4, 3> rows_;
    bool mirrored_;
};

std::optional<TilePolygon> sideOf(std::uint32_t entry, int crossings, std::uint32_t light, const TileScene& scene) {
    const auto& [geometry, silhouettes, group, eye] = scene;
    const std::uint32_t placed = (entry & ~QUAD_OF_RIGHT) >> 1;
    const std::uint32_t i = geometry.edgeChunks()[placed >> CHUNK_SHIFT];
    const gpu::InstanceData& instance = geometry.instances()[i];
    const gpu::Edge& edge = geometry.edges()[instance.edgeBase + placed - instance.placedEdgeBase];
    const InView view(instance);
    const bool reversed = ((entry & 1u) != 0) != view.mirrored();
    const glm::vec4 place = silhouettes.hostLightsInModel[std::size_t(i) * silhouettes.totalLights + light];
    const glm::vec3 a = silhouettes.hostTriangles.position(instance.vertexBase + edge.a);
    const glm::vec3 b = silhouettes.hostTriangles.position(instance.vertexBase + edge.b);
    int inside = 0;
    if (eye.perspective || place.w != 0.0f) {
        inside = sideOfEnd(instance.eyeInModel, place, a, b);
        if (view.mirrored()) inside = -inside;
        if (!eye.perspective) inside = -inside;
    }
    return tileSide(eye, view.of(a), view.of(b), view.of(glm::dvec4(place)), reversed ? -crossings : crossings, inside);
}

/// The pixels and the depth that a triangle may have.
bool mayBeNearest(const std::array<glm::dvec3, 3>& corners, const TileScene& scene, const SeenTiles& seen) {
    const TileEye& eye = scene.eye;
    glm::dvec2 low(HUGE_VAL), high(-HUGE_VAL);
    double nearest = -HUGE_VAL;
    for (const glm::dvec3& p : corners) {
        if (eye.perspective && -p.z < eye.znear) return true;
        const double scale = eye.perspective ? -1.0 / p.z : 1.0;
        nearest = std::max(nearest, eye.perspective ? scale : p.z);
        const glm::dvec2 ndc = glm::dvec2(p) * scale / eye.rayScale;
        const glm::dvec2 pixel(0.5 * (ndc.x + 1.0) * eye.width, 0.5 * (1.0 - ndc.y) * eye.height);
        low = glm::min(low, pixel);
        high = glm::max(high, pixel);
    }
    if (!eye.perspective && nearest > -eye.znear) return true;
    // A pixel more than floats can err.
    return seen.isBefore(low - 1.0, high + 1.0, float(nearest + 1e-5 * std::abs(nearest)));
}

}  // namespace

void TileLights::begin(const Geometry& geometry, const Silhouettes& silhouettes, const LightGroup& group) {
    readFirst(silhouettes.planes, 0, geometry.placedTriangleCount(), planes_);
    readFirst(silhouettes.facing, silhouettes.facingBase(group), geometry.placedTriangleCount(), facing_);
}

void TileLights::findExposed(const TileScene& scene, const SeenTiles& seen, TileCounter& counter) {
    const auto& [geometry, silhouettes, group, eye] = scene;
    const HostTriangles& triangles = silhouettes.hostTriangles;
    tbb::enumerable_thread_specific<Exposed> made;
    tbb::parallel_for(std::uint32_t(0), geometry.triangleChunkCount(), [&](std::uint32_t chunk) {
        const std::uint32_t i = geometry.triangleChunks()[chunk];
        const gpu::InstanceData& instance = geometry.instances()[i];
        const std::uint32_t first = chunk * CHUNK_SIZE - instance.placedTriangleBase;
        const std::uint32_t count = std::min<std::uint32_t>(CHUNK_SIZE, instance.triangleCount - first);
        std::array<std::uint32_t, CHUNK_SIZE> front{}, back{};
        triangles.face(i, first, count, instance.eyeInModel, 1u, front.data(), back.data());
        const bool insideOut = (instance.flags & INSTANCE_INSIDE_OUT) != 0;
        const InView view(instance);
        for (std::uint32_t k = 0; k < count; ++k) {
            const std::uint32_t placed = chunk * CHUNK_SIZE + k;
            const std::uint32_t flags = geometry.triangleFlags()[instance.triangleBase + first + k];
            if ((flags & TRIANGLE_CASTS) == 0 || (facing_[placed].x | facing_[placed].y) == 0) continue;
            const bool turnedAway = (insideOut ? front[k] : back[k]) != 0;
            const bool culled = (flags & TRIANGLE_SINGLE_SIDED) != 0 && turnedAway;
            const auto corners = triangles.corners(geometry, i, first + k);
            const std::array<glm::dvec3, 3> inView{view.of(corners[0]), view.of(corners[1]), view.of(corners[2])};
            const bool cut = std::ranges::any_of(inView, [&](const glm::dvec3& p) { return -p.z < eye.znear; });
            const bool anywhere = culled || (flags & TRIANGLE_HOLED) != 0;
            if (!anywhere && !cut) continue;
            if (!mayBeNearest(inView, scene, seen)) continue;
            const float side = sideOf(triangles.normal(i, first + k), corners[0], instance.eyeInModel);
            if (side == 0.0f) continue;  // as the eye's constant has it
            const int eyeFront = (side > 0.0f) != view.mirrored() ? 1 : -1;
            if (const auto cap = tileCap(eye, inView, view.mirrored() ? -1 : 1, eyeFront,
                                         anywhere ? CapMissing::Anywhere : CapMissing::BeforeTheNear)) {
                made.local().triangles.push_back(placed);
                made.local().caps.push_back(*cap);
            }
        }
    });
    exposed_ = {};
    for (Exposed& some : made) {
        const std::vector<std::uint8_t> touching = counter.touching(seen, some.caps);
        for (std::size_t k = 0; k < touching.size(); ++k) {
            if (touching[k] == 0) continue;
            exposed_.triangles.push_back(some.triangles[k]);
            exposed_.caps.push_back(some.caps[k]);
        }
    }
}

std::span<const std::uint32_t> TileLights::entriesOf(const TileScene& scene, std::uint32_t l, std::uint32_t list,
                                                     std::vector<std::uint32_t>& read) const {
    const Silhouettes& silhouettes = scene.silhouettes;
    readFirst(silhouettes.quads, std::size_t(l * LIST_COUNT + list) * silhouettes.capacity,
              silhouettes.hostSummaries[l].lists[list].count / 6, read);
    return read;
}

TileLight TileLights::light(std::span<const CountPlan> plans, const TileScene& scene, std::uint32_t l) const {
    TileLight light;
    light.bit = 1u << l;
    tbb::enumerable_thread_specific<std::vector<TilePolygon>> made;
    std::vector<std::uint32_t> read;
    for (const CountPlan& plan : plans) {
        light.start += plan.eyeLayers;
        for (const VolumePart& part : plan.parts) {
            if (part.kind != VolumePart::Kind::Sides) continue;
            const std::span<const std::uint32_t> entries = entriesOf(scene, l, part.what, read);
            tbb::parallel_for(tbb::blocked_range<std::size_t>(0, entries.size(), 256), [&](const auto& range) {
                std::vector<TilePolygon>& polygons = made.local();
                for (std::size_t k = range.begin(); k != range.end(); ++k) {
                    const auto side = sideOf(entries[k], plan.crossings, scene.group.first + l, scene);
                    if (side) polygons.push_back(*side);
                }
            });
        }
    }
    takeAll(made, light.polygons);
    for (std::size_t k = 0; k < exposed_.caps.size(); ++k) {
        const glm::uvec2 sides = facing_[exposed_.triangles[k]];
        const int facing = int(sides.x >> l & 1u) - int(sides.y >> l & 1u);
        if (facing == 0) continue;
        light.polygons.push_back(exposed_.caps[k]);
        light.polygons.back().crossing *= facing;
    }
    return light;
}

}  // namespace umbrage
