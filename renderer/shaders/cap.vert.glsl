// SPDX-License-Identifier: Apache-2.0
// Light and dark caps of shadow volumes, for the cases in which they count (T1):
//   CAP_TRUE     at their own depth: triangles that may be missing from the depth buffer where they are nearest
//   CAP_EDGE_ON  those of them that are seen nearly edge-on (see count.frag.glsl)
//   CAP_FAR      all others at infinite depth, where they always fail, whatever rounding does (z-fail)
//   CAP_DARK     the projection to infinity (z-fail)
// variant: EDGE_ON 1
// variant: TALLY 1, EDGE_ON 1
// variant: TALLY 1
// variant: PARTS 1, TALLY 1
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "corners.glsl"

layout(std430, binding = BIND_TRIANGLE_FLAGS) readonly buffer TriangleFlags { uint triangleFlags[]; };
layout(std430, binding = BIND_TRIANGLE_CHUNKS) readonly buffer TriangleChunks { uint triangleChunks[]; };
layout(std430, binding = BIND_LIGHTS_IN_MODEL) readonly buffer LightsInModel { vec4 lightsInModel[]; };
layout(std430, binding = BIND_FACING) readonly buffer Facing { uvec2 facing[]; };
layout(std430, binding = BIND_CASTERS) readonly buffer Casters { CasterState casters[]; };
layout(std430, binding = BIND_PLANES) readonly buffer Planes { vec4 planes[]; };

layout(location = 0) uniform uint lightIndex;
layout(location = 1) uniform uint totalLights;
layout(location = 2) uniform uint facingBase;
layout(location = 3) uniform uint lightBit;   // of this group
layout(location = 4) uniform uint cap;
layout(location = 5) uniform uint byFail;     // draw the casters counted by z-fail, or the others

out gl_PerVertex { invariant vec4 gl_Position; };

/// Whether the depth buffer surely holds it wherever it is the nearest. Of a caster some of which is missing that is not
/// sure even of the faces turned to the eye: the rasteriser culls slivers by their snapped corners. A cap at its own
/// depth that is in the depth buffer after all hides nothing (see VolumeRenderer::drawCap).
bool inDepthBuffer(uint instance, uint flags) {
    return (flags & TRIANGLE_HOLED) == 0u && casters[instance].missing == 0u;
}

/// @param p  a corner, in model space
bool seenEdgeOn(uint instance, uint placed, vec3 p) {
    vec4 plane = planes[placed];
    if (view.perspective == 0u) return abs(plane.z) < EDGE_ON_SINE;
    return abs(plane.w) < EDGE_ON_SINE * length(viewFromModel(instance, vec4(p, 1.0)));
}

/// Whether this draw is for the triangle.
bool isWanted(uint instance, uint placed, uint flags, uvec3 vertices) {
    if (cap == CAP_DARK) return true;
    if (inDepthBuffer(instance, flags)) return cap == CAP_FAR;
    if (cap == CAP_FAR) return false;
    return seenEdgeOn(instance, placed, positionOf(vertices.x)) == (cap == CAP_EDGE_ON);
}

void main() {
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0);  // outside: dropped
    uint placed = uint(gl_VertexID) / 3u;
    uint corner = uint(gl_VertexID) % 3u;
    uint instance = triangleChunks[placed >> CHUNK_SHIFT];
    uint triangle = placed - instances[instance].placedTriangleBase;
    if (triangle >= instances[instance].triangleCount) return;
#ifdef TALLY
    caster = instance;
#endif
#ifdef PARTS
    part = partOfTriangle(placed);
#endif
    uint flags = triangleFlags[instances[instance].triangleBase + triangle];
    uvec2 side = facing[facingBase + placed] & lightBit;
    bool counted = (flags & TRIANGLE_CASTS) != 0u && (side.x | side.y) != 0u;
    bool fails = (casters[instance].countedByFail & lightBit) != 0u;
    if (!counted || fails != (byFail != 0u)) return;

    uvec3 vertices = triangleVertices(instance, triangle);
    if (!isWanted(instance, placed, flags, vertices)) return;
    bool flip = (side.y != 0u) != ((instances[instance].flags & INSTANCE_MIRRORED) != 0u);  // outward is (a, c, b)
    if (flip != (cap == CAP_DARK)) corner = 2u - corner;
    vec3 p = positionOf(vertices[corner]);
    if (cap == CAP_DARK) {
        gl_Position = farCorner(instance, p, lightsInModel[instance * totalLights + lightIndex]);
        return;
    }
    gl_Position = nearCorner(instance, p);
#ifdef EDGE_ON
    nearA = nearCorner(instance, positionOf(vertices.x));
    nearB = nearCorner(instance, positionOf(vertices.y));
    farA = farB = nearCorner(instance, positionOf(vertices.z));
#endif
    if (cap == CAP_FAR) gl_Position.z = 0.0;
}
