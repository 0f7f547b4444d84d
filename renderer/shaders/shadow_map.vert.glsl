// SPDX-License-Identifier: Apache-2.0
// Casters as a light sees them (Williams 1978), from the same positions as the picture.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "geometry.glsl"

layout(std430, binding = BIND_DRAWS) readonly buffer Draws { DrawData draws[]; };

layout(location = 0) in vec3 position;
layout(location = 6) in uint draw;  // advances with the base instance
layout(location = 0) uniform mat4 mapFromView;

void main() { gl_Position = mapFromView * vec4(viewFromModel(draws[draw].instance, vec4(position, 1.0)), 1.0); }
