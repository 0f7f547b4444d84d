// SPDX-License-Identifier: Apache-2.0
#include "shadow/tile_lights.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>

#include "shadow/bounds.h"
#include "tiles/rim.h"

namespace umbrage {
namespace {

/// What a sweep has listed for light `l` of its group.
std::vector<std::uint32_t> entriesOf(const Silhouettes& silhouettes, std::uint32_t l, std::uint32_t list) {
    std::vector<std::uint32_t> entries(silhouettes.hostSummaries[l].lists[list].count / 6);
    silhouettes.quads.read(std::size_t(l * LIST_COUNT + list) * silhouettes.capacity * sizeof(std::uint32_t),
                           entries.size() * sizeof(std::uint32_t), entries.data());
    return entries;
}

/// What threads have made, one after the other: sums have no order. Leaves them empty, but with their memory.
template <class T>
void takeAll(tbb::enumerable_thread_specific<std::vector<T>>& made, std::vector<T>& to) {
    to.clear();
    for (std::vector<T>& some : made) {
        to.insert(to.end(), some.begin(), some.end());
        some.clear();
    }
}

/// Far below what floats can tell, far above what doubles round.
constexpr double kHair = 1e-10;

/// Whether the line from the eye to the light passes through the triangle; of an orthographic eye the view ray that
/// meets the light.
bool crosses(const TileEye& eye, const TileCorners& v, const TileSource& source) {
    int positive = 0;
    for (std::size_t i = 0; i < 3; ++i) positive += eyeBeside(eye, v[i], v[(i + 1) % 3], source) > 0.0;
    return positive % 3 == 0;
}

/// The pixels and the depth that a triangle may have.
bool mayBeNearest(const TileCorners& corners, const TileScene& scene, const SeenTiles& seen) {
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

/// An edge that a sweep has listed.
struct TileLights::ListedEdge {
    std::uint32_t instance;
    const gpu::Edge* edge;
    glm::dvec3 a, b;  // view space

    ListedEdge(std::uint32_t entry, const TileScene& scene, std::span<const InstanceInView> instances) {
        const Geometry& geometry = scene.geometry;
        const std::uint32_t placed = (entry & ~QUAD_OF_RIGHT) >> 1;
        instance = geometry.edgeChunks()[placed >> CHUNK_SHIFT];
        const gpu::InstanceData& data = geometry.instances()[instance];
        edge = &geometry.edges()[data.edgeBase + placed - data.placedEdgeBase];
        a = instances[instance].of(scene.silhouettes.hostTriangles.position(data.vertexBase + edge->a));
        b = instances[instance].of(scene.silhouettes.hostTriangles.position(data.vertexBase + edge->b));
    }
};

glm::dvec3 InstanceInView::eyeHair() const {
    return kHair * farthestMetres() * glm::dvec3(-0.37, 0.71, 0.59);
}

void TileLights::begin(const TileScene& scene) {
    instances_.resize(scene.geometry.instanceCount());
    tbb::parallel_for(std::size_t(0), instances_.size(), [&](std::size_t i) {
        const gpu::InstanceData& data = scene.geometry.instances()[i];
        InstanceInView& instance = instances_[i];
        for (std::size_t r = 0; r < 3; ++r) instance.rows[r] = glm::dvec4(data.viewFromModel[r]);
        instance.mirrored = (data.flags & INSTANCE_MIRRORED) != 0;
        const Geometry::Bounds& box = scene.silhouettes.hostTriangles.box(std::uint32_t(i));
        instance.center = instance.of(glm::vec3(0.5 * (box.low + box.high)));
        instance.radius = 0.0;
        for (const glm::dvec3& corner : cornersOf(box)) {
            instance.radius = std::max(instance.radius, glm::distance(instance.of(glm::vec3(corner)), instance.center));
        }
    });
}

/// A light as each instance's volumes have it.
std::vector<TileSource> TileLights::sourcesInView(const TileScene& scene, std::uint32_t light) const {
    std::vector<TileSource> sources(instances_.size());
    for (std::size_t i = 0; i < sources.size(); ++i) {
        const InstanceInView& instance = instances_[i];
        const Silhouettes& silhouettes = scene.silhouettes;
        TileSource& source = sources[i];
        source.light = instance.of(glm::dvec4(silhouettes.hostLightsInModel[i * silhouettes.totalLights + light]));
        source.eyeHair = instance.eyeHair();
        const double size =
            glm::length(glm::dvec3(source.light)) + (source.light.w != 0.0 ? instance.farthestMetres() : 0.0);
        source.lightHair = kHair * size * glm::dvec3(0.8, 0.53, -0.29);
    }
    return sources;
}

/// Triangles that cast between the light and where view rays begin.
int TileLights::layersOverEye(const TileScene& scene, std::uint32_t l, std::span<const TileSource> sources) const {
    const auto& [geometry, silhouettes, group, eye, eyeConstant] = scene;
    std::atomic<int> layers = 0;
    tbb::parallel_for(std::uint32_t(0), geometry.triangleChunkCount(), [&](std::uint32_t chunk) {
        const std::uint32_t i = geometry.triangleChunks()[chunk];
        const InstanceInView& view = instances_[i];
        const glm::dvec4 light = sources[i].light;
        if (!eye.perspective && light.w == 0.0) return;  // two points at infinity
        const glm::dvec3 origin = eye.perspective ? glm::dvec3(0.0) : glm::dvec3(light);
        const glm::dvec3 d = eye.perspective ? glm::dvec3(light) : glm::dvec3(0.0, 0.0, 1.0);
        const double along = glm::dot(view.center - origin, d) / glm::dot(d, d);
        const bool ends = eye.perspective && light.w != 0.0;
        const glm::dvec3 nearest = origin + std::clamp(along, 0.0, ends ? 1.0 : std::max(along, 0.0)) * d;
        if (glm::distance(nearest, view.center) > 1.001 * view.radius) return;
        const gpu::InstanceData& instance = geometry.instances()[i];
        const std::uint32_t first = chunk * CHUNK_SIZE - instance.placedTriangleBase;
        const std::uint32_t count = std::min<std::uint32_t>(CHUNK_SIZE, instance.triangleCount - first);
        for (std::uint32_t t = first; t < first + count; ++t) {
            const int facing = scene.sideFacing(instance.placedTriangleBase + t, l);
            if (facing == 0) continue;
            if ((geometry.triangleFlags()[instance.triangleBase + t] & TRIANGLE_CASTS) == 0) continue;
            const auto corners = silhouettes.hostTriangles.corners(geometry, i, t);
            const TileCorners v{view.of(corners[0]), view.of(corners[1]), view.of(corners[2])};
            const bool lightInFront = (facing > 0) != view.mirrored;
            const bool eyeInFront = eyeBehind(eye, v, sources[i].eyeHair) <= 0.0;
            layers += lightInFront != eyeInFront && crosses(eye, v, sources[i]);
        }
    });
    return layers;
}

void TileLights::findExposed(const TileScene& scene, const SeenTiles& seen, TileCounter& counter) {
    const auto& [geometry, silhouettes, group, eye, eyeConstant] = scene;
    const HostTriangles& triangles = silhouettes.hostTriangles;
    tbb::parallel_for(std::uint32_t(0), geometry.triangleChunkCount(), [&](std::uint32_t chunk) {
        const std::uint32_t i = geometry.triangleChunks()[chunk];
        const gpu::InstanceData& instance = geometry.instances()[i];
        const std::uint32_t first = chunk * CHUNK_SIZE - instance.placedTriangleBase;
        const std::uint32_t count = std::min<std::uint32_t>(CHUNK_SIZE, instance.triangleCount - first);
        std::array<std::uint32_t, CHUNK_SIZE> front{}, back{};
        triangles.face(i, first, count, instance.eyeInModel, 1u, front.data(), back.data());
        const bool insideOut = (instance.flags & INSTANCE_INSIDE_OUT) != 0;
        const InstanceInView& view = instances_[i];
        const bool mayBeCut = -view.center.z - view.radius < eye.znear;
        for (std::uint32_t k = 0; k < count; ++k) {
            const std::uint32_t placed = chunk * CHUNK_SIZE + k;
            const std::uint32_t flags = geometry.triangleFlags()[instance.triangleBase + first + k];
            if ((flags & TRIANGLE_CASTS) == 0 || (scene.facing(placed).x | scene.facing(placed).y) == 0) continue;
            const bool turnedAway = (insideOut ? front[k] : back[k]) != 0;
            const bool culled = (flags & TRIANGLE_SINGLE_SIDED) != 0 && turnedAway;
            const bool anywhere = culled || (flags & TRIANGLE_HOLED) != 0;
            if (!anywhere && !mayBeCut) continue;
            const auto corners = triangles.corners(geometry, i, first + k);
            const TileCorners inView{view.of(corners[0]), view.of(corners[1]), view.of(corners[2])};
            const bool cut = std::ranges::any_of(inView, [&](const glm::dvec3& p) { return -p.z < eye.znear; });
            if (!anywhere && !cut) continue;
            if (!mayBeNearest(inView, scene, seen)) continue;
            if (const auto cap = tileCap(eye, inView, view.mirrored ? -1 : 1, view.eyeHair(),
                                         anywhere ? CapMissing::Anywhere : CapMissing::BeforeTheNear)) {
                madeExposed_.local().push_back({placed, *cap});
            }
        }
    });
    takeAll(madeExposed_, exposed_);
    std::ranges::sort(exposed_, {}, &Exposed::triangle);
    std::vector<TilePolygon> caps;
    for (const Exposed& exposed : exposed_) caps.push_back(exposed.cap);
    const std::vector<std::uint8_t> touching = counter.touching(seen, std::move(caps));
    std::size_t k = 0;
    std::erase_if(exposed_, [&](const Exposed&) { return touching[k++] == 0; });
}

/// Near an edge of the view's outline the rasteriser may show what is behind a triangle that the view ray meets. Where
/// it is also one of the shadow's outline, the side begins there, and only that triangle's cap makes it come out even.
void TileLights::findRim(const TileScene& scene, const SeenTiles& seen, std::uint32_t l, const ListedEdge& listed,
                         std::vector<RimSample>& found) const {
    const gpu::InstanceData& instance = scene.geometry.instances()[listed.instance];
    const InstanceInView& view = instances_[listed.instance];
    forSamplesBeside(scene.eye, listed.a, listed.b, [&](int column, int row) {
        const auto index = std::uint32_t(seen.indexOf(column, row));
        if ((seen.lit()[index] >> l & 1u) == 0) return;
        const float depth = seen.depths()[index];
        for (const std::uint32_t beside : {listed.edge->left, listed.edge->right}) {
            if (beside == EDGE_NONE) continue;
            const std::uint32_t triangle = beside & EDGE_TRIANGLE, placed = instance.placedTriangleBase + triangle;
            const int facing = scene.sideFacing(placed, l);
            if (facing == 0) continue;
            const auto exposed = std::ranges::lower_bound(exposed_, placed, {}, &Exposed::triangle);
            if (exposed != exposed_.end() && exposed->triangle == placed &&
                isBehind(exposed->cap, column, row, depth)) {
                continue;  // is counted there
            }
            const auto corners = scene.silhouettes.hostTriangles.corners(scene.geometry, listed.instance, triangle);
            const auto cap = tileCap(scene.eye, {view.of(corners[0]), view.of(corners[1]), view.of(corners[2])},
                                     view.mirrored ? -facing : facing, view.eyeHair());
            if (!cap || !isBehind(*cap, column, row, depth)) continue;
            found.push_back({placed, {index, cap->crossing}});
        }
    });
}

void TileLights::find(std::span<const CountPlan> plans, const TileScene& scene, const SeenTiles& seen, std::uint32_t l,
                      TileLight& light) {
    light.bit = 1u << l;
    const std::vector<TileSource> sources = sourcesInView(scene, scene.group.first + l);
    light.start = scene.eyeConstant ? layersOverEye(scene, l, sources) : 0;
    for (const CountPlan& plan : plans) {
        for (const VolumePart& part : plan.parts) {
            if (part.kind != VolumePart::Kind::Sides) continue;
            const std::vector<std::uint32_t> entries = entriesOf(scene.silhouettes, l, part.what);
            tbb::parallel_for(tbb::blocked_range<std::size_t>(0, entries.size(), 256), [&](const auto& range) {
                std::vector<TilePolygon>& polygons = madePolygons_.local();
                std::vector<RimSample>& rim = madeRim_.local();
                for (std::size_t k = range.begin(); k != range.end(); ++k) {
                    const ListedEdge listed(entries[k], scene, instances_);
                    const bool reversed = ((entries[k] & 1u) != 0) != instances_[listed.instance].mirrored;
                    const auto side = tileSide(scene.eye, listed.a, listed.b, sources[listed.instance],
                                               reversed ? -plan.crossings : plan.crossings);
                    if (side) polygons.push_back(*side);
                    findRim(scene, seen, l, listed, rim);
                }
            });
        }
    }
    takeAll(madePolygons_, light.polygons);
    std::vector<RimSample> rim;
    takeAll(madeRim_, rim);
    std::ranges::sort(rim);
    const auto again = std::ranges::unique(rim);  // of edges that are listed twice, or two of one triangle
    rim.erase(again.begin(), again.end());
    light.samples.clear();
    for (const RimSample& some : rim) light.samples.push_back(some.sample);
    std::ranges::sort(light.samples);
    for (const Exposed& exposed : exposed_) {
        const int facing = scene.sideFacing(exposed.triangle, l);
        if (facing == 0) continue;
        light.polygons.push_back(exposed.cap);
        light.polygons.back().crossing *= facing;
    }
}

}  // namespace umbrage
