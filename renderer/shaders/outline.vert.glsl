// SPDX-License-Identifier: Apache-2.0
// Silhouette edges as lines, seen from a light by its stored facing bits or, with CONTOUR, from the eye by the side of
// each triangle's stored plane that it is on: what Brabec & Seidel 2003 proposed for drawing outlines.
// variant: CONTOUR 1
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "geometry.glsl"
#include "view.glsl"
#include "stored_edges.glsl"

#ifdef CONTOUR
layout(std430, binding = BIND_PLANES) readonly buffer Planes { vec4 planes[]; };

int directionTowards(uint instance, uint triangle) {
    if (triangle == EDGE_NONE) return 0;
    vec4 plane = planes[instances[instance].placedTriangleBase + (triangle & EDGE_TRIANGLE)];
    int side = int(sign(view.perspective != 0u ? plane.w : plane.z));
    return (triangle & EDGE_REVERSED) != 0u ? -side : side;
}
#else
layout(location = 0) uniform uint facingBase;
layout(location = 1) uniform uint l;  // the light's place in its group

int directionTowards(uint instance, uint triangle) {
    return directionOf(facingBase + instances[instance].placedTriangleBase, triangle, l);
}
#endif

void main() {
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0);  // outside: dropped
    uint instance;
    Edge edge;
    if (!findEdge(uint(gl_VertexID) >> 1u, instance, edge)) return;
    if (directionTowards(instance, edge.left) + directionTowards(instance, edge.right) == 0) return;
    uint vertex = (gl_VertexID & 1) == 0 ? edge.a : edge.b;
    vec3 p = viewFromModel(instance, vec4(positionOf(instances[instance].vertexBase + vertex), 1.0));
    // Nearer by the width of three pixels: the surfaces that meet in the edge may slope towards the eye beside it.
    float nearer = 3.0 * view.pixelSize.y * view.rayScale.y;
    p = view.perspective != 0u ? p * (1.0 - nearer) : p + vec3(0.0, 0.0, nearer);
    gl_Position = clipFromView(p, 1.0);
}
