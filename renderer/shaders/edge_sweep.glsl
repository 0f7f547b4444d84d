// SPDX-License-Identifier: Apache-2.0
// The sweep over the edges, for up to 32 lights at once (after Brabec & Seidel 2003, section 4.2: several lights an
// edge): the multiplicity of every edge from the stored facing bits, which list of its light it belongs to, hazards
// (T4), and the light's summary. What becomes of an edge that was found is the business of the pass.
#include "geometry.glsl"
#include "casters.glsl"
#include "stored_edges.glsl"
#include "side_hazards.glsl"

layout(location = 0) uniform uint chunkCount;
layout(location = 1) uniform uint facingBase;
layout(location = 7) uniform uint halve;

/// An edge with m != 0.
/// @param entry  placed edge << 1 | (m < 0), and QUAD_OF_RIGHT where it is so
/// @param list  LIST_... (+ LIST_EDGE_ON)
/// @param times  how often its quad is drawn; 0: never, because it covers nothing and would harm
void edgeFound(uint entry, uint l, uint list, uint times);

/// Adds to a list's indirect draw. @return  how many quads it had
uint addQuads(uint l, uint list, uint times) { return atomicAdd(summaries[l].lists[list].count, 6u * times) / 6u; }

#if FAULT == FAULT_FACING_TWICE
/// What geometry shaders do: the facing of a triangle from the edge's vertices and the one opposite, in that order, so
/// that its three edges round differently.
uvec2 facedAgain(uint instance, uint triangle, uint a, uint b) {
    uvec3 v = triangleVertices(instance, triangle) - instances[instance].vertexBase;
    uint base = instances[instance].vertexBase;
    vec3 from = positionOf(base + a), to = positionOf(base + b);
    vec3 opposite = vec3(0.0);
    for (uint k = 0u; k < 3u; ++k) {
        vec3 here = positionOf(base + v[k]);
        if (here != from && here != to) opposite = here;
    }
    vec3 n = cross(to - from, opposite - from);
    uvec2 bits = uvec2(0u);
    for (uint l = 0u; l < lightCount; ++l) {
        vec4 light = lightInModel(instance, l);
        float side = dot(n, light.xyz - light.w * from);
        if (side > 0.0) bits.x |= 1u << l;
        if (side < 0.0) bits.y |= 1u << l;
    }
    return bits;  // of (from, to, opposite): light in front means traversed from a to b
}
#endif

#ifdef PARTS
/// The count of a part may start from either end of the view rays, so neither may lie on its sides.
/// @return  whether the quad is drawn at all
bool findHazards(uint instance, uint l, uint list, Edge edge, uint flags, vec4 light, vec3 a, vec3 b) {
    uint triangle = ((flags & QUAD_OF_RIGHT) != 0u ? edge.right : edge.left) & EDGE_TRIANGLE;
    uint part = partOfTriangle(instances[instance].placedTriangleBase + triangle, l);
    vec4 eye = instances[instance].eyeInModel;
    bool drawn = true;
    for (uint end = SPLIT_PASS; end <= (mayHoldFarEnds(instance, l) ? SPLIT_FAIL : SPLIT_PASS); ++end) {
        vec4 there = end == SPLIT_PASS ? eye : -eye;
        if (hazardous(there, light, a, b)) atomicOr(parts[part].hazards, 1u << end);
        // With hazards of both ends it is counted by z-fail, to whose constant this quad belongs.
        bool needed = end == SPLIT_FAIL && (casters[instance].lightMoved >> l & 1u) != 0u;
        if (!needed && endsInQuad(there, light, a, b)) drawn = false;
    }
    return drawn;
}
#else
/// @return  whether the quad is drawn at all
bool findHazards(uint instance, uint l, uint list, Edge edge, uint flags, vec4 light, vec3 a, vec3 b) {
    vec4 eye = instances[instance].eyeInModel;
    bool fail = list == LIST_FAIL;
    if ((fail || eye.w == 0.0) && endsInQuad(fail ? eye : -eye, light, a, b)) return false;
    if ((!fail || mayHoldFarEnds(instance, l)) && hazardous(fail ? -eye : eye, light, a, b)) {
        atomicOr(casters[instance].hazards, 1u << l);
    }
    return true;
}
#endif

