// SPDX-License-Identifier: Apache-2.0
// One sample of a multisampled count: counts are data and never averaged.
#version 450 core
#extension GL_GOOGLE_include_directive : require
layout(binding = 0) uniform sampler2DMS counts;
layout(location = 0) out vec4 outCount;
void main() { outCount = texelFetch(counts, ivec2(gl_FragCoord.xy), 0); }
