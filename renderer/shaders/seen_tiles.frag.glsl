// SPDX-License-Identifier: Apache-2.0
// One sample of a multisampled G-buffer, for the tile counter: which triangle is seen there, and bits of its depth.
// variant: SAMPLES 4
#version 450 core
#extension GL_GOOGLE_include_directive : require
#define CHOSEN_SAMPLE
#include "gbuffer.glsl"

layout(location = 0) out uvec2 outSeen;

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    outSeen = uvec2(texelFetch(triangleTexture, at, gbufferSample).r,
                    floatBitsToUint(texelFetch(depthTexture, at, gbufferSample).r));
}
