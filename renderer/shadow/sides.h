// SPDX-License-Identifier: Apache-2.0
// Side quads drawn from a pattern of indices: those in a technique's lists, or all.
#pragma once

#include "shadow/silhouette.h"

namespace umbrage {

/// Indices of quads: 0 1 2, 0 2 3, 4 5 6, ...
class QuadPattern {
public:
    /// Binds indices of at least that many quads.
    void bind(std::size_t quadCount);

private:
    gpu::VertexArray vertexArray_{"side quads"};
    gpu::Buffer indices_;
};

/// Draws what a sweep has listed, indirectly.
class ListedSides {
public:
    static SideShaders shaders() { return {"quad.vert"}; }
    /// What a technique on the host has listed. @param lists  LIST_COUNT of each light
    static void upload(std::span<const std::vector<std::uint32_t>> lists, Silhouettes& out);
    void draw(const SideList& sides);

private:
    QuadPattern pattern_;
};

/// Draws a quad for every edge; their shaders include every_edge.glsl.
class EverySide {
public:
    /// @param times  how often each
    void draw(const SideList& sides, const gpu::Program& program, int times);

private:
    QuadPattern pattern_;
};

/// The uniforms of every_edge.glsl but those that VolumeRenderer sets.
void setEveryEdgeUniforms(const SideList& sides, const gpu::Program& program);

}  // namespace umbrage
