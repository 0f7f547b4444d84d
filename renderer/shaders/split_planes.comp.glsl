// SPDX-License-Identifier: Apache-2.0
// Split planes of all parts of all lights of a group, by the formulas of shadow/split_plane.cpp, in view space: the eye
// is at the origin or looks along -z.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "shared.h"
#include "view.glsl"

layout(local_size_x = CHUNK_SIZE) in;

layout(std430, binding = BIND_LIGHTS) readonly buffer Lights { LightData lights[]; };
layout(std430, binding = BIND_PARTS) buffer Parts { SplitPart parts[]; };

layout(location = 0) uniform uint partCount;  // of all lights of the group
layout(location = 1) uniform uint partsPerLight;
layout(location = 2) uniform uint firstLight;

vec3 towards(vec4 to, vec3 from) { return to.w == 0.0 ? to.xyz : to.xyz - from; }

vec4 onScreen(vec4 plane) {
    if (view.perspective != 0u) {
        return vec4(plane.xy * view.rayScale.xy, plane.w / view.znear, -plane.z);
    }
    return vec4(plane.xy * view.rayScale.xy, plane.z * (view.zfar - view.znear), plane.w - plane.z * view.zfar);
}

void main() {
    uint part = GROUP_HERE * CHUNK_SIZE + gl_LocalInvocationID.x;
    if (part >= partCount) return;
    vec4 p = parts[part].points[0], q = parts[part].points[1];
    vec3 light = normalize(towards(lights[firstLight + part / partsPerLight].position, p.xyz));
    vec3 eye = view.perspective != 0u ? -p.xyz : vec3(0.0, 0.0, 1.0);
    vec3 normal = q.w == SPLIT_POINT_POINT ? cross(q.xyz - p.xyz, light) : cross(cross(eye, light), light);
    vec4 plane = onScreen(vec4(normal, -dot(normal, p.xyz)));
    // With reversed depth the eye is at (0, 0, +1, 0) on screen.
    parts[part].plane = q.w == SPLIT_NOWHERE ? vec4(0.0, 0.0, 0.0, 1.0)
                        : plane.z < 0.0 ? -plane : plane.z > 0.0 ? plane : vec4(0.0);
}
