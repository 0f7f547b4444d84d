// SPDX-License-Identifier: Apache-2.0
// Silhouettes of up to 32 lights at once from the stored facing bits (after Brabec & Seidel 2003, section 4.2: several
// lights an edge): the multiplicity m of every edge is the signed sum over its triangles (G2), and every
// edge with m != 0 is appended to its light's list, drawn indirectly.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "geometry.glsl"
#include "casters.glsl"

layout(local_size_x = CHUNK_SIZE) in;

layout(std430, binding = BIND_EDGES) readonly buffer Edges { Edge edges[]; };
layout(std430, binding = BIND_EDGE_CHUNKS) readonly buffer EdgeChunks { uint edgeChunks[]; };
layout(std430, binding = BIND_FACING) readonly buffer Facing { uvec2 facing[]; };
// capacity entries for each list of each light: placed edge << 1 | (m < 0)
layout(std430, binding = BIND_QUADS) writeonly buffer Quads { uint quads[]; };

layout(location = 0) uniform uint chunkCount;
layout(location = 1) uniform uint facingBase;
layout(location = 6) uniform uint capacity;
layout(location = 7) uniform uint halve;

/// An end of the view rays (the eye, or for an orthographic eye a direction, w = 0) within the wedge of a side quad, to
/// whose plane it is near. The wedge is widened by 2^-6 in its own coordinates; outside it the quad is seen edge-on and
/// covers nothing.
bool inWedge(vec4 eye, vec4 light, vec3 a, vec3 b) {
    vec3 e = eye.w == 0.0 ? eye.xyz : (light.w == 0.0 ? eye.xyz - a : eye.xyz - light.xyz);
    vec3 u = light.w == 0.0 ? b - a : a - light.xyz;
    vec3 v = light.w == 0.0 ? -light.xyz : b - light.xyz;
    vec3 n = cross(u, v);
    float squared = dot(n, n);
    const float kMargin = 0.015625;
    float alongU = dot(cross(e, v), n) / squared;  // e = alongU u + alongV v
    float alongV = dot(cross(u, e), n) / squared;
    if (eye.w == 0.0) {
        return alongU * length(u) > -kMargin * length(e) && alongV * length(v) > -kMargin * length(e);
    }
    if (light.w == 0.0) {
        return alongU > -kMargin && alongU < 1.0 + kMargin &&
               alongV * length(v) > -kMargin * (length(u) + length(e));
    }
    return alongU > -kMargin && alongV > -kMargin && alongU + alongV > 1.0 - kMargin;
}

/// T4: the start of the count so close to the quad that the rasteriser and the eye constant may disagree about the side
/// it is on.
bool hazardous(vec4 start, vec4 light, vec3 a, vec3 b) {
    if (start.w == 0.0 && light.w == 0.0) return false;  // such counts have no constant
    vec3 e = start.w == 0.0 ? start.xyz : (light.w == 0.0 ? start.xyz - a : start.xyz - light.xyz);
    vec3 n = light.w == 0.0 ? cross(b - a, -light.xyz) : cross(a - light.xyz, b - light.xyz);
    float scale = start.w == 0.0 ? length(e) : max(length(e), max(distance(start.xyz, a), distance(start.xyz, b)));
    return abs(dot(n, e)) < HAZARD * scale * length(n) && inWedge(start, light, a, b);
}

/// The side quad seen nearly edge-on, or its edge nearly along the light's rays: a sliver on screen.
bool isSliver(vec4 eye, vec4 light, vec3 a, vec3 b) {
    vec3 l = light.w == 0.0 ? light.xyz : light.xyz - a;
    vec3 e = eye.w == 0.0 ? eye.xyz : eye.xyz - a;
    return abs(dot(cross(b - a, l), e)) < EDGE_ON_SINE * length(b - a) * length(l) * length(e);
}

/// The view rays' other end, from which the count does not start, in the quad: it is seen edge-on and covers nothing,
/// but passes through the one point without a place on screen (x = y = w = 0), where clippers go astray.
bool endsInQuad(vec4 end, vec4 light, vec3 a, vec3 b) {
    if (end.w == 0.0 && light.w == 0.0) return false;
    vec3 n = cross(b - a, light.w == 0.0 ? light.xyz : light.xyz - a);
    vec3 e = end.w == 0.0 ? end.xyz : end.xyz - a;
    return abs(dot(n, e)) < IN_LINE_SINE * length(n) * length(e) && inWedge(end, light, a, b);
}

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

void append(uint list, uint l, uint entry, uint times) {
    uint slot = atomicAdd(summaries[l].lists[list].count, 6u * times) / 6u;
    for (uint i = 0u; i < times; ++i) {
        if (slot + i < capacity) quads[(l * LIST_COUNT + list) * capacity + slot + i] = entry;
    }
}

