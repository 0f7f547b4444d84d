// SPDX-License-Identifier: Apache-2.0
// AOVs from the G-buffer: the AOV's name in capitals (job/aovs.h) says which. FIRST_SAMPLE: data is never averaged.
// variant: AOV_NORMALANDDEPTH 1
// variant: AOV_GEOMETRICNORMAL 1
// variant: AOV_POSITION 1
// variant: AOV_ALBEDO 1
// variant: AOV_SURFACE 1
// variant: AOV_LIGHT 1
// variant: AOV_AMBIENT 1
// variant: AOV_EMISSIVE 1
// variant: AOV_SHADOW 1
// variant: SAMPLES 4
// variant: FIRST_SAMPLE 1
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "gbuffer.glsl"
#include "lights.glsl"
#include "seen.glsl"

layout(location = 0) out vec4 outData;
layout(location = 2) uniform uint firstLight;
layout(location = 3) uniform mat4 worldFromView;

vec4 background() {
#if defined(AOV_NORMALANDDEPTH)
    return vec4(vec3(0.0), uintBitsToFloat(0x7f800000u));  // infinitely far
#elif defined(AOV_EMISSIVE)
    return view.background;
#else
    return vec4(0.0);
#endif
}

/// @param e  distance along the view axis
vec4 valueOf(ivec2 at, uint triangle, vec4 properties, float e, vec3 p) {
    bool lit = properties.w > 0.5;
#if defined(AOV_NORMALANDDEPTH) || defined(AOV_GEOMETRICNORMAL)
    vec3 n = unitFromOctahedron(texelFetch(normalTexture, at, gbufferSample).rg);
#ifdef AOV_GEOMETRICNORMAL
    vec4 plane = triangle == NO_TRIANGLE ? vec4(0.0) : planes[triangle];
    plane.xyz /= max(max(abs(plane.x), abs(plane.y)), max(abs(plane.z), 1e-30));  // squares of small ones would vanish
    bool seenFront = view.perspective != 0u ? plane.w > 0.0 : plane.z > 0.0;
    if (plane.xyz != vec3(0.0)) n = normalize(seenFront ? plane.xyz : -plane.xyz);
#endif
    return vec4(mat3(worldFromView) * n, e);
#elif defined(AOV_POSITION)
    return worldFromView * vec4(p, 1.0);
#elif defined(AOV_ALBEDO)
    return lit ? texelFetch(baseColorTexture, at, gbufferSample) : texelFetch(emissiveTexture, at, gbufferSample);
#elif defined(AOV_SURFACE)
    return lit ? vec4(properties.yx, 0.0, 0.0) : vec4(0.0);
#elif defined(AOV_LIGHT)
    uint reaching = reachingLights(triangle, firstLight / LIGHTS_PER_GROUP, p);
    vec3 l;
    float strength = arriving(lights[firstLight], p, l);
    if (!lit || (reaching >> (firstLight % LIGHTS_PER_GROUP) & 1u) == 0u || !(strength > 0.0)) return vec4(0.0);
    return vec4(strength * lights[firstLight].color.rgb * reflectance(shadingAt(at, properties, p), l), 0.0);
#elif defined(AOV_AMBIENT)
    Shading s = shadingAt(at, properties, p);
    return lit ? vec4(ambient(s.baseColor, properties.z, s.n), 0.0) : vec4(0.0);
#elif defined(AOV_EMISSIVE)
    return texelFetch(emissiveTexture, at, gbufferSample);
#elif defined(AOV_SHADOW)
    // Of four lights: the share of samples that each reaches.
    uint reaching = reachingLights(triangle, firstLight / LIGHTS_PER_GROUP, p);
    vec4 shadow = vec4(0.0);
    for (uint i = 0u; i < 4u; ++i) {
        uint light = firstLight + i;
        if (light >= view.lightCount || (reaching >> (light % LIGHTS_PER_GROUP) & 1u) == 0u) continue;
        vec3 l;
        if (arriving(lights[light], p, l) > 0.0) shadow[i] = 1.0;
    }
    return shadow;
#else
    return vec4(0.0);
#endif
}

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    float depth = texelFetch(depthTexture, at, gbufferSample).r;
    outData = background();
    if (depth == view.emptyDepth) return;
    uint triangle = texelFetch(triangleTexture, at, gbufferSample).r;
    vec2 ndc = ndcHere();
    float e = eyeDistance(triangle, depth, ndc);
    outData = valueOf(at, triangle, texelFetch(propertiesTexture, at, gbufferSample), e, viewPositionAt(e, ndc));
}
