// SPDX-License-Identifier: Apache-2.0
// Entries of the lists that silhouette techniques fill.
layout(std430, binding = BIND_EDGES) readonly buffer Edges { Edge edges[]; };
layout(std430, binding = BIND_EDGE_CHUNKS) readonly buffer EdgeChunks { uint edgeChunks[]; };
layout(std430, binding = BIND_QUADS) readonly buffer Quads { uint quads[]; };

struct ListedEdge {
    uint instance;
    Edge edge;
    bool negative;  // m < 0
    bool ofRight;   // QUAD_OF_RIGHT
};

/// @param slot  of the buffer of quads
ListedEdge listedEdge(uint slot) {
    uint entry = quads[slot], placed = (entry & ~QUAD_OF_RIGHT) >> 1u;
    uint instance = edgeChunks[placed >> CHUNK_SHIFT];
    uint index = instances[instance].edgeBase + placed - instances[instance].placedEdgeBase;
    return ListedEdge(instance, edges[index], (entry & 1u) != 0u, (entry & QUAD_OF_RIGHT) != 0u);
}
