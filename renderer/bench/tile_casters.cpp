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

/// Casts where its front faces the light alone: closed, and every edge run through once each way.
bool hasInside(const MeshTopology& topology) {
    return topology.figures.inconsistentEdges == 0 && topology.figures.nonManifoldEdges == 0;
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

std::vector<double> inverseDepthsOf(const FramePixels& pixels, const Eye& eye) {
    const double least = eye.zfar > 0.0 ? 1.0 / eye.zfar : 0.0;
    std::vector<double> depths(pixels.normalAndDepth.size() / 4);
    for (std::size_t i = 0; i < depths.size(); ++i) {
        depths[i] = std::max(1.0 / double(pixels.normalAndDepth[4 * i + 3]), least);
    }
    return depths;
}

}  // namespace umbrage
