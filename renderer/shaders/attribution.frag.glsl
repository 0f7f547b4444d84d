// SPDX-License-Identifier: Apache-2.0
// How often the volumes of each of a few casters touch each pixel: one channel a caster.
// variant: TALLY 1
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "shared.h"

layout(std430, binding = BIND_FILL) readonly buffer Ranks { uint ranks[]; };  // per instance: its channel

layout(location = 4) flat in uint caster;

layout(location = 0) out vec4 outFirst;
layout(location = 1) out vec4 outSecond;
layout(location = 2) out vec4 outThird;

void main() {
    uint rank = ranks[caster];
    if (rank >= ATTRIBUTED) discard;
    vec4 one = vec4(equal(uvec4(rank & 3u), uvec4(0u, 1u, 2u, 3u)));
    outFirst = rank < 4u ? one : vec4(0.0);
    outSecond = rank >= 4u && rank < 8u ? one : vec4(0.0);
    outThird = rank >= 8u ? one : vec4(0.0);
}
