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

/// What the polygon's borders have at a coordinate of the screen: the places across it where it begins and ends, each with
/// its depth, and the range of depths.
struct Section {
    vec2 begin, end;  // across, depth
    vec2 depth;       // from, to
    int crossings;
    bool isBounded;  // both ends are places on screen
};

/// Adds where a border p + t q (0 <= t <= last) crosses the pixel's coordinate along `axis`.
void crossBorder(inout Section section, vec4 p, vec4 q, float last, vec2 ndc, int axis) {
    if (q == vec4(0.0)) return;  // both ends in one point
    float t = (ndc[axis] * p.w - p[axis]) / (q[axis] - ndc[axis] * q.w);
    vec4 crossing = q.xyw == vec3(0.0) ? q : p + t * q;
    if (crossing.xyw == vec3(0.0)) {  // in the eye itself, or in line with an orthographic eye: anywhere on screen
        section.depth = crossing.z > 0.0 ? vec2(section.depth.x, 1.0) : vec2(0.0, section.depth.y);
        section.isBounded = false;
        ++section.crossings;
        return;
    }
    if (!(t >= 0.0 && t <= last && crossing.w >= 0.0)) return;  // also when t is no number; behind the eye is no crossing
    if (crossing.w == 0.0) {  // an orthographic eye sees the far border at infinity
        section.depth = crossing.z > 0.0 ? vec2(section.depth.x, 1.0) : vec2(0.0, section.depth.y);
        section.isBounded = false;
        ++section.crossings;
        return;
    }
    vec2 here = vec2(crossing[1 - axis], crossing.z) / crossing.w;
    ++section.crossings;
    if (here.x < section.begin.x) section.begin = here;
    if (here.x > section.end.x) section.end = here;
    section.depth = vec2(min(section.depth.x, here.y), max(section.depth.y, here.y));
}

void holdDepth() {
    vec2 ndc = 1.0 / VIEWPORT_SCALE * vec2(gl_FragCoord.x * view.pixelSize.x - 1.0, 1.0 - gl_FragCoord.y * view.pixelSize.y);
    vec2 along = abs(farA.xy - ndc * farA.w) + abs(farB.xy - ndc * farB.w);
    int axis = along.x > along.y ? 0 : 1;  // the one a sliver runs along
    Section section = Section(vec2(1e30, 0.0), vec2(-1e30, 0.0), vec2(2.0, -1.0), 0, true);
    crossBorder(section, nearA, farA, 1e30, ndc, axis);
    crossBorder(section, nearB, farB, 1e30, ndc, axis);
    crossBorder(section, nearA, nearB - nearA, 1.0, ndc, axis);
    crossBorder(section, farA, farB - farA, 1.0, ndc, axis);
    float depth = gl_FragCoord.z;
#ifdef PUSHED_BACK
    // As RasterState::pushedBack.
    depth -= max(abs(dFdx(gl_FragCoord.z)), abs(dFdy(gl_FragCoord.z))) / 256.0 + 4.76837158203125e-7 * depth;
#endif
    // Before the near plane nearer than all; with a corner in the eye there is no number to compare.
    if (!(gl_FragCoord.z < 1.0)) depth = 1.0;
    // Between two borders lies all of the polygon at this coordinate.
    if (section.crossings < 2) {
        gl_FragDepth = depth;
        return;
    }
    float width = section.end.x - section.begin.x;
#ifdef PUSHED_BACK
    // Caps compare with surfaces that are interpolated as they are, so only slivers are held.
    gl_FragDepth = VIEWPORT_SCALE * width < view.pixelSize[1 - axis] ? clamp(depth, section.depth.x, section.depth.y) : depth;
#else
    // Where both are places on screen their depths say all, better than corners that were snapped.
    float along01 = clamp((ndc[1 - axis] - section.begin.x) / width, 0.0, 1.0);
    gl_FragDepth = section.isBounded && width > 0.0 ? mix(section.begin.y, section.end.y, along01) : clamp(depth, section.depth.x, section.depth.y);
#endif
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
