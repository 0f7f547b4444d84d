// SPDX-License-Identifier: Apache-2.0
// Data AOVs from the G-buffer. DATA 0: depth and normal, of the first sample; DATA 1: the shadow mask of four lights,
// the share of samples that the light reaches.
// variant: DATA 1
// variant: SAMPLES 4
#version 450 core
#extension GL_GOOGLE_include_directive : require
#ifndef DATA
#define DATA 0
#endif
#if DATA == 0
#define FIRST_SAMPLE  // data is never averaged
#endif
#include "gbuffer.glsl"
#include "lights.glsl"

layout(location = 0) out vec4 outData;
layout(location = 2) uniform uint firstLight;
layout(location = 3) uniform mat3 worldFromView;

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    float depth = texelFetch(depthTexture, at, gbufferSample).r;
    outData = vec4(0.0);
#if DATA == 0
    outData.w = uintBitsToFloat(0x7f800000u);  // background: infinitely far
#endif
    if (depth == view.emptyDepth) return;
    uint triangle = texelFetch(triangleTexture, at, gbufferSample).r;
    vec2 ndc = ndcHere();
    float e = eyeDistance(triangle, depth, ndc);
#if DATA == 0
    outData = vec4(worldFromView * unitFromOctahedron(texelFetch(normalTexture, at, gbufferSample).rg), e);
#else
    vec3 p = viewPositionAt(e, ndc);
    uint reaching = reachingLights(triangle, firstLight / LIGHTS_PER_GROUP, p);
    for (uint i = 0u; i < 4u; ++i) {
        uint light = firstLight + i;
        if (light >= view.lightCount || (reaching >> (light % LIGHTS_PER_GROUP) & 1u) == 0u) continue;
        vec3 l;
        if (arriving(lights[light], p, l) > 0.0) outData[i] = 1.0;
    }
#endif
}
