// SPDX-License-Identifier: Apache-2.0
// A vertex's positions: relative to the camera, which is what is drawn, and in the space of its instance, from which
// light takes its direction. From the latter alone the ends of sides are bit by bit those of dark caps.
#version 450 core
#extension GL_GOOGLE_include_directive : require

layout(location = 0) flat in vec3 inView;
layout(location = 1) flat in vec3 inModel;

layout(location = 0) out vec4 outInView;
layout(location = 1) out vec4 outInModel;

void main() {
    outInView = vec4(inView, 1.0);
    outInModel = vec4(inModel, 1.0);
}
