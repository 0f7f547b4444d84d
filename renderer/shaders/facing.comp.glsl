// SPDX-License-Identifier: Apache-2.0
// Triangle setup: which side of every triangle faces each of up to 32 lights, decided here and nowhere else, stored and
// used for all edges, caps and shading (docs/rules.md, G1); the triangle's plane in view space; and how many
// layers lie between each light and the eye (the eye constant of z-pass, G5).
// variant: PARTS 1
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "geometry.glsl"
#include "casters.glsl"

layout(local_size_x = CHUNK_SIZE) in;

layout(std430, binding = BIND_TRIANGLE_FLAGS) readonly buffer TriangleFlags { uint triangleFlags[]; };
layout(std430, binding = BIND_TRIANGLE_CHUNKS) readonly buffer TriangleChunks { uint triangleChunks[]; };
// Per placed triangle and group of lights: bit l of x: the front faces light l; of y: the back does. Neither: edge-on.
layout(std430, binding = BIND_FACING) writeonly buffer Facing { uvec2 facing[]; };
layout(std430, binding = BIND_PLANES) writeonly buffer Planes { vec4 planes[]; };

layout(location = 0) uniform uint chunkCount;
layout(location = 1) uniform uint facingBase;  // first word of this group

/// Rounded step by step as written, so that the host technique decides alike.
vec3 faceNormal(vec3 a, vec3 b, vec3 c) {
    precise vec3 u = b - a;
    precise vec3 v = c - a;
    precise vec3 n;
    n.x = u.y * v.z - u.z * v.y;
    n.y = u.z * v.x - u.x * v.z;
    n.z = u.x * v.y - u.y * v.x;
    return n;
}

/// Positive: the homogeneous point p is on the side the normal points to.
float sideOf(vec3 n, vec3 a, vec4 p) {
    precise vec3 d = p.xyz - p.w * a;
    precise float side = n.x * d.x + n.y * d.y + n.z * d.z;
    return side;
}

/// d.(a x b) in double, rounded step by step as written, so that the host technique decides alike. `n` becomes a x b.
double determinant3(dvec3 d, dvec3 a, dvec3 b, out dvec3 n) {
    precise dvec3 product;
    product.x = a.y * b.z - a.z * b.y;
    product.y = a.z * b.x - a.x * b.z;
    product.z = a.x * b.y - a.y * b.x;
    n = product;
    precise double det = d.x * product.x + d.y * product.y + d.z * product.z;
    return det;
}

/// Whether rounding may have decided the sign of such a determinant of floats.
bool isRounding(double det, dvec3 d, dvec3 a, dvec3 b) {
    return abs(det) < 1e-14lf * dot(abs(d), abs(a.yzx * b.zxy) + abs(a.zxy * b.yzx));
}

/// For a light within a triangle's box, floats do not say whether it lies on the triangle, which then hides nothing from
/// it: there the side is decided in double, whose error on floats is beyond anything that such a light can mean.
/// @return  0 only if the light lies in the plane
float sideOfNearLight(vec3 a, vec3 b, vec3 c, vec3 light) {
    dvec3 u = dvec3(b) - dvec3(a), v = dvec3(c) - dvec3(a), d = dvec3(light) - dvec3(a), n;
    double side = determinant3(d, u, v, n);
    return isRounding(side, d, u, v) ? 0.0 : float(sign(side));
}

bool inBoxOf(vec3 a, vec3 b, vec3 c, vec4 light) {
    return light.w != 0.0 && all(greaterThanEqual(light.xyz, min(a, min(b, c)))) &&
           all(lessThanEqual(light.xyz, max(a, max(b, c))));
}

/// Whether the sign of det[d, a, b] is certain in float, and which: -1, +1, or 0 for uncertain. Inputs carry rounding
/// of 2^-24 each; 1e-5 of the sum of magnitudes is far beyond what they can add up to.
int certainSign(vec3 d, vec3 a, vec3 b) {
    float magnitude = dot(abs(d), abs(a.yzx * b.zxy) + abs(a.zxy * b.yzx));
    float det = dot(d, cross(a, b));
    return abs(det) > 1e-5 * magnitude ? (det > 0.0 ? 1 : -1) : 0;
}

