// SPDX-License-Identifier: Apache-2.0
// Fragments of shadow volumes counted, with the depth test made here so that one pass knows all of them: how often each
// pixel is touched and how often its count changes, and with TALLY whose volumes did it. No depth buffer is attached.
// variant: SAMPLES 4
// variant: TALLY 1
// variant: LIGHT_VIEW 1
// variant: EDGE_ON 1, PUSHED_BACK 1
// variant: PARTS 1, TALLY 1, EDGE_ON 1
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
#include "depth_here.glsl"
#ifdef PARTS
#include "split.glsl"
layout(location = 5) flat in uint part;
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
    float depth = depthHere();
    bool passed = clamp(heldDepth(), 0.0, 1.0) > depth, front = gl_FrontFacing, changes = passed != (failedCount != 0u);
#ifdef PARTS
    bool byPass = countsByPass(part, depth);
    changes = passed == byPass;
    front = gl_FrontFacing == byPass;  // it enters the volume on the way that is counted
    passed = changes;                  // a caster has both rules, so what is told apart is what they make of it
#endif
#ifdef TALLY
    if (front) {
        if (passed) atomicAdd(fill[caster].passedFront[kind], 1u);
        else atomicAdd(fill[caster].failedFront[kind], 1u);
    } else {
        if (passed) atomicAdd(fill[caster].passedBack[kind], 1u);
        else atomicAdd(fill[caster].failedBack[kind], 1u);
    }
#endif
    outFragments = vec4(1.0);
    outUpdates = vec4(changes ? 1.0 : 0.0);
}
