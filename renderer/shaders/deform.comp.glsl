// SPDX-License-Identifier: Apache-2.0
// The position pass: morph targets, a procedure and skinning, in that order, from a mesh's rest vertices into the
// vertices of one instance. Every later decision reads the result (Brabec & Seidel 2003, section 4.1).
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "shared.h"

layout(local_size_x = CHUNK_SIZE) in;

layout(std430, binding = BIND_POSITIONS) buffer Positions { float positions[]; };
layout(std430, binding = BIND_DEFORM_NORMALS) buffer Normals { float normals[]; };
layout(std430, binding = BIND_DEFORM_TANGENTS) buffer Tangents { vec4 tangents[]; };
layout(std430, binding = BIND_DEFORM_INFLUENCES) readonly buffer Influences { uint influences[]; };  // 6 words each
layout(std430, binding = BIND_DEFORM_JOINTS) readonly buffer Joints { vec4 joints[]; };              // 3 rows each
layout(std430, binding = BIND_DEFORM_MORPHS) readonly buffer Morphs { float morphs[]; };  // MORPH_FLOATS a vertex and target
layout(std430, binding = BIND_DEFORM_WEIGHTS) readonly buffer Weights { float morphWeights[]; };
layout(std430, binding = BIND_DEFORM_BOUNDS) buffer Bounds { uint bounds[]; };

layout(location = 0) uniform uint restVertex;
layout(location = 1) uniform uint firstVertex;
layout(location = 2) uniform uint vertexCount;
layout(location = 3) uniform uint firstJoint;
layout(location = 4) uniform uint jointCount;  // 0: stays in model space
layout(location = 5) uniform uint firstInfluence;
layout(location = 6) uniform uint influenceSets;
layout(location = 7) uniform uint firstMorph;
layout(location = 8) uniform uint morphCount;
layout(location = 9) uniform uint boundsIndex;
layout(location = 10) uniform uint hasTangents;
layout(location = 11) uniform float amplitude;  // 0: no procedure
layout(location = 12) uniform float frequency;
layout(location = 13) uniform float phase;  // speed times seconds
layout(location = 14) uniform uint firstWeight;
layout(location = 15) uniform uint procedure;
layout(location = 16) uniform vec3 axis;

vec3 load(uint array, uint v) {
    return array == 0u ? vec3(positions[3u * v], positions[3u * v + 1u], positions[3u * v + 2u])
                       : vec3(normals[3u * v], normals[3u * v + 1u], normals[3u * v + 2u]);
}

vec3 loadMorph(uint element, uint part) {
    uint i = MORPH_FLOATS * (firstMorph + element) + 3u * part;
    return vec3(morphs[i], morphs[i + 1u], morphs[i + 2u]);
}

/// A gradient of the lattice point: one of 16 directions picked by an integer hash, so that all devices agree.
vec3 latticeGradient(ivec3 p) {
    uvec3 u = uvec3(p) * uvec3(0x8da6b343u, 0xd8163841u, 0xcb1ab31fu);
    uint h = u.x ^ u.y ^ u.z;
    h = (h ^ (h >> 15)) * 0x2c1b3c6du;
    h = (h ^ (h >> 12)) * 0x297a2d39u;
    h ^= h >> 15;
    vec3 g = vec3((h & 1u) != 0u ? 1.0 : -1.0, (h & 2u) != 0u ? 1.0 : -1.0, (h & 4u) != 0u ? 1.0 : -1.0);
    uint axis = (h >> 3) % 3u;
    g[axis] = 0.0;
    return g;
}

/// Gradient noise (Perlin's lattice with quintic weights), about -1 to 1; w holds the value, xyz its gradient.
vec4 noise(vec3 p) {
    ivec3 cell = ivec3(floor(p));
    vec3 f = p - vec3(cell);
    vec3 w = f * f * f * (f * (f * 6.0 - 15.0) + 10.0);
    vec3 dw = 30.0 * f * f * (f * (f - 2.0) + 1.0);
    vec4 sum = vec4(0.0);
    for (int i = 0; i < 8; ++i) {
        ivec3 corner = ivec3(i & 1, (i >> 1) & 1, i >> 2);
        vec3 g = latticeGradient(cell + corner);
        float value = dot(g, f - vec3(corner));
        vec3 side = mix(1.0 - w, w, vec3(corner));
        vec3 slope = mix(-dw, dw, vec3(corner));
        float weight = side.x * side.y * side.z;
        sum.w += value * weight;
        sum.xyz += g * weight + value * vec3(slope.x * side.y * side.z, side.x * slope.y * side.z,
                                             side.x * side.y * slope.z);
    }
    return sum;
}

