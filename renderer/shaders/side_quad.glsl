// SPDX-License-Identifier: Apache-2.0
// Corners of side quads, for every stage that makes them: an edge (a, b) and its projection from the light to where the
// volume ends. The diagonal always runs from a, where both triangles begin, to b's projection, so that coincident quads
// are cut alike (R6).
#include "volume_end.glsl"

/// An end of an edge and its projection. @param vertex  of the mesh
vec4 nearEnd(uint instance, uint vertex);
vec4 farEnd(uint instance, uint vertex, vec4 light);

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
