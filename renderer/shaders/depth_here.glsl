// SPDX-License-Identifier: Apache-2.0
// The depth of what is seen, where a shader looks at it: no depth buffer is attached then, or it is a copy.
#ifndef SAMPLES
#define SAMPLES 1
#endif
#if SAMPLES > 1
layout(binding = 0) uniform sampler2DMS depthTexture;
float depthHere() { return texelFetch(depthTexture, ivec2(gl_FragCoord.xy), gl_SampleID).r; }
#else
layout(binding = 0) uniform sampler2D depthTexture;
float depthHere() { return texelFetch(depthTexture, ivec2(gl_FragCoord.xy), 0).r; }
#endif
