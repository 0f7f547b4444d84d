// SPDX-License-Identifier: Apache-2.0
// A triangle with one edge through the centres of pixels, in a picture of 4 x 4: to the right of column 1, or below row 1.
#version 450 core
#extension GL_GOOGLE_include_directive : require
layout(location = 0) uniform uint below;

void main() {
    const vec2 corners[3] = vec2[](vec2(-0.125, -2.0), vec2(-0.125, 2.0), vec2(4.0, 0.0));
    vec2 corner = corners[gl_VertexID];
    gl_Position = vec4(below != 0u ? vec2(corner.y, -corner.x) : corner, 0.0, 1.0);
}
