// SPDX-License-Identifier: Apache-2.0
// One sample of every pixel as the judge wants it: which triangle is seen there, and bits of the lights of one group that
// reach it.
// variant: SAMPLES 4
#version 450 core
#extension GL_GOOGLE_include_directive : require
#define CHOSEN_SAMPLE
#include "gbuffer.glsl"
#include "lights.glsl"

layout(location = 0) out uvec2 outSample;
layout(location = 2) uniform uint group;

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    float depth = texelFetch(depthTexture, at, gbufferSample).r;
    outSample = uvec2(NO_TRIANGLE, 0u);
    if (depth == view.emptyDepth) return;
    uint triangle = texelFetch(triangleTexture, at, gbufferSample).r;
    vec2 ndc = ndcHere();
    vec3 p = viewPositionAt(eyeDistance(triangle, depth, ndc), ndc);
    uint reaching = reachingLights(triangle, group, p);
    uint first = group * LIGHTS_PER_GROUP;
    uint count = min(view.lightCount - first, LIGHTS_PER_GROUP);
    for (uint i = 0u; i < count; ++i) {
        vec3 l;
        if (!(arriving(lights[first + i], p, l) > 0.0)) reaching &= ~(1u << i);
    }
    outSample = uvec2(triangle == NO_TRIANGLE ? LINE_OR_POINT : triangle, reaching);
}
