// SPDX-License-Identifier: Apache-2.0
// Edges and, from the stored facing bits, how often the surface turned to each light runs along them (docs/rules.md, G1,
// G2). Nothing here decides a facing.
layout(std430, binding = BIND_EDGES) readonly buffer Edges { Edge edges[]; };
layout(std430, binding = BIND_EDGE_CHUNKS) readonly buffer EdgeChunks { uint edgeChunks[]; };
layout(std430, binding = BIND_FACING) readonly buffer Facing { uvec2 facing[]; };

/// @return  whether there is one: instances are padded to whole chunks
bool findEdge(uint placed, out uint instance, out Edge edge) {
    instance = edgeChunks[placed >> CHUNK_SHIFT];
    uint index = placed - instances[instance].placedEdgeBase;
    if (index >= instances[instance].edgeCount) return false;
    edge = edges[instances[instance].edgeBase + index];
    return true;
}

/// Bits of lights for which a triangle, turned so that it faces the light, runs along the edge from a to b (x) and from
/// b to a (y).
/// @param firstFacing  word of the instance's first triangle
/// @param triangle  Edge::left or Edge::right
uvec2 traversalsOf(uint firstFacing, uint triangle) {
    if (triangle == EDGE_NONE) return uvec2(0u);
    uvec2 bits = facing[firstFacing + (triangle & EDGE_TRIANGLE)];
    return (triangle & EDGE_REVERSED) != 0u ? bits.yx : bits;
}

/// The same for one light: +1 from a to b, -1 from b to a, 0 for a triangle without weight or none.
/// @param l  its place in its group
int directionOf(uint firstFacing, uint triangle, uint l) {
    uvec2 bits = traversalsOf(firstFacing, triangle) >> l & 1u;
    return int(bits.x) - int(bits.y);
}

/// Bits of lights for which the multiplicity m of an edge is +2 and -2 (x, y of twice), +1 and -1 (of once).
struct Multiplicities {
    uvec2 once, twice;
};

Multiplicities multiplicitiesOf(uvec2 left, uvec2 right) {
    return Multiplicities((left ^ right) & ~(left | right).yx, left & right);
}
