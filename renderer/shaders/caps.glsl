// SPDX-License-Identifier: Apache-2.0
// Which triangles a draw of caps is for, and which way round they are.
#include "volume_end.glsl"

layout(std430, binding = BIND_TRIANGLE_FLAGS) readonly buffer TriangleFlags { uint triangleFlags[]; };
layout(std430, binding = BIND_TRIANGLE_CHUNKS) readonly buffer TriangleChunks { uint triangleChunks[]; };
layout(std430, binding = BIND_FACING) readonly buffer Facing { uvec2 facing[]; };
layout(std430, binding = BIND_PLANES) readonly buffer Planes { vec4 planes[]; };

layout(location = 2) uniform uint facingBase;
layout(location = 3) uniform uint lightBit;   // of this group
layout(location = 4) uniform uint cap;
layout(location = 5) uniform uint byFail;     // draw the casters counted by z-fail, or the others

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
    if (cap == CAP_DARK || cap == CAP_SECTION || cap == CAP_LIGHT_VIEW) return true;
    if (inDepthBuffer(instance, flags)) return cap == CAP_FAR;
    if (cap == CAP_FAR) return false;
    return seenEdgeOn(instance, placed, positionOf(vertices.x)) == (cap == CAP_EDGE_ON);
}

struct CapTriangle {
    uint instance;
    uvec3 vertices;
    bool flip;  // outward is (a, c, b)
};

/// Whether this draw is for the triangle; then `found` says which it is.
bool findCap(uint placed, out CapTriangle found) {
    uint instance = triangleChunks[placed >> CHUNK_SHIFT];
    uint triangle = placed - instances[instance].placedTriangleBase;
    if (triangle >= instances[instance].triangleCount) return false;
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
    if (!counted || fails != (byFail != 0u)) return false;
    found.instance = instance;
    found.vertices = triangleVertices(instance, triangle);
    found.flip = (side.y != 0u) != ((instances[instance].flags & INSTANCE_MIRRORED) != 0u);
    return isWanted(instance, placed, flags, found.vertices);
}
