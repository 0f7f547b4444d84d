// SPDX-License-Identifier: Apache-2.0
// Light and dark caps of shadow volumes, for the cases in which they count (T1):
//   CAP_TRUE  at their own depth: triangles that may be missing from the depth buffer where they are nearest
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

out gl_PerVertex { invariant vec4 gl_Position; };

/// Whether the depth buffer surely holds it wherever it is the nearest. Of a caster some of which is missing that is not
/// sure even of the faces turned to the eye: the rasteriser culls slivers by their snapped corners. A cap at its own
/// depth that is in the depth buffer after all hides nothing (see VolumeRenderer::drawCap).
bool inDepthBuffer(uint instance, uint flags) {
    return (flags & TRIANGLE_HOLED) == 0u && casters[instance].missing == 0u;
}

void main() {
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0);  // outside: dropped
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

    bool visible = cap == CAP_DARK || inDepthBuffer(instance, flags) == (cap == CAP_FAR);
    if (!visible) return;
    bool flip = (side.y != 0u) != ((instances[instance].flags & INSTANCE_MIRRORED) != 0u);  // outward is (a, c, b)
    if (flip != (cap == CAP_DARK)) corner = 2u - corner;
    vec3 p = positionOf(triangleVertices(instance, triangle)[corner]);
    if (cap == CAP_DARK) {
        vec4 light = lightsInModel[instance * totalLights + lightIndex];
        precise vec3 direction = p * light.w - light.xyz;
        gl_Position = clipFromView(viewFromModel(instance, vec4(direction, 0.0)), 0.0);
        return;
    }
    gl_Position = clipFromView(viewFromModel(instance, vec4(p, 1.0)), 1.0);
    if (cap == CAP_FAR) gl_Position.z = 0.0;
}
