// SPDX-License-Identifier: Apache-2.0
// A part's crossings, signed, to be added up: those before what is seen where it is counted by z-pass, the others where
// by z-fail.
// variant: SAMPLES 4
// variant: EDGE_ON 1
// variant: EDGE_ON 1, PUSHED_BACK 1
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "shared.h"
#ifdef EDGE_ON
#include "held_depth.glsl"
#else
float heldDepth() { return gl_FragCoord.z; }
#endif
#include "depth_here.glsl"
#include "split.glsl"

layout(location = 5) flat in uint part;
layout(location = COUNT_FRONT_VALUE) uniform float frontValue;  // crossings that a fragment stands for
layout(location = 0) out vec4 outCount;

void main() {
    float depth = depthHere();
    bool passed = clamp(heldDepth(), 0.0, 1.0) > depth;
    bool byPass = countsByPass(part, depth);
    if (passed != byPass) discard;
    outCount = vec4(gl_FrontFacing == byPass ? frontValue : -frontValue);
}
