// SPDX-License-Identifier: Apache-2.0
// Reading the G-buffer, one sample at a time. SAMPLES: 1, or the multisample textures' count.
#ifndef SAMPLES
#define SAMPLES 1
#endif
#include "octahedron.glsl"
#include "view.glsl"

#if SAMPLES > 1
#define FLOATS sampler2DMS
#define UINTS usampler2DMS
#define UINT_LAYERS usampler2DMSArray
#if defined(FIRST_SAMPLE)
#define gbufferSample 0
#elif defined(CHOSEN_SAMPLE)
layout(location = 4) uniform int gbufferSample;
#else
#define gbufferSample gl_SampleID
#endif
#else
#define FLOATS sampler2D
#define UINTS usampler2D
#define UINT_LAYERS usampler2DArray
#define gbufferSample 0
#endif
layout(binding = 0) uniform UINTS triangleTexture;
layout(binding = 1) uniform FLOATS baseColorTexture;
layout(binding = 2) uniform FLOATS normalTexture;
layout(binding = 3) uniform FLOATS propertiesTexture;
layout(binding = 4) uniform FLOATS emissiveTexture;
layout(binding = 5) uniform FLOATS depthTexture;
layout(binding = 6) uniform UINT_LAYERS maskTexture;  // layer: group of 32 lights; bit: not lit

layout(std430, binding = BIND_FACING) readonly buffer Facing { uvec2 facing[]; };
layout(std430, binding = BIND_PLANES) readonly buffer Planes { vec4 planes[]; };

layout(location = 1) uniform uint facingStride;  // words between two groups of lights

#if defined(CHOSEN_SAMPLE) || defined(FIRST_SAMPLE)
layout(location = 5) uniform vec2 samplePosition;  // in the pixel
#endif

/// Of the view ray, in NDC.
vec2 ndcHere() {
#if defined(CHOSEN_SAMPLE) || defined(FIRST_SAMPLE)
    vec2 at = floor(gl_FragCoord.xy) + samplePosition;
#elif SAMPLES > 1
    vec2 at = floor(gl_FragCoord.xy) + gl_SamplePosition;
#else
    vec2 at = gl_FragCoord.xy;
#endif
    return vec2(at.x * view.pixelSize.x - 1.0, 1.0 - at.y * view.pixelSize.y) + view.shift;  // row 0 is the top
}

/// Distance along the view axis at the sample. The triangle's plane is exact where interpolated depth has lost bits
/// (T9); the depth buffer keeps planes seen edge-on from running away.
float eyeDistance(uint triangle, float depth, vec2 ndc) {
    depth /= view.sceneDepths;
    float stored = view.perspective != 0u ? view.znear / depth : view.zfar - depth * (view.zfar - view.znear);
    if (triangle == NO_TRIANGLE) return stored;
    vec4 plane = planes[triangle];
    float e;
    if (view.perspective != 0u) {
        e = -plane.w / dot(plane.xyz, vec3(ndc * view.rayScale.xy, -1.0));
    } else {
        e = (dot(plane.xy, ndc * view.rayScale.xy) + plane.w) / plane.z;
    }
    float tolerance = abs(stored) * 0.00390625;
    return abs(e - stored) < tolerance ? e : stored;  // false for NaN as well
}

vec3 viewPositionAt(float e, vec2 ndc) {
    return view.perspective != 0u ? vec3(ndc * view.rayScale.xy * e, -e) : vec3(ndc * view.rayScale.xy, -e);
}

/// Bits of the lights of a group that the seen side of a triangle faces.
uint facedLights(uint triangle, uint group) {
    vec4 plane = planes[triangle];
    bool seenFront = view.perspective != 0u ? plane.w > 0.0 : plane.z > 0.0;
    uvec2 sides = facing[group * facingStride + triangle];
    return seenFront ? sides.x : sides.y;
}

/// Bits of the lights of a group that the seen side of the surface faces and whose shadow it is not in.
uint reachingLights(uint triangle, uint group, vec3 p) {
    if (triangle == NO_TRIANGLE) return 0u;
    return facedLights(triangle, group) & ~texelFetch(maskTexture, ivec3(gl_FragCoord.xy, group), gbufferSample).r;
}
