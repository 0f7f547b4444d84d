// SPDX-License-Identifier: Apache-2.0
// A bound on how many casting triangles any ray from a light can cross (T6): every triangle is added to all cells of a
// grid of directions that its bounds touch, and the fullest cell counts. Point lights: the six faces of a cube around
// the light; directional lights: a plane across them, repeated endlessly. Too many is safe, too few is not, so bounds
// are widened by a hundredth of a cell.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "geometry.glsl"

layout(local_size_x = CHUNK_SIZE) in;

layout(std430, binding = BIND_TRIANGLE_FLAGS) readonly buffer TriangleFlags { uint triangleFlags[]; };
layout(std430, binding = BIND_TRIANGLE_CHUNKS) readonly buffer TriangleChunks { uint triangleChunks[]; };
layout(std430, binding = BIND_LIGHTS) readonly buffer Lights { LightData lights[]; };
layout(std430, binding = BIND_CASTERS) readonly buffer Casters { CasterState casters[]; };
layout(std430, binding = BIND_LAYER_CELLS) buffer Cells { uint cells[]; };    // LAYER_CELLS a light
layout(std430, binding = BIND_LAYER_BOUNDS) buffer Bounds { uint bounds[]; };  // one a light

layout(location = 0) uniform uint chunkCount;
layout(location = 1) uniform uint lightCount;
layout(location = 2) uniform uint firstLight;
layout(location = 3) uniform float cellMetres;  // directional lights

void add(uint l, uint cell) {
    uint count = atomicAdd(cells[l * LAYER_CELLS + cell], 1u) + 1u;
    if (count > bounds[l]) atomicMax(bounds[l], count);
}

/// Cells of one face from the bounds of a projection in cells; `wrap` for the endless plane.
void addRectangle(uint l, uint face, vec2 low, vec2 high, bool wrap) {
    low -= 0.01;
    high += 0.01;
    const float n = float(LAYER_GRID);
    if (wrap) {
        high = min(high, low + n - 1.0);
    } else {
        if (low.x >= n || low.y >= n || high.x < 0.0 || high.y < 0.0) return;
        low = clamp(low, 0.0, n - 1.0);
        high = clamp(high, 0.0, n - 1.0);
    }
    ivec2 first = ivec2(floor(low)), last = ivec2(floor(high));
    for (int y = first.y; y <= last.y; ++y) {
        for (int x = first.x; x <= last.x; ++x) {
            uvec2 at = uvec2(x, y) & uvec2(LAYER_GRID - 1u);
            add(l, (face * LAYER_GRID + at.y) * LAYER_GRID + at.x);
        }
    }
}

void addAround(uint l, vec3 a, vec3 b, vec3 c) {
    for (uint face = 0u; face < 6u; ++face) {
        uint axis = face >> 1;
        float s = (face & 1u) != 0u ? -1.0 : 1.0;
        vec3 depth = s * vec3(a[axis], b[axis], c[axis]);
        vec3 u = vec3(a[(axis + 1u) % 3u], b[(axis + 1u) % 3u], c[(axis + 1u) % 3u]);
        vec3 v = vec3(a[(axis + 2u) % 3u], b[(axis + 2u) % 3u], c[(axis + 2u) % 3u]);
        // All corners outside one side of the face's pyramid, or behind: it is not seen there.
        vec3 wide = depth * 1.01;
        if (all(lessThan(depth, vec3(0.0))) || all(greaterThan(u, wide)) || all(lessThan(u, -wide)) ||
            all(greaterThan(v, wide)) || all(lessThan(v, -wide))) {
            continue;
        }
        vec2 low = vec2(0.0), high = vec2(float(LAYER_GRID));  // partly behind: anywhere on the face
        if (all(greaterThan(depth, 1e-4 * (abs(u) + abs(v)) + 1e-30))) {
            vec3 x = (u / depth * 0.5 + 0.5) * float(LAYER_GRID), y = (v / depth * 0.5 + 0.5) * float(LAYER_GRID);
            low = vec2(min(x.x, min(x.y, x.z)), min(y.x, min(y.y, y.z)));
            high = vec2(max(x.x, max(x.y, x.z)), max(y.x, max(y.y, y.z)));
        }
        addRectangle(l, face, low, high, false);
    }
}

void main() {
    uint chunk = GROUP_HERE;
    if (chunk >= chunkCount) return;
    uint instance = triangleChunks[chunk];
    uint triangle = chunk * CHUNK_SIZE + gl_LocalInvocationID.x - instances[instance].placedTriangleBase;
    if (triangle >= instances[instance].triangleCount) return;
    if ((triangleFlags[instances[instance].triangleBase + triangle] & TRIANGLE_CASTS) == 0u) return;
    uvec3 v = triangleVertices(instance, triangle);
    vec3 a = viewFromModel(instance, vec4(positionOf(v.x), 1.0));
    vec3 b = viewFromModel(instance, vec4(positionOf(v.y), 1.0));
    vec3 c = viewFromModel(instance, vec4(positionOf(v.z), 1.0));
    for (uint l = 0u; l < lightCount; ++l) {
        if (((casters[instance].outOfReach | casters[instance].outOfView) >> l & 1u) != 0u) continue;
        vec4 light = lights[firstLight + l].position;
        if (light.w != 0.0) {
            addAround(l, a - light.xyz, b - light.xyz, c - light.xyz);
        } else {
            vec3 x = normalize(cross(light.xyz, abs(light.x) < 0.6 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0)));
            vec3 y = cross(light.xyz, x);
            vec2 p = vec2(dot(a, x), dot(a, y)), q = vec2(dot(b, x), dot(b, y)), r = vec2(dot(c, x), dot(c, y));
            addRectangle(l, 0u, min(p, min(q, r)) / cellMetres, max(p, max(q, r)) / cellMetres, true);
        }
    }
}
