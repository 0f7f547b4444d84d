// SPDX-License-Identifier: Apache-2.0
// Surdulescu 2003: every edge is a quad of no width. Two of its corners belong to the triangle on its left and two to the
// one on its right, and those whose triangle is turned away from the light go to infinity; so the quad opens where one
// is and the other is not. Which triangles are turned away was decided once, by facing.comp; he asked anew at every
// vertex.
//
// With s the direction in which a triangle, turned to the light, runs along the edge (+1 from a to b, -1, or 0 without
// one), "turned away" is s < 0 on the left and s > 0 on the right, and what opens is half of m = s(left) + s(right). So
// one quad stands for two crossings where edges are even, and two are drawn elsewhere: what has no direction runs one
// way in the first and the other way in the second, which is right for any triangle soup.
// variant: EDGE_ON 1
// variant: TALLY 1, EDGE_ON 1
// variant: TALLY 1
// variant: FAULT 7
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "every_edge.glsl"
#include "stored_edges.glsl"
#if FAULT == FAULT_ORIGIN_EXTRUSION
vec4 nearEnd(uint instance, uint vertex) {
    return nearCorner(instance, positionOf(instances[instance].vertexBase + vertex));
}

/// His extrusion: v + k (v - L), here with k = 1, and then w = 0. It should be v - L alone; with v before it, the
/// direction depends on where the origin is.
vec4 farEnd(uint instance, uint vertex, vec4 light) {
    vec3 p = positionOf(instances[instance].vertexBase + vertex);
    return farCorner(instance, p, vec4(light.xyz - p, light.w));
}
#else
#include "side_ends.glsl"
#endif

layout(std430, binding = BIND_QUADS) readonly buffer EdgeClasses { uvec2 edgeClasses[]; };  // see edge_classes.comp.glsl

void main() {
    gl_Position = kRejected;
    uint placed = uint(gl_VertexID) >> 2u;
    uint instance;
    Edge edge;
    if (!findEdge(placed, instance, edge)) return;
    uvec2 classes = edgeClasses[placed] >> l & 1u;
    if (classes.y != 0u || !isInList(instance, edge, classes.x != 0u)) return;

    uint firstFacing = facingBase + instances[instance].placedTriangleBase;
    int left = directionOf(firstFacing, edge.left, l), right = directionOf(firstFacing, edge.right, l);
    int none = gl_InstanceID == 0 ? 1 : -1;
    bool leftFar = (left == 0 ? none : left) < 0, rightFar = (right == 0 ? -none : right) > 0;

    // Corners in a ring: a of the left, a and b of the right, b of the left. It begins with the a that stays (R6).
    uint corner = uint(gl_VertexID) & 3u;
    if ((instances[instance].flags & INSTANCE_MIRRORED) != 0u) corner = 4u - corner;
    uint turn = (corner + uint(leftFar)) & 3u;
    bool onRight = turn == 1u || turn == 2u;
    setCorner(instance, edge, onRight ? rightFar : leftFar, turn >= 2u);
}
