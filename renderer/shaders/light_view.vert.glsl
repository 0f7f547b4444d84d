// SPDX-License-Identifier: Apache-2.0
// Casters as the light sees them against the picture's rectangle in the near plane (Hornus et al. 2005), one triangle a
// layer. With g(p) = -p.z - znear p.w, p g(L) - L g(p) is where the line from the light through p meets the plane: for
// a directional light an oblique parallel projection, and from either side of the plane, where s is the sign of g(L).
// What is beyond the plane or behind the light is clipped.
// variant: TALLY 1
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "caps.glsl"

out gl_PerVertex { invariant vec4 gl_Position; };

float beyond(vec4 p) { return -p.z - view.znear * p.w; }

void main() {
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0);  // outside: dropped
    CapTriangle triangle;
    if (!findCap(uint(gl_VertexID) / 3u, triangle)) return;
    vec4 inModel = lightOf(triangle.instance);
    vec4 light = vec4(viewFromModel(triangle.instance, inModel), inModel.w);
    float s = beyond(light) < 0.0 ? -1.0 : 1.0;
    // What faces the light faces the eye where it enters the picture's volume: seen from behind when the light is there.
    uint corner = uint(gl_VertexID) % 3u;
    if (triangle.flip != (s > 0.0)) corner = 2u - corner;
    vec4 p = vec4(viewFromModel(triangle.instance, vec4(positionOf(triangle.vertices[corner]), 1.0)), 1.0);
    vec4 onPlane = s * (p * beyond(light) - light * beyond(p));
    vec4 clip = clipFromView(vec3(onPlane.xy, -view.znear * onPlane.w), onPlane.w);
    // From 0 in the plane, whose sign is exact, to the light but for a millionth.
    gl_Position = vec4(clip.xy, 9.5367431640625e-7 * view.znear * s * beyond(p), clip.w);
}
