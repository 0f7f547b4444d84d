// SPDX-License-Identifier: Apache-2.0
// Masks that somebody else has found, into the mask texture: the judge shades with the exact ones.
// variant: SAMPLES 4
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "shared.h"
#ifndef SAMPLES
#define SAMPLES 1
#endif

layout(location = 0) out uint outMask;
layout(location = 0) uniform uvec2 size;
layout(std430, binding = BIND_QUADS) readonly buffer Given { uint given[]; };  // sample after sample, rows of each

void main() {
#if SAMPLES > 1
    uint plane = uint(gl_SampleID);
#else
    uint plane = 0u;
#endif
    uvec2 at = uvec2(gl_FragCoord.xy);
    outMask = given[(plane * size.y + at.y) * size.x + at.x];
}
