// SPDX-License-Identifier: Apache-2.0
// One for every fragment, to be added up: signed as the crossing it is (T6: wide counters), or as a tally (overdraw).
// variant: SIGNED 1
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "shared.h"
layout(early_fragment_tests) in;
layout(location = 0) out vec4 outCount;
#ifdef SIGNED
layout(location = COUNT_FRONT_VALUE) uniform float frontValue;  // +1 for z-pass, -1 for z-fail
void main() { outCount = vec4(gl_FrontFacing ? frontValue : -frontValue); }
#else
void main() { outCount = vec4(1.0); }
#endif
