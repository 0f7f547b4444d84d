// SPDX-License-Identifier: Apache-2.0
// What a part's count starts from at every pixel: its layers over the end of the view ray that it is counted from there.
// variant: SAMPLES 4
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "shared.h"
#include "depth_here.glsl"
#include "split.glsl"

layout(location = 0) uniform uint part;
layout(location = 0) out vec4 outCount;

void main() {
    uint end = countsByPass(part, depthHere()) ? SPLIT_PASS : SPLIT_FAIL;
    outCount = vec4(float(parts[part].eyeInside[end]));
}