/// An edge for the lights for which its multiplicity is not 0.
/// @param left, right  traversals by its triangles
/// @param flags  of the entry: 0 or QUAD_OF_RIGHT
void findSilhouette(uint instance, uint placed, Edge edge, uvec2 left, uvec2 right, uint flags) {
    Multiplicities m = multiplicitiesOf(left, right);
    uint silhouette = m.twice.x | m.twice.y | m.once.x | m.once.y;
    while (silhouette != 0u) {
        uint l = uint(findLSB(silhouette));
        silhouette &= silhouette - 1u;
        uint list = listOf(instance, l, (edge.left & EDGE_EVEN) != 0u);
        vec4 eye = instances[instance].eyeInModel;
        vec4 light = lightInModel(instance, l);
        uint vertexBase = instances[instance].vertexBase;
        vec3 a = positionOf(vertexBase + edge.a), b = positionOf(vertexBase + edge.b);
        bool negative = ((m.twice.y | m.once.y) >> l & 1u) != 0u;
        bool isTwice = ((m.twice.x | m.twice.y) >> l & 1u) != 0u;
        uint entry = placed << 1u | uint(negative) | flags;
#ifdef PARTS
        if (list == LIST_HALVED && !isTwice) list = LIST_WHOLE;  // of an even component only another part has the rest
#endif
        if (!findHazards(instance, l, list, edge, flags, light, a, b)) {
            edgeFound(entry, l, list, 0u);
            continue;
        }
        edgeFound(entry, l, list + (isSliver(eye, light, a, b) ? LIST_EDGE_ON : 0u),
                  isTwice && !(halve != 0u && list == LIST_HALVED) ? 2u : 1u);
        if (countLit != 0u) {
            atomicAdd(summaries[l].silhouetteEdges, 1u);
            if (isTwice) atomicAdd(summaries[l].doubleEdges, 1u);
        }
    }
}

/// @param placed  any edge, or padding
void sweepEdge(uint placed) {
    uint instance;
    Edge edge;
    if (!findEdge(placed, instance, edge)) return;
#if FAULT == FAULT_MISSING_EDGE
    if ((placed - instances[instance].placedEdgeBase) % 64u == 7u) return;
#endif
    uint firstFacing = facingBase + instances[instance].placedTriangleBase;
    uvec2 left = traversalsOf(firstFacing, edge.left), right = traversalsOf(firstFacing, edge.right);
#if FAULT == FAULT_FACING_TWICE
    left = facedAgain(instance, edge.left & EDGE_TRIANGLE, edge.a, edge.b);
    if (edge.right != EDGE_NONE) right = facedAgain(instance, edge.right & EDGE_TRIANGLE, edge.b, edge.a).yx;
#endif
#ifdef PARTS
    uint placedBase = instances[instance].placedTriangleBase;
    uint placedLeft = placedBase + (edge.left & EDGE_TRIANGLE), placedRight = placedBase + (edge.right & EDGE_TRIANGLE);
    uint apart = 0u;  // lights for which it is an edge of two parts, with one triangle in each
    if (edge.right != EDGE_NONE && clusters[placedLeft] != clusters[placedRight]) {
        for (uint l = 0u; l < lightCount; ++l) {
            if (partOfTriangle(placedLeft, l) != partOfTriangle(placedRight, l)) apart |= 1u << l;
        }
        findSilhouette(instance, placed, edge, left & apart, uvec2(0u), 0u);
        findSilhouette(instance, placed, edge, right & apart, uvec2(0u), QUAD_OF_RIGHT);
    }
    left &= ~apart;
    right &= ~apart;
#endif
    findSilhouette(instance, placed, edge, left, right, 0u);
}
