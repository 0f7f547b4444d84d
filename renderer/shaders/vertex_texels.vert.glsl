// SPDX-License-Identifier: Apache-2.0
// Brabec & Seidel 2003, section 4.1: every vertex, wherever what deforms has moved it, becomes a point at its own texel.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "geometry.glsl"
#include "texels.glsl"

layout(location = 0) uniform uint instance;
layout(location = 1) uniform uint firstTexel;  // of the instance
layout(location = 2) uniform uvec2 size;       // of the textures

layout(location = 0) flat out vec3 inView;
layout(location = 1) flat out vec3 inModel;

void main() {
    uint vertex = uint(gl_VertexID);
    inModel = positionOf(instances[instance].vertexBase + vertex);
    inView = viewFromModel(instance, vec4(inModel, 1.0));
    vec2 place = (vec2(texelOf(firstTexel + vertex)) + 0.5) / vec2(size);
    gl_Position = vec4(vec2(2.0, -2.0) * place + vec2(-1.0, 1.0), 0.0, VIEWPORT_SCALE);
}
