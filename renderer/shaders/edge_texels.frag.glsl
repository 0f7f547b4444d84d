// SPDX-License-Identifier: Apache-2.0
// Brabec & Seidel 2003, section 4.2: every edge classified for all lights of a group at once, its flags written to its
// own texel. They had two bits a light (silhouette, direction), 12 lights in the 24 bits of RGB8, and closed meshes. Any
// triangle soup needs the sign of m and whether |m| is 2, and a fourth bit keeps quads that are seen edge-on apart: in
// the four words of an RGBA32UI texel that is one group of 32 lights.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "edge_sweep.glsl"

layout(location = 0) out uvec4 outFlags;  // bits of lights: m > 0, m < 0, drawn twice, edge-on

uvec4 flags = uvec4(0u);

void edgeFound(uint entry, uint l, uint list, uint times) {
    if (times == 0u) return;
    addQuads(l, list, times);
    uint bit = 1u << l;
    if ((entry & 1u) != 0u) flags.y |= bit;
    else flags.x |= bit;
    if (times == 2u) flags.z |= bit;
    if (list >= LIST_EDGE_ON) flags.w |= bit;
}

void main() {
    uint placed = uint(gl_FragCoord.y) * TEXEL_ROW + uint(gl_FragCoord.x);
    if (placed >> CHUNK_SHIFT < chunkCount) sweepEdge(placed);
    outFlags = flags;
}
