// SPDX-License-Identifier: Apache-2.0
// The one set of positions and how every stage takes them to the screen. `precise`: the same expression gives the
// same bits in every shader, whatever the compiler contracts (docs/rules.md, R2).
#include "shared.h"

layout(std430, binding = BIND_POSITIONS) readonly buffer Positions { float positions[]; };
layout(std430, binding = BIND_INDICES) readonly buffer Indices { uint indices[]; };
layout(std430, binding = BIND_INSTANCES) readonly buffer Instances { InstanceData instances[]; };

vec3 positionOf(uint vertex) {
    return vec3(positions[3u * vertex], positions[3u * vertex + 1u], positions[3u * vertex + 2u]);
}

/// Of a point (w = 1) or a direction (w = 0) of an instance's model space.
vec3 viewFromModel(uint instance, vec4 p) {
    precise vec3 v;
    v.x = dot(instances[instance].viewFromModel[0], p);
    v.y = dot(instances[instance].viewFromModel[1], p);
    v.z = dot(instances[instance].viewFromModel[2], p);
    return v;
}

uvec3 triangleVertices(uint instance, uint triangle) {
    uint base = 3u * (instances[instance].triangleBase + triangle);
    return uvec3(indices[base], indices[base + 1u], indices[base + 2u]) + instances[instance].vertexBase;
}
