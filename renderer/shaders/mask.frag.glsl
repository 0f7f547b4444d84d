// SPDX-License-Identifier: Apache-2.0
// Sets a light's bit where the stencil test has found a count that is not zero. With COUNTS the count is in a texture
// (T6) and compared here, per sample.
// variant: COUNTS 1
// variant: COUNTS 4
#version 450 core
#extension GL_GOOGLE_include_directive : require
layout(location = 0) uniform uint bit;
layout(location = 0) out uint outMask;

#ifdef COUNTS
layout(location = 1) uniform float litCount;
#if COUNTS > 1
layout(binding = 0) uniform sampler2DMS counts;
#else
layout(binding = 0) uniform sampler2D counts;
#endif
#endif

void main() {
#ifdef COUNTS
#if COUNTS > 1
    float count = texelFetch(counts, ivec2(gl_FragCoord.xy), gl_SampleID).r;
#else
    float count = texelFetch(counts, ivec2(gl_FragCoord.xy), 0).r;
#endif
    if (count == litCount) discard;
#endif
    outMask = bit;
}
