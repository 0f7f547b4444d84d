// SPDX-License-Identifier: Apache-2.0
#include "shadow/tile_lights.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>

namespace umbrage {
namespace {

using Polygons = std::vector<TilePolygon>;

/// One light as the polygons of its volumes are made from.
class PolygonMaker {
public:
    PolygonMaker(const std::vector<float>& positions, const Geometry& geometry, const Silhouettes& silhouettes,
                 std::uint32_t light, const TileEye& eye)
        : positions_(positions), geometry_(geometry), silhouettes_(silhouettes), light_(light), eye_(eye) {}

    /// @param entry  of a list of side quads
    void addSide(std::uint32_t entry, int crossings, Polygons& to) const {
        const std::uint32_t placed = (entry & ~QUAD_OF_RIGHT) >> 1;
        const std::uint32_t i = geometry_.edgeChunks()[placed >> CHUNK_SHIFT];
        const gpu::InstanceData& instance = geometry_.instances()[i];
        const gpu::Edge& edge = geometry_.edges()[instance.edgeBase + placed - instance.placedEdgeBase];
        const bool reversed = ((entry & 1u) != 0) != isMirrored(instance);
        const glm::vec4 place = silhouettes_.hostLightsInModel[std::size_t(i) * silhouettes_.totalLights + light_];
        add(tileSide(eye_, corner(instance, edge.a), corner(instance, edge.b), toView(instance, place),
                     reversed ? -crossings : crossings),
            to);
    }

    /// @param facing  of the triangle: 1 if its front faces the light, else -1
    void addCap(const gpu::InstanceData& instance, std::uint32_t triangle, int facing, Polygons& to) const {
        const std::uint32_t* index = &geometry_.indices()[3 * std::size_t(instance.triangleBase + triangle)];
        add(tileCap(eye_, {corner(instance, index[0]), corner(instance, index[1]), corner(instance, index[2])},
                    isMirrored(instance) ? -facing : facing),
            to);
    }

private:
    static bool isMirrored(const gpu::InstanceData& instance) { return (instance.flags & INSTANCE_MIRRORED) != 0; }
    static void add(const std::optional<TilePolygon>& polygon, Polygons& to) {
        if (polygon) to.push_back(*polygon);
    }
    static glm::dvec4 toView(const gpu::InstanceData& instance, const glm::dvec4& p) {
        const auto row = [&](int i) { return glm::dot(glm::dvec4(instance.viewFromModel[i]), p); };
        return {row(0), row(1), row(2), p.w};
    }
    glm::dvec3 corner(const gpu::InstanceData& instance, std::uint32_t vertex) const {
        const float* p = &positions_[3 * std::size_t(instance.vertexBase + vertex)];
        return glm::dvec3(toView(instance, {p[0], p[1], p[2], 1.0}));
    }

    const std::vector<float>& positions_;
    const Geometry& geometry_;
    const Silhouettes& silhouettes_;
    std::uint32_t light_;
    const TileEye& eye_;
};

template <class T>
void readFirst(const gpu::Buffer& buffer, std::size_t first, std::size_t count, std::vector<T>& to) {
    to.resize(count);
    buffer.read(first * sizeof(T), count * sizeof(T), to.data());
}

}  // namespace

bool TileLights::takes(const CountPlan& plan) {
    return std::ranges::all_of(plan.parts, [](const VolumePart& part) {
        return part.rule == VolumePart::Rule::Pass && part.start == VolumePart::Start::Eye && !part.inverts &&
               (part.kind == VolumePart::Kind::Sides || part.what == CAP_TRUE || part.what == CAP_EDGE_ON);
    });
}

void TileLights::begin(const Geometry& geometry, const Silhouettes& silhouettes, const LightGroup& group) {
    if (positions_.empty() || geometry.deforms()) positions_ = geometry.readPositions();
    readFirst(silhouettes.planes, 0, geometry.placedTriangleCount(), planes_);
    readFirst(silhouettes.facing, silhouettes.facingBase(group), geometry.placedTriangleCount(), facing_);
}

TileLight TileLights::light(std::span<const CountPlan> plans, const Geometry& geometry, const Silhouettes& silhouettes,
                            const LightGroup& group, std::uint32_t l, const TileEye& eye) const {
    const PolygonMaker maker(positions_, geometry, silhouettes, group.first + l, eye);
    tbb::enumerable_thread_specific<Polygons> made;
    const auto inParallel = [&](std::size_t count, const auto& visit) {
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 256), [&](const auto& range) {
            Polygons& polygons = made.local();
            for (std::size_t k = range.begin(); k != range.end(); ++k) visit(k, polygons);
        });
    };
    TileLight light;
    light.bit = 1u << l;
    std::vector<std::uint32_t> entries;
    for (const CountPlan& plan : plans) {
        light.start += plan.eyeLayers;
        for (const VolumePart& part : plan.parts) {
            if (part.kind == VolumePart::Kind::Sides) {
                readFirst(silhouettes.quads, std::size_t(l * LIST_COUNT + part.what) * silhouettes.capacity,
                          silhouettes.hostSummaries[l].lists[part.what].count / 6, entries);
                inParallel(entries.size(),
                           [&](std::size_t k, Polygons& to) { maker.addSide(entries[k], plan.crossings, to); });
                continue;
            }
            if (part.what == CAP_EDGE_ON) continue;  // here they are caps like others
            for (const std::uint32_t i : part.instances) {
                const gpu::InstanceData& instance = geometry.instances()[i];
                inParallel(instance.triangleCount, [&](std::size_t t, Polygons& to) {
                    if ((geometry.triangleFlags()[instance.triangleBase + t] & TRIANGLE_CASTS) == 0) return;
                    const glm::uvec2 sides = facing_[instance.placedTriangleBase + t];
                    const int facing = int(sides.x >> l & 1u) - int(sides.y >> l & 1u);
                    if (facing != 0) maker.addCap(instance, std::uint32_t(t), facing, to);
                });
            }
        }
    }
    for (const Polygons& polygons : made) {
        light.polygons.insert(light.polygons.end(), polygons.begin(), polygons.end());
    }
    return light;
}

}  // namespace umbrage
