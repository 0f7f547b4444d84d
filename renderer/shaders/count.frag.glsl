// SPDX-License-Identifier: Apache-2.0
// One for every fragment, to be added up: signed as the crossing it is (T6: wide counters), or as a tally (overdraw).
// With EDGE_ON, for what is seen nearly edge-on, see held_depth.glsl.
// variant: SIGNED 1
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
#ifdef SIGNED
layout(location = COUNT_FRONT_VALUE) uniform float frontValue;  // +1 for z-pass, -1 for z-fail
void main() {
    holdDepth();
    outCount = vec4(gl_FrontFacing ? frontValue : -frontValue);
}
#else
void main() {
    holdDepth();
    outCount = vec4(1.0);
}
#endif
#endif
