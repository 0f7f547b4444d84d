// SPDX-License-Identifier: Apache-2.0
// Light and dark caps of shadow volumes, for the cases in which they count (T1):
//   CAP_NEAR  the part nearer than the near plane, which is not in the depth buffer; always passes (z-pass)
//   CAP_TRUE  triangles that are not in the depth buffer, at their own depth (z-pass and z-fail)
//   CAP_FAR   all others at infinite depth, where they always fail, whatever rounding does (z-fail)
//   CAP_DARK  the projection to infinity (z-fail)
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "geometry.glsl"
#include "view.glsl"

layout(std430, binding = BIND_TRIANGLE_FLAGS) readonly buffer TriangleFlags { uint triangleFlags[]; };
layout(std430, binding = BIND_TRIANGLE_CHUNKS) readonly buffer TriangleChunks { uint triangleChunks[]; };
layout(std430, binding = BIND_LIGHTS_IN_MODEL) readonly buffer LightsInModel { vec4 lightsInModel[]; };
layout(std430, binding = BIND_FACING) readonly buffer Facing { uvec2 facing[]; };
layout(std430, binding = BIND_CASTERS) readonly buffer Casters { CasterState casters[]; };

layout(location = 0) uniform uint lightIndex;
layout(location = 1) uniform uint totalLights;
layout(location = 2) uniform uint facingBase;
layout(location = 3) uniform uint lightBit;   // of this group
layout(location = 4) uniform uint cap;
layout(location = 5) uniform uint byFail;     // draw the casters counted by z-fail, or the others
layout(location = 6) uniform uint clockwise;  // CAP_TRUE only: draw the triangles whose outward cap is clockwise

out gl_PerVertex {
    invariant vec4 gl_Position;
    float gl_ClipDistance[1];
};

/// Whether the depth buffer surely holds it wherever it is the nearest. Of an exposed caster that is not even sure of
/// the faces turned to the eye: the rasteriser culls slivers by their snapped corners. At its own depth a cap that is
/// in the depth buffer after all has the same depth, is not nearer, and counts as it should.
bool inDepthBuffer(uint instance, uint flags) {
    return (flags & TRIANGLE_HOLED) == 0u && casters[instance].exposed == 0u;
}

void main() {
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0);  // outside: dropped
    gl_ClipDistance[0] = 1.0;
    uint placed = uint(gl_VertexID) / 3u;
    uint corner = uint(gl_VertexID) % 3u;
    uint instance = triangleChunks[placed >> CHUNK_SHIFT];
    uint triangle = placed - instances[instance].placedTriangleBase;
    if (triangle >= instances[instance].triangleCount) return;
    uint flags = triangleFlags[instances[instance].triangleBase + triangle];
    uvec2 side = facing[facingBase + placed] & lightBit;
    bool counted = (flags & TRIANGLE_CASTS) != 0u && (side.x | side.y) != 0u;
    bool fails = (casters[instance].countedByFail & lightBit) != 0u;
    if (!counted || fails != (byFail != 0u)) return;

    bool visible = cap == CAP_NEAR || cap == CAP_DARK || inDepthBuffer(instance, flags) == (cap == CAP_FAR);
    bool flip = (side.y != 0u) != ((instances[instance].flags & INSTANCE_MIRRORED) != 0u);  // outward is (a, c, b)
    if (!visible || (cap == CAP_TRUE && flip != (clockwise != 0u))) return;
    // CAP_TRUE keeps the order in which the surface itself was drawn, so that both have the same depth to the bit.
    if (cap == CAP_DARK) flip = !flip;
    if (flip && cap != CAP_TRUE) corner = 2u - corner;
    vec3 p = positionOf(triangleVertices(instance, triangle)[corner]);
    if (cap == CAP_DARK) {
        vec4 light = lightsInModel[instance * totalLights + lightIndex];
        precise vec3 direction = p * light.w - light.xyz;
        gl_Position = clipFromView(viewFromModel(instance, vec4(direction, 0.0)), 0.0);
        return;
    }
    vec3 inView = viewFromModel(instance, vec4(p, 1.0));
    gl_Position = clipFromView(inView, 1.0);
    if (cap == CAP_FAR) gl_Position.z = 0.0;
    // CAP_TRUE is clipped as the surface itself was, so that depths agree to the bit.
    gl_ClipDistance[0] = cap == CAP_TRUE ? beforeFar(inView) : cap == CAP_NEAR ? -beyondNear(inView) : beyondNear(inView);
}
