// SPDX-License-Identifier: Apache-2.0
// Fragments of shadow volumes counted, with the depth test made here so that one pass knows all of them: how often each
// pixel is touched and how often its count changes, and with TALLY whose volumes did it. No depth buffer is attached.
// variant: SAMPLES 4
// variant: TALLY 1
// variant: LIGHT_VIEW 1
// variant: EDGE_ON 1, PUSHED_BACK 1
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "shared.h"
#ifdef EDGE_ON
#include "held_depth.glsl"
#elif defined(LIGHT_VIEW)
float heldDepth() { return 2.0; }  // nearer than all
#else
float heldDepth() { return gl_FragCoord.z; }
#endif
#ifndef SAMPLES
#define SAMPLES 1
#endif
#if SAMPLES > 1
layout(binding = 0) uniform sampler2DMS depthTexture;
#define gbufferSample gl_SampleID
#else
layout(binding = 0) uniform sampler2D depthTexture;
#define gbufferSample 0
#endif

#ifdef TALLY
layout(std430, binding = BIND_FILL) buffer Fill { CasterFill fill[]; };
layout(location = 4) flat in uint caster;
#endif

layout(location = TALLY_KIND) uniform uint kind;
layout(location = TALLY_FAILED) uniform uint failedCount;  // those that fail the depth test change counts, or the others

layout(location = 0) out vec4 outFragments;
layout(location = 1) out vec4 outUpdates;

void main() {
    bool passed = clamp(heldDepth(), 0.0, 1.0) > texelFetch(depthTexture, ivec2(gl_FragCoord.xy), gbufferSample).r;
#ifdef TALLY
    if (gl_FrontFacing) {
        if (passed) atomicAdd(fill[caster].passedFront[kind], 1u);
        else atomicAdd(fill[caster].failedFront[kind], 1u);
    } else {
        if (passed) atomicAdd(fill[caster].passedBack[kind], 1u);
        else atomicAdd(fill[caster].failedBack[kind], 1u);
    }
#endif
    outFragments = vec4(1.0);
    outUpdates = vec4(passed != (failedCount != 0u) ? 1.0 : 0.0);
}
