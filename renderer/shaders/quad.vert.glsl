// SPDX-License-Identifier: Apache-2.0
// Side quads of shadow volumes: an edge (u, v) and its projection from the light to infinity (w = 0). The diagonal
// always runs from u to v's projection, so that coincident quads are cut alike (R6).
// variant: EDGE_ON 1
// variant: TALLY 1, EDGE_ON 1
// variant: TALLY 1
// variant: FINITE 1
// variant: FINITE 1, EDGE_ON 1
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "sides.glsl"

void main() {
    Side side = sideAt(uint(gl_VertexID) >> 2u);
    uint corner = uint(gl_VertexID) & 3u;
    bool far = corner == 2u || corner == (side.reversed ? 3u : 1u);
    bool second = corner == 2u || corner == (side.reversed ? 1u : 3u);
    vec3 p = second ? side.b : side.a;
    gl_Position = far ? farCorner(side.instance, p, side.light) : nearCorner(side.instance, p);
}
