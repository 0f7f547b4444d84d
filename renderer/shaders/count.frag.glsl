// SPDX-License-Identifier: Apache-2.0
// One for every fragment, to be added up: signed as the crossing it is (T6: wide counters), or as a tally (overdraw).
//
// With EDGE_ON, for side quads and caps that are seen nearly edge-on: a sliver on screen, snapped to the rasteriser's
// grid, covers pixels whose centres the true polygon misses, and there interpolation carries its steep depth far beyond
// its own range, to the wrong side of what is seen (found as single wrong pixels with the eye exactly in the plane, where
// neither z-pass nor z-fail helps). So the depth is held between those of the polygon's own borders at this place.
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

/// Where a border p + t q (0 <= t <= last) crosses the pixel's coordinate along `axis`: widens `range` by the
/// depth there.
void crossBorder(inout vec2 range, inout int crossings, vec4 p, vec4 q, float last, vec2 ndc, int axis) {
    float t = (ndc[axis] * p.w - p[axis]) / (q[axis] - ndc[axis] * q.w);
    float w = p.w + t * q.w;
    if (!(t >= 0.0 && t <= last && w > 0.0)) return;  // also when t is no number; behind the eye is no crossing
    float depth = clamp((p.z + t * q.z) / w, 0.0, 1.0);
    range = vec2(min(range.x, depth), max(range.y, depth));
    ++crossings;
}

void holdDepth() {
    vec2 ndc = 1.0 / VIEWPORT_SCALE * vec2(gl_FragCoord.x * view.pixelSize.x - 1.0, 1.0 - gl_FragCoord.y * view.pixelSize.y);
    vec2 along = abs(farA.xy - ndc * farA.w) + abs(farB.xy - ndc * farB.w);
    int axis = along.x > along.y ? 0 : 1;  // the one a sliver runs along
    vec2 range = vec2(2.0, -1.0);
    int crossings = 0;
    crossBorder(range, crossings, nearA, farA, 1e30, ndc, axis);
    crossBorder(range, crossings, nearB, farB, 1e30, ndc, axis);
    crossBorder(range, crossings, nearA, nearB - nearA, 1.0, ndc, axis);
    crossBorder(range, crossings, farA, farB - farA, 1.0, ndc, axis);
    // Between two borders lies all of the polygon at this coordinate. With one it goes on to the eye's plane, or for an
    // orthographic eye to infinity.
    if (crossings == 1) range = view.perspective != 0u ? vec2(range.x, 1.0) : vec2(0.0, 1.0);
    gl_FragDepth = crossings > 0 ? clamp(gl_FragCoord.z, range.x, range.y) : gl_FragCoord.z;
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
