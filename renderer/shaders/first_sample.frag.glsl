// SPDX-License-Identifier: Apache-2.0
// One sample of a multisampled picture: counts and data are never averaged.
// variant: INTEGERS 1
#version 450 core
#extension GL_GOOGLE_include_directive : require
#ifdef INTEGERS
layout(binding = 0) uniform usampler2DMS samples;
layout(location = 0) out uvec4 outFirst;
#else
layout(binding = 0) uniform sampler2DMS samples;
layout(location = 0) out vec4 outFirst;
#endif
void main() { outFirst = texelFetch(samples, ivec2(gl_FragCoord.xy), 0); }
