// SPDX-License-Identifier: Apache-2.0
// Corners of side quads, for every stage that makes them: an edge (a, b) and its projection from the light to infinity
// (w = 0), or behind all that the light shines on (T2). The diagonal always runs from a, where both triangles begin, to b's projection, so that coincident quads are
// cut alike (R6).
#include "corners.glsl"
#include "caster_lists.glsl"

layout(std430, binding = BIND_LIGHTS_IN_MODEL) readonly buffer LightsInModel { vec4 lightsInModel[]; };

layout(location = 0) uniform uint lightIndex;  // of all
layout(location = 1) uniform uint totalLights;
layout(location = EXTENT_FACES) uniform vec4 extentFaces[6];

/// An end of an edge and its projection. @param vertex  of the mesh
vec4 nearEnd(uint instance, uint vertex);
vec4 farEnd(uint instance, uint vertex, vec4 light);

vec4 lightOf(uint instance) { return lightsInModel[instance * totalLights + lightIndex]; }

/// The face of the light's extent that sides of the caster end behind, and 1, or 0 for infinity: where volumes counted
/// by z-fail have their caps.
uint endOf(uint instance) {
    uint l = lightIndex % LIGHTS_PER_GROUP;
    if ((casters[instance].countedByFail >> l & 1u) != 0u) return 0u;
    return casters[instance].ends[l / 10u] >> (3u * (l % 10u)) & 7u;
}

/// Where the side at p, in model space, ends.
vec4 sideEnd(uint instance, vec3 p, vec4 light) {
    uint end = endOf(instance);
    if (end == 0u) return farCorner(instance, p, light);
    precise vec3 direction = p * light.w - light.xyz;
    vec3 inView = viewFromModel(instance, vec4(p, 1.0)), away = viewFromModel(instance, vec4(direction, 0.0));
    vec4 face = extentFaces[end - 1u];
    precise vec3 q = inView + (face.w - dot(face.xyz, inView)) / dot(face.xyz, away) * away;
    return clipFromView(q, 1.0);
}

/// m > 0: the light-oriented surface runs from a to b, so outward is (a, a', b', b); m < 0: (a, b, b', a').
bool runsReversed(uint instance, bool negative) {
    return negative != ((instances[instance].flags & INSTANCE_MIRRORED) != 0u);
}

void setCorner(uint instance, Edge edge, bool far, bool second) {
    uint vertex = second ? edge.b : edge.a;
    vec4 light = lightOf(instance);
    gl_Position = far ? farEnd(instance, vertex, light) : nearEnd(instance, vertex);
#ifdef TALLY
    caster = instance;
#endif
#ifdef EDGE_ON
    nearA = nearEnd(instance, edge.a);
    farA = farEnd(instance, edge.a, light);
    nearB = nearEnd(instance, edge.b);
    farB = farEnd(instance, edge.b, light);
#endif
}

/// @param corner  0 to 3; triangles are 0 1 2 and 0 2 3
void setCorner(uint instance, Edge edge, bool negative, uint corner) {
    bool reversed = runsReversed(instance, negative);
    bool far = corner == 2u || corner == (reversed ? 3u : 1u);
    bool second = corner == 2u || corner == (reversed ? 1u : 3u);
    setCorner(instance, edge, far, second);
}
