// SPDX-License-Identifier: Apache-2.0
// Silhouettes of up to 32 lights at once, listed: every edge with m != 0 is appended to its light's list of side quads,
// which is drawn indirectly (quad.vert.glsl).
// variant: PARTS 1
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "edge_sweep.glsl"

layout(local_size_x = CHUNK_SIZE) in;

// capacity entries for each list of each light
layout(std430, binding = BIND_QUADS) writeonly buffer Quads { uint quads[]; };

layout(location = 6) uniform uint capacity;

void edgeFound(uint entry, uint l, uint list, uint times) {
    uint slot = addQuads(l, list, times);
    for (uint i = 0u; i < times; ++i) {
        if (slot + i < capacity) quads[(l * LIST_COUNT + list) * capacity + slot + i] = entry;
    }
}

void main() {
    uint chunk = GROUP_HERE;
    if (chunk < chunkCount) sweepEdge(chunk * CHUNK_SIZE + gl_LocalInvocationID.x);
}