/// Sign of det[d, a, b] in double, as if the eye were moved by an infinitesimal (e, e^2, e^3) where it is zero, so that
/// a ray through an edge or a vertex crosses exactly one of the triangles there. Exactly antisymmetric in a and b.
/// `undecided` is set when rounding may have decided: such a caster is counted by z-fail (T4).
int exactSign(dvec3 d, dvec3 a, dvec3 b, inout bool undecided) {
    dvec3 n;
    double det = determinant3(d, a, b, n);
    if (det != 0.0lf) {
        undecided = undecided || isRounding(det, d, a, b);
        return det > 0.0lf ? 1 : -1;
    }
    if (n.x != 0.0lf) return n.x > 0.0lf ? 1 : -1;
    if (n.y != 0.0lf) return n.y > 0.0lf ? 1 : -1;
    return n.z > 0.0lf ? 1 : -1;
}

/// Whether the line from `origin` along `d` passes through the triangle.
bool crosses(vec3 origin, vec3 d, vec3 a, vec3 b, vec3 c, inout bool undecided) {
    int ab = certainSign(d, a - origin, b - origin);
    int bc = certainSign(d, b - origin, c - origin);
    int ca = certainSign(d, c - origin, a - origin);
    if (max(ab, max(bc, ca)) - min(ab, min(bc, ca)) == 2) return false;
    dvec3 o = dvec3(origin), dd = dvec3(d);
    ab = exactSign(dd, dvec3(a) - o, dvec3(b) - o, undecided);
    bc = exactSign(dd, dvec3(b) - o, dvec3(c) - o, undecided);
    ca = exactSign(dd, dvec3(c) - o, dvec3(a) - o, undecided);
    return ab == bc && bc == ca;
}

/// T4 for caps: with the eye on a triangle view rays begin on both sides of it, and no constant is right for all.
bool eyeIsOn(vec4 homogeneousEye, vec3 n, vec3 a, vec3 b, vec3 c) {
    if (homogeneousEye.w == 0.0) return false;
    vec3 eye = homogeneousEye.xyz;
    float near = HAZARD * max(distance(eye, a), max(distance(eye, b), distance(eye, c)));
    return abs(sideOf(n, a, homogeneousEye)) <= near * length(n) && all(greaterThanEqual(eye, min(a, min(b, c)) - near)) &&
           all(lessThanEqual(eye, max(a, max(b, c)) + near));
}

/// Whether the triangle lies between the light and an end of the view rays: the eye, or for an orthographic eye a
/// direction.
bool isOver(vec4 end, vec3 a, vec3 b, vec3 c, vec3 n, vec4 light, float lightSide, inout bool undecided) {
    if (end.w == 0.0 && light.w == 0.0) return false;  // two points at infinity: no finite triangle lies between them
    float endSide = sideOf(n, a, end);
    if (endSide == 0.0 || (endSide > 0.0) == (lightSide > 0.0)) return false;
    vec3 origin = end.w == 0.0 ? light.xyz : end.xyz;
    vec3 d = end.w == 0.0 ? end.xyz : light.xyz - light.w * end.xyz;
    return crosses(origin, d, a, b, c, undecided);
}

#ifdef PARTS
/// Adds the triangle to its part's constant of either end of the view rays.
void countEye(uint instance, uint l, uint placed, vec3 a, vec3 b, vec3 c, vec3 n, vec4 light, float lightSide) {
    uint part = partOfTriangle(placed, l);
    vec4 eye = instances[instance].eyeInModel;
    for (uint end = SPLIT_PASS; end <= (mayHoldFarEnds(instance, l) ? SPLIT_FAIL : SPLIT_PASS); ++end) {
        bool undecided = false;
        if (isOver(end == SPLIT_PASS ? eye : -eye, a, b, c, n, light, lightSide, undecided)) {
            atomicAdd(parts[part].eyeInside[end], 1u);
            if (end == SPLIT_PASS) atomicAdd(summaries[l].eyeInside[LIST_WHOLE], 1u);
        }
        if (undecided) atomicOr(parts[part].hazards, 1u << end);
    }
}
#else
/// Adds the triangle to the eye constant of its list when it lies between light and eye. For an orthographic eye that
/// is the infinite end of the view rays that the list's counting starts from: behind the viewer for z-pass, before it
/// for z-fail (T5).
void countEye(uint instance, uint l, uint flags, vec3 a, vec3 b, vec3 c, vec3 n, vec4 light, float lightSide) {
    uint list = listOf(instance, l, (flags & TRIANGLE_EVEN) != 0u);
    vec4 eye = instances[instance].eyeInModel;
    if (list == LIST_FAIL) {
        if (!mayHoldFarEnds(instance, l)) return;
        eye.xyz = -eye.xyz;
    }
    bool undecided = false;
    if (isOver(eye, a, b, c, n, light, lightSide, undecided)) atomicAdd(summaries[l].eyeInside[list], 1u);
    if (undecided) atomicOr(casters[instance].hazards, 1u << l);
}
#endif

