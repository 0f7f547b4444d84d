// SPDX-License-Identifier: Apache-2.0
// One triangle that covers the image, at infinite depth. No buffers.
#version 450 core
#extension GL_GOOGLE_include_directive : require
void main() { gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0); }
