// SPDX-License-Identifier: Apache-2.0
// One for every fragment, to be added up: signed as the crossing it is (T6: wide counters), or as a tally (overdraw).
//
// With EDGE_ON, for side quads that are seen nearly edge-on: a sliver on screen, snapped to the rasteriser's grid, covers
// pixels whose centres the true quad misses, and there interpolation carries its steep depth far beyond its own range,
// to the wrong side of what is seen (found as single wrong pixels with the eye exactly in a quad's plane, where neither
// z-pass nor z-fail helps). So the depth is held between those of the quad's two lateral lines at this place.
// variant: SIGNED 1
// variant: EDGE_ON 1
// variant: STENCIL_ONLY 1
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "shared.h"
#ifdef EDGE_ON
#include "view.glsl"
layout(location = 0) flat in vec4 nearA;
layout(location = 1) flat in vec4 farA;
layout(location = 2) flat in vec4 nearB;
layout(location = 3) flat in vec4 farB;

/// Depth of the line near + t far (t >= 0) where it passes the pixel, measured along the axis it runs along.
float depthOfLine(vec4 near, vec4 far, vec2 ndc) {
    vec2 slope = far.xy - ndc * far.w, offset = ndc * near.w - near.xy;
    float t = abs(slope.x) > abs(slope.y) ? offset.x / slope.x : offset.y / slope.y;
    t = t > 0.0 ? min(t, 1e30) : 0.0;
    float w = near.w + t * far.w;
    return w > 0.0 ? clamp((near.z + t * far.z) / w, 0.0, 1.0) : 1.0;
}

void holdDepth() {
    vec2 ndc = vec2(gl_FragCoord.x * view.pixelSize.x - 1.0, 1.0 - gl_FragCoord.y * view.pixelSize.y);
    float a = depthOfLine(nearA, farA, ndc), b = depthOfLine(nearB, farB, ndc);
    gl_FragDepth = clamp(gl_FragCoord.z, min(a, b), max(a, b));
}
#else
layout(early_fragment_tests) in;
void holdDepth() {}
#endif
#ifdef STENCIL_ONLY
void main() { holdDepth(); }
#else
layout(location = 0) out vec4 outCount;
#ifdef SIGNED
layout(location = COUNT_FRONT_VALUE) uniform float frontValue;  // +1 for z-pass, -1 for z-fail
void main() {
    holdDepth();
    outCount = vec4(gl_FrontFacing ? frontValue : -frontValue);
}
#else
void main() {
    holdDepth();
    outCount = vec4(1.0);
}
#endif
#endif
