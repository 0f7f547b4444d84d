// SPDX-License-Identifier: Apache-2.0
// The depth of fragments of side quads and caps that are seen nearly edge-on. A sliver on screen, snapped to the
// rasteriser's grid, covers pixels whose centres the true polygon misses, and there interpolation carries its steep depth
// far beyond its own range, to the wrong side of what is seen (found as single wrong pixels with the eye exactly in the
// plane, where neither z-pass nor z-fail helps). So the depth is held between those of the polygon's own borders at this
// place.
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
    if (q == vec4(0.0)) return;                     // both ends in one point
    if (last == 1.0 && q.xyw == vec3(0.0)) return;  // or in one on screen, which the other borders have
    float t = (ndc[axis] * p.w - p[axis]) / (q[axis] - ndc[axis] * q.w);
    vec4 crossing = q.xyw == vec3(0.0) ? q : p + t * q;
    bool inEye = crossing.xyw == vec3(0.0);
    if (!inEye && !(t >= 0.0 && t <= last && crossing.w >= 0.0)) return;  // also when t is no number; not behind the eye
    ++section.crossings;
    if (crossing.w == 0.0) {  // in the eye or, for an orthographic eye, at infinity: no place on screen
        section.depth = crossing.z > 0.0 ? vec2(section.depth.x, 1.0) : vec2(0.0, section.depth.y);
        section.isBounded = false;
        return;
    }
    vec2 here = vec2(crossing[1 - axis], crossing.z) / crossing.w;
    if (here.x < section.begin.x) section.begin = here;
    if (here.x > section.end.x) section.end = here;
    section.depth = vec2(min(section.depth.x, here.y), max(section.depth.y, here.y));
}

/// The fragment's depth.
float heldDepth() {
    vec2 ndc = 1.0 / VIEWPORT_SCALE * vec2(gl_FragCoord.x * view.pixelSize.x - 1.0, 1.0 - gl_FragCoord.y * view.pixelSize.y);
    vec2 along = abs(farA.xy * nearA.w - nearA.xy * farA.w) + abs(farB.xy * nearB.w - nearB.xy * farB.w);
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
    if (section.crossings < 2) return depth;
    float width = section.end.x - section.begin.x;
#ifdef PUSHED_BACK
    // Caps compare with surfaces that are interpolated as they are, so only slivers are held.
    return VIEWPORT_SCALE * width < view.pixelSize[1 - axis] ? clamp(depth, section.depth.x, section.depth.y) : depth;
#else
    // Where both are places on screen their depths say all, better than corners that were snapped.
    if (!section.isBounded || width == 0.0) return clamp(depth, section.depth.x, section.depth.y);
    return mix(section.begin.y, section.end.y, clamp((ndc[1 - axis] - section.begin.x) / width, 0.0, 1.0));
#endif
}
