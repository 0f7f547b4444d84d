// SPDX-License-Identifier: Apache-2.0
// The sweep for techniques that draw every edge or triangle and find silhouettes while they draw: stored are only what
// must be decided once, the class of each side quad.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "edge_sweep.glsl"

layout(local_size_x = CHUNK_SIZE) in;

// Per placed edge, bits of lights: the side quad is seen edge-on; it is left out.
layout(std430, binding = BIND_QUADS) writeonly buffer EdgeClasses { uvec2 edgeClasses[]; };

uvec2 classes = uvec2(0u);

void edgeFound(uint entry, uint l, uint list, uint times) {
    addQuads(l, list, times);
    if (list >= LIST_EDGE_ON) classes.x |= 1u << l;
    if (times == 0u) classes.y |= 1u << l;
}

void main() {
    uint chunk = GROUP_HERE;
    if (chunk >= chunkCount) return;
    uint placed = chunk * CHUNK_SIZE + gl_LocalInvocationID.x;
    sweepEdge(placed);
    edgeClasses[placed] = classes;
}
