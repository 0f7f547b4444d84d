// SPDX-License-Identifier: Apache-2.0
// Side quads of shadow volumes as the silhouette passes list them.
#include "corners.glsl"

layout(std430, binding = BIND_EDGES) readonly buffer Edges { Edge edges[]; };
layout(std430, binding = BIND_EDGE_CHUNKS) readonly buffer EdgeChunks { uint edgeChunks[]; };
layout(std430, binding = BIND_QUADS) readonly buffer Quads { uint quads[]; };
layout(std430, binding = BIND_LIGHTS_IN_MODEL) readonly buffer LightsInModel { vec4 lightsInModel[]; };

layout(location = 0) uniform uint lightIndex;
layout(location = 1) uniform uint totalLights;

struct Side {
    uint instance;
    vec3 a, b;  // the edge's ends, in canonical order
    vec4 light;
    // m > 0: the light-oriented surface runs from a to b, so outward is (a, a', b', b); m < 0: (a, b, b', a').
    bool reversed;
};

/// @param slot  of the buffer of quads
Side sideAt(uint slot) {
    uint entry = quads[slot];
    uint placed = entry >> 1u;
    Side side;
    side.instance = edgeChunks[placed >> CHUNK_SHIFT];
    Edge edge = edges[instances[side.instance].edgeBase + placed - instances[side.instance].placedEdgeBase];
    side.light = lightsInModel[side.instance * totalLights + lightIndex];
    side.reversed = ((entry ^ instances[side.instance].flags) & INSTANCE_MIRRORED) != 0u;
    uint vertexBase = instances[side.instance].vertexBase;
    side.a = positionOf(vertexBase + edge.a);
    side.b = positionOf(vertexBase + edge.b);
#ifdef TALLY
    caster = side.instance;
#endif
#ifdef EDGE_ON
    nearA = nearCorner(side.instance, side.a);
    farA = farCorner(side.instance, side.a, side.light);
    nearB = nearCorner(side.instance, side.b);
    farB = farCorner(side.instance, side.b, side.light);
#endif
    return side;
}
