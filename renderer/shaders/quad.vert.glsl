// SPDX-License-Identifier: Apache-2.0
// Side quads from the lists that silhouette techniques fill.
// variant: EDGE_ON 1
// variant: TALLY 1, EDGE_ON 1
// variant: TALLY 1
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "side_quad.glsl"
#include "side_ends.glsl"

layout(std430, binding = BIND_EDGES) readonly buffer Edges { Edge edges[]; };
layout(std430, binding = BIND_EDGE_CHUNKS) readonly buffer EdgeChunks { uint edgeChunks[]; };
layout(std430, binding = BIND_QUADS) readonly buffer Quads { uint quads[]; };

void main() {
    uint entry = quads[uint(gl_VertexID) >> 2u];
    uint placed = entry >> 1u;
    uint instance = edgeChunks[placed >> CHUNK_SHIFT];
    Edge edge = edges[instances[instance].edgeBase + placed - instances[instance].placedEdgeBase];
    setCorner(instance, edge, (entry & 1u) != 0u, uint(gl_VertexID) & 3u);
}
