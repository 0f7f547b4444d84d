// SPDX-License-Identifier: Apache-2.0
// Light and dark caps of shadow volumes, for the cases in which they count (T1):
//   CAP_TRUE     at their own depth: triangles that may be missing from the depth buffer where they are nearest
//   CAP_EDGE_ON  those of them that are seen nearly edge-on (see count.frag.glsl)
//   CAP_FAR      all others at infinite depth, where they always fail, whatever rounding does (z-fail)
//   CAP_DARK     where the volume ends, at infinite depth (z-fail)
// variant: EDGE_ON 1
// variant: TALLY 1, EDGE_ON 1
// variant: TALLY 1
// variant: PARTS 1, TALLY 1
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "caps.glsl"

out gl_PerVertex { invariant vec4 gl_Position; };

void main() {
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0);  // outside: dropped
    CapTriangle triangle;
    if (!findCap(uint(gl_VertexID) / 3u, triangle)) return;
    uint instance = triangle.instance, corner = uint(gl_VertexID) % 3u;
    if (triangle.flip != (cap == CAP_DARK)) corner = 2u - corner;
    vec3 p = positionOf(triangle.vertices[corner]);
    if (cap == CAP_DARK) {
        gl_Position = volumeEnd(instance, p, lightOf(instance));
        // Behind all that is seen; seen edge-on, a depth of its own would not say so.
        if (endOf(instance) != 0u) gl_Position.z = 0.0;
        return;
    }
    gl_Position = nearCorner(instance, p);
#ifdef EDGE_ON
    nearA = nearCorner(instance, positionOf(triangle.vertices.x));
    nearB = nearCorner(instance, positionOf(triangle.vertices.y));
    farA = farB = nearCorner(instance, positionOf(triangle.vertices.z));
#endif
    if (cap == CAP_FAR) gl_Position.z = 0.0;
}
