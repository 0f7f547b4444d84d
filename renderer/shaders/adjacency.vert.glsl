// SPDX-License-Identifier: Apache-2.0
// Triangles with adjacency for silhouettes.geom.glsl. Of the six vertices of one, the second, fourth and sixth stand for
// what lies across its edges; where others have the neighbour's far corner, to decide its facing from, these have its
// stored direction along the edge.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "geometry.glsl"
#include "stored_edges.glsl"

layout(std430, binding = BIND_TRIANGLE_CHUNKS) readonly buffer TriangleChunks { uint triangleChunks[]; };
// Per triangle of a mesh: the records of its three edges, or EDGE_NONE.
layout(std430, binding = BIND_ADJACENCY) readonly buffer Adjacency { uint adjacency[]; };

layout(location = 2) uniform uint facingBase;
layout(location = 3) uniform uint l;  // the light's place in its group
layout(location = 5) uniform uint once;  // one quad for two crossings: those of triangles on the left

layout(location = 0) flat out uint edgeAcross;   // placed, or EDGE_NONE
layout(location = 1) flat out ivec2 directions;  // +1: a to b, -1 or 0; its own and the neighbour's

void main() {
    gl_Position = vec4(0.0);
    edgeAcross = EDGE_NONE;
    directions = ivec2(0);
    uint placed = uint(gl_VertexID) / 6u, corner = uint(gl_VertexID) % 6u;
    uint instance = triangleChunks[placed >> CHUNK_SHIFT];
    uint triangle = placed - instances[instance].placedTriangleBase;
    if ((corner & 1u) == 0u || triangle >= instances[instance].triangleCount) return;
    uint record = adjacency[3u * (instances[instance].triangleBase + triangle) + corner / 2u];
    if (record == EDGE_NONE) return;
    Edge edge = edges[instances[instance].edgeBase + record];
    bool onLeft = (edge.left & EDGE_TRIANGLE) == triangle;
    if (once != 0u && !onLeft) return;
    edgeAcross = instances[instance].placedEdgeBase + record;
    uint firstFacing = facingBase + instances[instance].placedTriangleBase;
    int left = directionOf(firstFacing, edge.left, l), right = directionOf(firstFacing, edge.right, l);
    directions = onLeft ? ivec2(left, right) : ivec2(right, left);
}
