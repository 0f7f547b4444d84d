// SPDX-License-Identifier: Apache-2.0
// A line where it is not behind the first sample of what is seen. The target has one sample: lines are never averaged.
// variant: SAMPLES 4
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "depth_texture.glsl"

layout(location = 0) out vec4 outLine;

void main() {
    if (gl_FragCoord.z < texelFetch(depthTexture, ivec2(gl_FragCoord.xy), 0).r) discard;
    outLine = vec4(1.0);
}