/// Along the normal by `height`, whose gradient is `slope`; the normal to first order.
void moveAlongNormal(float height, vec3 slope, inout vec3 p, inout vec3 n) {
    p += height * n;
    n -= slope - dot(slope, n) * n;
}

vec3 rotated(vec3 v, float angle) {
    float along = dot(axis, v);
    return cos(angle) * (v - along * axis) + sin(angle) * cross(axis, v) + along * axis;
}

/// Turns about the axis by `rate` times the place along it.
void twist(float rate, inout vec3 p, inout vec3 n, inout vec3 t) {
    float angle = rate * dot(axis, p);
    p = rotated(p, angle);
    vec3 shear = rate * cross(axis, p);  // how a turned point moves with its place along the axis
    t = rotated(t, angle) + dot(axis, t) * shear;
    n = rotated(n, angle);
    n -= dot(shear, n) * axis;
}

void displace(inout vec3 p, inout vec3 n, inout vec3 t) {
    const float kTurn = 6.2831853;
    if (procedure == PROCEDURE_NOISE) {
        vec4 d = noise(p * frequency + phase * vec3(0.31, 0.73, 0.53));
        moveAlongNormal(amplitude * d.w, amplitude * frequency * d.xyz, p, n);
    } else if (procedure == PROCEDURE_WAVE) {
        float angle = kTurn * (frequency * dot(axis, p) - phase);
        moveAlongNormal(amplitude * sin(angle), amplitude * kTurn * frequency * cos(angle) * axis, p, n);
    } else {
        twist(amplitude * cos(kTurn * phase), p, n, t);
    }
}

uint ordered(float f) {
    uint u = floatBitsToUint(f);
    return (u & 0x80000000u) != 0u ? ~u : u | 0x80000000u;
}

void main() {
    uint i = GROUP_HERE * CHUNK_SIZE + gl_LocalInvocationID.x;
    if (i >= vertexCount) return;
    precise vec3 p = load(0u, restVertex + i);
    vec3 n = load(1u, restVertex + i);
    vec4 t = hasTangents != 0u ? tangents[restVertex + i] : vec4(0.0);
    for (uint m = 0u; m < morphCount; ++m) {
        float weight = morphWeights[firstWeight + m];
        uint element = m * vertexCount + i;
        p += weight * loadMorph(element, 0u);
        n += weight * loadMorph(element, 1u);
        t.xyz += weight * loadMorph(element, 2u);
    }
    if (amplitude != 0.0) {
        vec3 moved = p;
        displace(moved, n, t.xyz);
        p = moved;
    }
    if (jointCount > 0u) {
        vec4 rows[3] = vec4[3](vec4(0.0), vec4(0.0), vec4(0.0));
        for (uint s = 0u; s < influenceSets; ++s) {
            uint base = 6u * (firstInfluence + i * influenceSets + s);
            for (uint k = 0u; k < 4u; ++k) {
                uint joint = influences[base + (k >> 1)] >> (16u * (k & 1u)) & 0xffffu;
                float weight = uintBitsToFloat(influences[base + 2u + k]);
                for (uint r = 0u; r < 3u; ++r) rows[r] += weight * joints[3u * (firstJoint + joint) + r];
            }
        }
        if (influenceSets == 0u) {
            for (uint r = 0u; r < 3u; ++r) rows[r] = joints[3u * firstJoint + r];
        }
        p = vec3(dot(rows[0], vec4(p, 1.0)), dot(rows[1], vec4(p, 1.0)), dot(rows[2], vec4(p, 1.0)));
        // Cofactors take normals along, also under uneven scale; a mirroring joint would turn them inwards.
        mat3 c = mat3(cross(rows[1].xyz, rows[2].xyz), cross(rows[2].xyz, rows[0].xyz), cross(rows[0].xyz, rows[1].xyz));
        n = n * c * (dot(rows[0].xyz, c[0]) < 0.0 ? -1.0 : 1.0);
        t.xyz = vec3(dot(rows[0].xyz, t.xyz), dot(rows[1].xyz, t.xyz), dot(rows[2].xyz, t.xyz));
    }
    uint v = firstVertex + i;
    n /= max(length(n), 1e-20);
    for (int k = 0; k < 3; ++k) {
        positions[3u * v + uint(k)] = p[k] + 0.0;
        normals[3u * v + uint(k)] = n[k];
        atomicMin(bounds[BOUNDS_WORDS * boundsIndex + uint(k)], ordered(p[k]));
        atomicMax(bounds[BOUNDS_WORDS * boundsIndex + 3u + uint(k)], ordered(p[k]));
    }
    if (hasTangents != 0u) tangents[v] = t;
}