/// For the statistics.
void countCaps(uint instance, uint l, uint flags, vec4 light, float side) {
    if (side > 0.0) atomicAdd(summaries[l].litTriangles, 1u);
#ifdef PARTS
    const bool fail = true;  // somewhere
#else
    bool fail = (casters[instance].countedByFail >> l & 1u) != 0u;
#endif
    if (fail || (flags & TRIANGLE_HOLED) != 0u || casters[instance].missing != 0u) atomicAdd(summaries[l].lightCaps, 1u);
    bool apart = light.w != 0.0 && instances[instance].eyeInModel.w != 0.0;
    if (fail && (apart || endOfVolume(instance, l) != 0u)) atomicAdd(summaries[l].darkCaps, 1u);
}

void main() {
    uint chunk = GROUP_HERE;
    if (chunk >= chunkCount) return;
    uint instance = triangleChunks[chunk];
    uint placed = chunk * CHUNK_SIZE + gl_LocalInvocationID.x;
    uint triangle = placed - instances[instance].placedTriangleBase;
    if (triangle >= instances[instance].triangleCount) {
        facing[facingBase + placed] = uvec2(0u);
        planes[placed] = vec4(0.0);
        return;
    }
    uint flags = triangleFlags[instances[instance].triangleBase + triangle];
    uvec3 v = triangleVertices(instance, triangle);
    vec3 a = positionOf(v.x), b = positionOf(v.y), c = positionOf(v.z);

    vec3 normal = faceNormal(a, b, c);
    uvec2 bits = uvec2(0u);
    uint counted = 0u;  // lights whose shadows it casts
    uint reaching = ~(casters[instance].outOfReach | casters[instance].outOfView) & (lightCount == 32u ? ~0u : (1u << lightCount) - 1u);
    for (; reaching != 0u; reaching &= reaching - 1u) {
        uint l = uint(findLSB(reaching));
        vec4 light = lightInModel(instance, l);
        float side = sideOf(normal, a, light);
        uint bit = 1u << l;
        bool near = inBoxOf(a, b, c, light);
        if (near) side = sideOfNearLight(a, b, c, light.xyz);
        if (side > 0.0) {
            bits.x |= bit;
        } else if (side < 0.0 || ((flags & TRIANGLE_EVEN) != 0u && !near)) {
            // Any weight is legal (G1); in an even component an edge-on triangle gets one, so that
            // every edge keeps an even multiplicity and its quads can be halved.
            bits.y |= bit;
        } else {
            // Not so where the light lies on the triangle: its volume would be half of space.
            if (near) atomicOr(casters[instance].lightOn, bit);
            continue;
        }
        if ((flags & TRIANGLE_CASTS) == 0u) continue;
        if (countLit != 0u) countCaps(instance, l, flags, light, side);
        counted |= bit;
#ifdef PARTS
        countEye(instance, l, placed, a, b, c, normal, light, side);
#else
        countEye(instance, l, flags, a, b, c, normal, light, side);
#endif
    }
    counted &= ~casters[instance].countedByFail;  // which needs no constant
    if (counted != 0u && eyeIsOn(instances[instance].eyeInModel, normal, a, b, c)) {
#ifdef PARTS
        for (; counted != 0u; counted &= counted - 1u) {
            atomicOr(parts[partOfTriangle(placed, uint(findLSB(counted)))].hazards, 1u << SPLIT_PASS);
        }
#else
        atomicOr(casters[instance].hazards, counted);
#endif
    }
#if FAULT == FAULT_WRONG_FACING
    if (triangle % 64u == 7u) bits = bits.yx;
#endif
    facing[facingBase + placed] = bits;

    vec3 n = vec3(dot(instances[instance].normalFromModel[0].xyz, normal),
                  dot(instances[instance].normalFromModel[1].xyz, normal),
                  dot(instances[instance].normalFromModel[2].xyz, normal));
    n /= max(length(n), 1e-37);
    planes[placed] = vec4(n, -dot(n, viewFromModel(instance, vec4(a, 1.0))));
}
