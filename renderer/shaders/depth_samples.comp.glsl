// SPDX-License-Identifier: Apache-2.0
// The depth seen at the middle of each cell of a grid over the picture, rows from the top.
// variant: SAMPLES 4
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "shared.h"
#include "depth_texture.glsl"

layout(local_size_x = CHUNK_SIZE) in;

layout(std430, binding = BIND_FILL) writeonly buffer Depths { float depths[]; };
layout(location = 0) uniform uvec2 grid;
layout(location = 1) uniform uvec2 size;

void main() {
    uint i = GROUP_HERE * CHUNK_SIZE + gl_LocalInvocationID.x;
    if (i >= grid.x * grid.y) return;
    uvec2 cell = uvec2(i % grid.x, i / grid.x);
    depths[i] = texelFetch(depthTexture, ivec2((2u * cell + 1u) * size / (2u * grid)), 0).r;
}
