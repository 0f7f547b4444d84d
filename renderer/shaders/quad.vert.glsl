// SPDX-License-Identifier: Apache-2.0
// Side quads of shadow volumes: an edge (u, v) and its projection from the light to infinity (w = 0). The diagonal
// always runs from u to v's projection, so that coincident quads are cut alike (R6).
// variant: EDGE_ON 1
// variant: TALLY 1, EDGE_ON 1
// variant: TALLY 1
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "corners.glsl"

layout(std430, binding = BIND_EDGES) readonly buffer Edges { Edge edges[]; };
layout(std430, binding = BIND_EDGE_CHUNKS) readonly buffer EdgeChunks { uint edgeChunks[]; };
layout(std430, binding = BIND_QUADS) readonly buffer Quads { uint quads[]; };
layout(std430, binding = BIND_LIGHTS_IN_MODEL) readonly buffer LightsInModel { vec4 lightsInModel[]; };
layout(std430, binding = BIND_CASTERS) readonly buffer Casters { CasterState casters[]; };

layout(location = 0) uniform uint lightIndex;
layout(location = 1) uniform uint totalLights;

/// Of a caster's sides, see sideEnd(). Volumes counted by z-fail go on to infinity, where their caps are.
uint endOf(uint instance) {
    uint l = lightIndex % LIGHTS_PER_GROUP;
    if ((casters[instance].countedByFail >> l & 1u) != 0u) return 0u;
    return casters[instance].ends[l / 10u] >> (3u * (l % 10u)) & 7u;
}

void main() {
    uint entry = quads[uint(gl_VertexID) >> 2u];
    uint placed = entry >> 1u;
    uint instance = edgeChunks[placed >> CHUNK_SHIFT];
    Edge edge = edges[instances[instance].edgeBase + placed - instances[instance].placedEdgeBase];
    vec4 light = lightsInModel[instance * totalLights + lightIndex];
    // m > 0: the light-oriented surface runs from a to b, so outward is (a, a', b', b); m < 0: (a, b, b', a').
    bool reversed = ((entry ^ instances[instance].flags) & INSTANCE_MIRRORED) != 0u;
    uint corner = uint(gl_VertexID) & 3u;
    bool far = corner == 2u || corner == (reversed ? 3u : 1u);
    bool second = corner == 2u || corner == (reversed ? 1u : 3u);
    uint end = endOf(instance);
    uint vertexBase = instances[instance].vertexBase;
    vec3 p = positionOf(vertexBase + (second ? edge.b : edge.a));
    gl_Position = far ? sideEnd(instance, p, light, end) : nearCorner(instance, p);
#ifdef TALLY
    caster = instance;
#endif
#ifdef EDGE_ON
    vec3 a = positionOf(vertexBase + edge.a), b = positionOf(vertexBase + edge.b);
    nearA = nearCorner(instance, a);
    farA = sideEnd(instance, a, light, end);
    nearB = nearCorner(instance, b);
    farB = sideEnd(instance, b, light, end);
#endif
}
