// SPDX-License-Identifier: Apache-2.0
// Side quads from the lists that silhouette techniques fill.
// variant: EDGE_ON 1
// variant: TALLY 1, EDGE_ON 1
// variant: TALLY 1
// variant: PARTS 1, TALLY 1
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "side_quad.glsl"
#include "side_ends.glsl"
#include "listed_edge.glsl"

void main() {
    ListedEdge side = listedEdge(uint(gl_VertexID) >> 2u);
#ifdef PARTS
    uint triangle = (side.ofRight ? side.edge.right : side.edge.left) & EDGE_TRIANGLE;
    part = partOfTriangle(instances[side.instance].placedTriangleBase + triangle);
#endif
    setCorner(side.instance, side.edge, side.negative, uint(gl_VertexID) & 3u);
}
