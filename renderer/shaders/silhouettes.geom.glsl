// SPDX-License-Identifier: Apache-2.0
// Silhouettes in the geometry stage (GPU Gems 3, chapter 11, in its form for meshes that are not closed): every triangle
// has its three edges and makes the side quads of those whose neighbour does not take them back. An edge with |m| = 2
// gets one from either of its triangles, one with |m| = 1 from the one that has a direction there; so the sum is m for
// any triangle soup. No facing is decided here.
// variant: EDGE_ON 1
// variant: TALLY 1, EDGE_ON 1
// variant: TALLY 1
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "every_edge.glsl"
#include "side_ends.glsl"
#include "stored_edges.glsl"

layout(triangles_adjacency) in;
// Triangles one by one, each from its own first corner: in a strip coincident quads would interpolate differently.
layout(triangle_strip, max_vertices = 18) out;

layout(std430, binding = BIND_QUADS) readonly buffer EdgeClasses { uvec2 edgeClasses[]; };  // see edge_classes.comp.glsl

layout(location = 0) flat in uint edgeAcross[];
layout(location = 1) flat in ivec2 directions[];

void main() {
    for (uint k = 1u; k < 6u; k += 2u) {
        int own = directions[k].x, neighbour = directions[k].y;
        if (edgeAcross[k] == EDGE_NONE || own == 0 || neighbour == -own) continue;
        uvec2 classes = edgeClasses[edgeAcross[k]] >> l & 1u;
        uint instance;
        Edge edge;
        if (classes.y != 0u || !findEdge(edgeAcross[k], instance, edge) || !isInList(instance, edge, classes.x != 0u)) continue;
        const uint kCorners[6] = {0u, 1u, 2u, 0u, 2u, 3u};
        for (uint i = 0u; i < 6u; ++i) {
            setCorner(instance, edge, own < 0, kCorners[i]);
            EmitVertex();
            if (i % 3u == 2u) EndPrimitive();
        }
    }
}