#ifdef PARTS
/// The count of a part may start from either end of the view rays, so neither may lie on its sides.
/// @return whether the quad is drawn at all
bool findHazards(uint instance, uint l, uint list, Edge edge, uint flags, vec4 eye, vec4 light, vec3 a, vec3 b) {
    uint triangle = ((flags & QUAD_OF_RIGHT) != 0u ? edge.right : edge.left) & EDGE_TRIANGLE;
    uint part = partOfTriangle(instances[instance].placedTriangleBase + triangle, l);
    bool drawn = true;
    for (uint end = SPLIT_PASS; end <= (eye.w == 0.0 ? SPLIT_FAIL : SPLIT_PASS); ++end) {
        vec4 there = end == SPLIT_PASS ? eye : -eye;
        if (hazardous(there, light, a, b)) atomicOr(parts[part].hazards, 1u << end);
        if (endsInQuad(there, light, a, b)) drawn = false;
    }
    return drawn;
}
#else
bool findHazards(uint instance, uint l, uint list, Edge edge, uint flags, vec4 eye, vec4 light, vec3 a, vec3 b) {
    bool orthographic = eye.w == 0.0, fail = list == LIST_FAIL;
    if ((fail || orthographic) && endsInQuad(fail ? eye : -eye, light, a, b)) return false;
    if ((orthographic || !fail) && hazardous(fail ? -eye : eye, light, a, b)) {
        atomicOr(casters[instance].hazards, 1u << l);
    }
    return true;
}
#endif

/// The sides of an edge for the lights for which its multiplicity is not 0.
/// @param left, right  traversals by its triangles
/// @param flags  0 or QUAD_OF_RIGHT
void appendAll(uint instance, uint placed, Edge edge, uvec2 left, uvec2 right, uint flags) {
    uvec2 twice = left & right;
    uvec2 once = (left ^ right) & ~(left | right).yx;
    uint silhouette = twice.x | twice.y | once.x | once.y;
    while (silhouette != 0u) {
        uint l = uint(findLSB(silhouette));
        silhouette &= silhouette - 1u;
        vec4 eye = instances[instance].eyeInModel;
        vec4 light = lightInModel(instance, l);
        uint vertexBase = instances[instance].vertexBase;
        vec3 a = positionOf(vertexBase + edge.a), b = positionOf(vertexBase + edge.b);
        bool negative = ((twice.y | once.y) >> l & 1u) != 0u;
        bool isTwice = ((twice.x | twice.y) >> l & 1u) != 0u;
        uint list = listOf(instance, l, (edge.left & EDGE_EVEN) != 0u);
#ifdef PARTS
        if (list == LIST_HALVED && !isTwice) list = LIST_WHOLE;  // of an even component only another part has the rest
#endif
        if (!findHazards(instance, l, list, edge, flags, eye, light, a, b)) continue;
        append(list + (isSliver(eye, light, a, b) ? LIST_EDGE_ON : 0u), l, placed << 1u | uint(negative) | flags,
               isTwice && !(halve != 0u && list == LIST_HALVED) ? 2u : 1u);
        if (countLit != 0u) {
            atomicAdd(summaries[l].silhouetteEdges, 1u);
            if (isTwice) atomicAdd(summaries[l].doubleEdges, 1u);
        }
    }
}

void main() {
    uint chunk = GROUP_HERE;
    if (chunk >= chunkCount) return;
    uint instance = edgeChunks[chunk];
    uint placed = chunk * CHUNK_SIZE + gl_LocalInvocationID.x;
    uint index = placed - instances[instance].placedEdgeBase;
    if (index >= instances[instance].edgeCount) return;
#if FAULT == FAULT_MISSING_EDGE
    if (index % 64u == 7u) return;
#endif
    Edge edge = edges[instances[instance].edgeBase + index];

    // Light-oriented traversals of the edge from a to b (x) and from b to a (y), per light.
    uint base = facingBase + instances[instance].placedTriangleBase;
    uvec2 left = facing[base + (edge.left & EDGE_TRIANGLE)];
    if ((edge.left & EDGE_REVERSED) != 0u) left = left.yx;
    uvec2 right = uvec2(0u);
    if (edge.right != EDGE_NONE) {
        right = facing[base + (edge.right & EDGE_TRIANGLE)];
        if ((edge.right & EDGE_REVERSED) != 0u) right = right.yx;
    }
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
        appendAll(instance, placed, edge, left & apart, uvec2(0u), 0u);
        appendAll(instance, placed, edge, right & apart, uvec2(0u), QUAD_OF_RIGHT);
    }
    appendAll(instance, placed, edge, left & ~apart, right & ~apart, 0u);
#else
    appendAll(instance, placed, edge, left, right, 0u);
#endif
}
