// SPDX-License-Identifier: Apache-2.0
// Silhouette edges as lines, from the lists of side quads (quad.vert.glsl).
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "geometry.glsl"
#include "view.glsl"

layout(std430, binding = BIND_EDGES) readonly buffer Edges { Edge edges[]; };
layout(std430, binding = BIND_EDGE_CHUNKS) readonly buffer EdgeChunks { uint edgeChunks[]; };
layout(std430, binding = BIND_QUADS) readonly buffer Quads { uint quads[]; };

void main() {
    uint placed = quads[uint(gl_VertexID) >> 1u] >> 1u;
    uint instance = edgeChunks[placed >> CHUNK_SHIFT];
    Edge edge = edges[instances[instance].edgeBase + placed - instances[instance].placedEdgeBase];
    uint vertex = (gl_VertexID & 1) == 0 ? edge.a : edge.b;
    vec3 p = viewFromModel(instance, vec4(positionOf(instances[instance].vertexBase + vertex), 1.0));
    // Nearer by the width of three pixels: the surfaces that meet in the edge may slope towards the eye beside it.
    float nearer = 3.0 * view.pixelSize.y * view.rayScale.y;
    p = view.perspective != 0u ? p * (1.0 - nearer) : p + vec3(0.0, 0.0, nearer);
    gl_Position = clipFromView(p, 1.0);
}
