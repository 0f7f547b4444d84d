// SPDX-License-Identifier: Apache-2.0
// Caps of what near-cap counts, cut by the plane where it begins:
//   CAP_TRUE, CAP_EDGE_ON  as in cap.vert.glsl: triangles that may be missing from the depth buffer, beyond the plane
//   CAP_SECTION            where the volume behind a triangle passes through the plane
// The section's border is what the cut leaves open in the volume's five faces. Kilgard's cases come out of one rule: no
// ray from the light through a corner meets the plane (trivial, no section), all do (easy, a triangle), or some (hard,
// with directions in the plane as corners, or, where the triangle itself is cut, points of it).
// variant: EDGE_ON 1
// variant: TALLY 1, EDGE_ON 1
// variant: TALLY 1
// variant: TALLY 1, CASES 1
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "caps.glsl"
#include "cut.glsl"

#ifdef CASES
layout(std430, binding = BIND_FILL) buffer Fill { CasterFill fill[]; };
#endif

out gl_PerVertex { invariant vec4 gl_Position; };

// Of the volume: a, b, c, then a', b', c', in outward order; the fourth of a cap is its first again.
const int kFaces[5][4] = int[5][4](int[4](0, 3, 4, 1), int[4](1, 4, 5, 2), int[4](2, 5, 3, 0), int[4](0, 1, 2, 0),
                                   int[4](5, 4, 3, 5));

/// Corners of a section are named by the two corners of the volume they lie between.
ivec2 cutName(int one, int other) { return ivec2(min(one, other), max(one, other)); }

/// Where a face's border goes beyond the plane (`into`) and comes back (`out of`).
bool findCuts(Corner corners[6], int face, out ivec2 into, out ivec2 outOf) {
    bool any = false;
    int size = face < 3 ? 4 : 3;
    for (int i = 0; i < size; ++i) {
        int one = kFaces[face][i], other = kFaces[face][(i + 1) % size];
        if (isBeyond(corners[one]) == isBeyond(corners[other])) continue;
        any = true;
        if (isBeyond(corners[one])) outOf = cutName(one, other);
        else into = cutName(one, other);
    }
    return any;
}

vec4 clipOfCut(Corner corners[6], ivec2 name) { return clipOfCut(corners[name.x], corners[name.y]); }

/// The section as a fan around one of its corners: at most three triangles.
/// @return  whether it has that corner; into `position`
bool sectionCorner(Corner corners[6], uint wanted, uint corner, out vec4 position) {
    ivec2 pivot = ivec2(-1), into, outOf;
    uint found = 0u;
    for (int face = 0; face < 5; ++face) {
        if (!findCuts(corners, face, into, outOf)) continue;
        if (pivot.x < 0) {
            pivot = into;
            continue;
        }
        if (into == pivot || outOf == pivot || found++ != wanted) continue;
        position = clipOfCut(corners, corner == 0u ? pivot : (corner == 1u ? into : outOf));
        return true;
    }
    return false;
}

/// Whether the triangle's plane is beyond the other one all over the picture. Cut or not is the same there, and uncut the
/// triangle has the depths that it has where it is seen; those of a kilometre seen from a millimetre are no others'. Not
/// with the eye in the plane up to rounding: uncut, a triangle that reaches behind it may then cover anything.
bool isBeyondInPicture(vec4 plane, Corner corners[6]) {
    double farthest = 0.0lf;
    for (int i = 0; i < 3; ++i) farthest = max(farthest, length(corners[i].p.xyz));
    if (view.perspective != 0u && abs(plane.w) < 2.384185791015625e-7 * float(farthest)) return false;
    for (int i = 0; i < 4; ++i) {
        vec2 at = (1.03125 + abs(view.shift)) * view.rayScale.xy * vec2((i & 1) * 2 - 1, (i & 2) - 1);
        bool beyond = view.perspective != 0u ? -dot(plane.xyz, vec3(at, -1.0)) / plane.w <= 1.0 / view.capDistance
                                             : (dot(plane.xy, at) + plane.w) / plane.z >= view.capDistance;
        if (!beyond) return false;
    }
    return true;
}

/// The triangle itself, beyond the plane: at most two.
bool cutTriangleCorner(Corner corners[6], vec4 plane, uint wanted, uint corner, out vec4 position) {
    if (isBeyondInPicture(plane, corners)) {
        position = corners[corner].clip;
        return wanted == 0u;
    }
    vec4 polygon[5];
    uint size = 0u;
    for (int i = 0; i < 3; ++i) {
        int next = (i + 1) % 3;
        if (isBeyond(corners[i])) polygon[size++] = corners[i].clip;
        if (isBeyond(corners[i]) != isBeyond(corners[next])) polygon[size++] = clipOfCut(corners[i], corners[next]);
    }
    if (wanted + 2u >= size) return false;
    position = polygon[corner == 0u ? 0u : wanted + corner];
    return true;
}

uint caseOf(Corner corners[6]) {
    int rays = 0, cuts = 0;
    for (int i = 0; i < 3; ++i) {
        rays += int(isBeyond(corners[i]) != isBeyond(corners[i + 3]));
        cuts += int(isBeyond(corners[i]) != isBeyond(corners[(i + 1) % 3]));
    }
    return rays == 3 ? NEAR_CAP_EASY : (rays + cuts == 0 ? NEAR_CAP_TRIVIAL : NEAR_CAP_HARD);
}

void main() {
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0);  // outside: dropped
    uint vertex = uint(gl_VertexID);
    CapTriangle triangle;
    if (!findCap(vertex / 9u, triangle)) return;
    vec4 lightInModel = lightOf(triangle.instance);
    dvec3 light = viewFromModelInDouble(triangle.instance, lightInModel);
    Corner corners[6];
    for (int i = 0; i < 3; ++i) {
        corners[i] = nearCut(triangle.instance, positionOf(triangle.vertices[triangle.flip ? 2 - i : i]));
        corners[i + 3] = farCut(corners[i], light, lightInModel.w);
    }
#ifdef CASES
    if (cap == CAP_SECTION && vertex % 9u == 0u) atomicAdd(fill[triangle.instance].nearCaps[caseOf(corners)], 1u);
#endif
#ifdef EDGE_ON
    nearA = onLedge(nearCorner(triangle.instance, positionOf(triangle.vertices.x)));
    nearB = onLedge(nearCorner(triangle.instance, positionOf(triangle.vertices.y)));
    farA = farB = onLedge(nearCorner(triangle.instance, positionOf(triangle.vertices.z)));
#endif
    vec4 position;
    uint wanted = vertex % 9u / 3u, corner = vertex % 3u;
    bool has = cap == CAP_SECTION ? sectionCorner(corners, wanted, corner, position)
                                  : cutTriangleCorner(corners, planes[vertex / 9u], wanted, corner, position);
    if (has) gl_Position = position;
}
