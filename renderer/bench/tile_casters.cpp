// SPDX-License-Identifier: Apache-2.0
#include "bench/tile_casters.h"

#include <algorithm>

#include "scene/node_paths.h"
#include "scene/parts.h"

namespace umbrage {
namespace {

/// As seen from the eye.
bool turnedAway(const std::array<glm::dvec3, 3>& v, const Eye& eye) {
    const glm::dvec4 point = eye.point();
    return glm::dot(glm::cross(v[1] - v[0], v[2] - v[0]), glm::dvec3(point) - point.w * v[0]) < 0.0;
}

/// Calls visit(x, y) for the pixels that a polygon covers.
template <class Visit>
void forCovered(const TilePolygon& polygon, const PixelBox& box, const Visit& visit) {
    if (polygon.cover(box) == TilePolygon::Cover::None) return;
    const int width = box.right - box.left + 1, height = box.bottom - box.top + 1;
    if (width * height <= 16) {
        for (int y = box.top; y <= box.bottom; ++y) {
            for (int x = box.left; x <= box.right; ++x) {
                if (polygon.covers(x, y)) visit(x, y);
            }
        }
        return;
    }
    PixelBox low = box, high = box;
    if (width > height) {
        low.right = box.left + width / 2 - 1;
        high.left = low.right + 1;
    } else {
        low.bottom = box.top + height / 2 - 1;
        high.top = low.bottom + 1;
    }
    forCovered(polygon, low, visit);
    forCovered(polygon, high, visit);
}

/// Casts where its front faces the light alone: closed, and every edge run through once each way.
bool hasInside(const MeshTopology& topology) {
    return topology.figures.inconsistentEdges == 0 && topology.figures.nonManifoldEdges == 0;
}

/// The triangles themselves, where they are nearer.
void addSurfaces(TileCaster caster, const Eye& eye, const TileView& view, std::vector<double>& depths) {
    for (CastingTriangle& triangle : caster.triangles) {
        triangle.oneSided = triangle.mayBeUnseen;  // what the viewer does not see from behind
        triangle.mayBeUnseen = true;
    }
    for (const TilePolygon& polygon : volumePolygons(caster, glm::dvec4(eye.position(), 1.0), view)) {
        if (polygon.kind != TilePolygon::Kind::LightCap) continue;  // of a light at the eye
        forCovered(polygon, {0, 0, view.width() - 1, view.height() - 1}, [&](int x, int y) {
            double& depth = depths[std::size_t(y) * std::size_t(view.width()) + std::size_t(x)];
            depth = std::max(depth, polygon.inverseDepth.at(x, y));
        });
    }
}

}  // namespace

std::vector<TileCaster> tileCasters(const Scene& scene, const Moment& moment, const Geometry& geometry,
                                    const Truth& truth, const Eye& eye, std::span<const Located<std::string>> globs,
                                    Weights weights) {
    const InstanceParts parts = groupInstances(scene, moment.instances, globs);
    std::vector<TileCaster> casters(parts.count());
    std::vector<bool> casts(parts.count());
    for (std::size_t p = 0; p < casters.size(); ++p) {
        casters[p].name = scene.nodes[std::size_t(parts.nodes[p])].path;
        casts[p] = globs.empty() || std::ranges::any_of(globs, [&](const Located<std::string>& glob) {
                       return matchesGlob(glob.value, casters[p].name);
                   });
    }
    for (std::uint32_t i = 0; i < moment.instances.size(); ++i) {
        if (!casts[parts.ofInstance[i]]) continue;
        const gpu::InstanceData& instance = geometry.instances()[i];
        const MeshTopology& topology = geometry.topologies()[geometry.meshOf(i)];
        std::vector<CastingTriangle>& triangles = casters[parts.ofInstance[i]].triangles;
        for (std::uint32_t t = 0; t < instance.triangleCount; ++t) {
            const oracle::Triangle& triangle = truth.oracle()[truth.indexOf(instance.placedTriangleBase + t)];
            if (!triangle.casts || !topology.casts[t]) continue;
            const bool closed = topology.even[t];
            // What is turned away on a closed surface is never the nearest.
            const bool mayBeUnseen =
                triangle.holed || (triangle.singleSided && !closed && turnedAway(triangle.corners, eye));
            const bool oneSided = weights == Weights::Least && closed && hasInside(topology);
            triangles.push_back({triangle.corners, oneSided, mayBeUnseen});
        }
    }
    std::erase_if(casters, [](const TileCaster& caster) { return caster.triangles.empty(); });
    return casters;
}

std::vector<double> inverseDepthsOf(const FramePixels& pixels, std::span<const TileCaster> casters, const Eye& eye,
                                    const TileView& view) {
    const double least = eye.zfar > 0.0 ? 1.0 / eye.zfar : 0.0;
    std::vector<double> depths(pixels.normalAndDepth.size() / 4);
    for (std::size_t i = 0; i < depths.size(); ++i) {
        depths[i] = std::max(1.0 / double(pixels.normalAndDepth[4 * i + 3]), least);
    }
    for (const TileCaster& caster : casters) addSurfaces(caster, eye, view, depths);
    return depths;
}

}  // namespace umbrage
