// SPDX-License-Identifier: Apache-2.0
// The crossing that a fragment is, to be added up (T6: wide counters), or with STENCIL_ONLY only its depth. With EDGE_ON,
// for what is seen nearly edge-on, see held_depth.glsl. With PARTS only where the part that it belongs to
// is counted by the rule of this draw, see split.glsl.
// variant: PARTS 1, SAMPLES 4
// variant: PARTS 1, EDGE_ON 1
// variant: EDGE_ON 1
// variant: STENCIL_ONLY 1
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "shared.h"
#ifdef EDGE_ON
#include "held_depth.glsl"
void holdDepth() { gl_FragDepth = heldDepth(); }
#else
layout(early_fragment_tests) in;
void holdDepth() {}
#endif
#ifdef STENCIL_ONLY
void main() { holdDepth(); }
#else
layout(location = 0) out vec4 outCount;
layout(location = COUNT_FRONT_VALUE) uniform float frontValue;  // crossings it stands for; negative for z-fail
#ifdef PARTS
#include "depth_here.glsl"
#include "split.glsl"
layout(location = 5) flat in uint part;
bool isCounted() { return countsByPass(part, depthHere()) == (frontValue > 0.0); }
#else
bool isCounted() { return true; }
#endif
void main() {
    holdDepth();
    if (!isCounted()) discard;
    outCount = vec4(gl_FrontFacing ? frontValue : -frontValue);
}
#endif
