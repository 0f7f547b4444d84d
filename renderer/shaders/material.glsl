// SPDX-License-Identifier: Apache-2.0
// A surface's material at a fragment: glTF 2.0 section 3.9, with KHR_texture_transform, _unlit and _emissive_strength.
#include "shared.h"

// Uniforms and inputs only: llvmpipe loads zeros from storage buffers for the helper lanes at a triangle's edge, and
// texture coordinates made from those have derivatives from nowhere.
layout(std140, binding = BIND_MATERIAL) uniform Materials { MaterialData material; };

layout(binding = TEXTURE_BASE_COLOR) uniform sampler2D baseColorTexture;
layout(binding = TEXTURE_METALLIC_ROUGHNESS) uniform sampler2D metallicRoughnessTexture;
layout(binding = TEXTURE_NORMAL) uniform sampler2D normalTexture;
layout(binding = TEXTURE_OCCLUSION) uniform sampler2D occlusionTexture;
layout(binding = TEXTURE_EMISSIVE) uniform sampler2D emissiveTexture;

layout(location = 0) in vec3 viewPosition;
layout(location = 1) in vec3 viewNormal;
layout(location = 2) in vec4 viewTangent;
layout(location = 3) in vec4 texCoords;
layout(location = 4) in vec4 vertexColor;
layout(location = 5) flat in uvec3 drawn;  // instance, first placed triangle, flags

struct Surface {
    vec3 baseColor;
    float alpha;
    vec3 normal;  // view space, unit, towards the viewer's side
    float metallic, roughness, occlusion;
    vec3 emissive;
    bool lit;
};

vec2 uvOf(uint texture) {
    vec4 row0 = material.uvRows[2u * texture], row1 = material.uvRows[2u * texture + 1u];
    vec3 uv = vec3(row0.w > 0.5 ? texCoords.zw : texCoords.xy, 1.0);
    return vec2(dot(row0.xyz, uv), dot(row1.xyz, uv));
}

#ifndef TEXTURES
#define TEXTURES material.textures
#endif
bool has(uint texture) { return (TEXTURES >> texture & 1u) != 0u; }

/// The front's normal n after the normal map. Without tangents in the file they come from screen-space derivatives of
/// position and texture coordinates. The map's y axis points up, against v.
vec3 mapNormal(vec3 n) {
    vec2 uv = uvOf(TEXTURE_NORMAL);
    vec3 m = texture(normalTexture, uv).xyz * 2.0 - 1.0;
    m.xy *= material.factors.z;
    vec3 t;
    float handedness;
    if ((drawn.z & DRAW_HAS_TANGENTS) != 0u) {
        t = viewTangent.xyz;
        handedness = viewTangent.w;
    } else {
        vec3 px = dFdx(viewPosition), py = dFdy(viewPosition);
        vec2 ux = dFdx(uv), uy = dFdy(uv);
        float turn = ux.x * uy.y - ux.y * uy.x;
        t = (px * uy.y - py * ux.y) * sign(turn);
        handedness = turn * dot(cross(px, py), n) > 0.0 ? -1.0 : 1.0;
    }
    t -= n * dot(n, t);
    float size = dot(t, t);
    if (size < 1e-36) return n;
    t *= inversesqrt(size);
    return normalize(t * m.x + cross(n, t) * handedness * m.y + n * m.z);
}

Surface surfaceHere() {
    Surface s;
    vec4 base = material.baseColor;
    if ((drawn.z & DRAW_HAS_COLORS) != 0u) base *= vertexColor;
    if (has(TEXTURE_BASE_COLOR)) base *= texture(baseColorTexture, uvOf(TEXTURE_BASE_COLOR));
    s.baseColor = base.rgb;
    s.alpha = base.a;
    s.metallic = material.factors.x;
    s.roughness = material.factors.y;
    if (has(TEXTURE_METALLIC_ROUGHNESS)) {
        vec4 mr = texture(metallicRoughnessTexture, uvOf(TEXTURE_METALLIC_ROUGHNESS));
        s.metallic *= mr.b;
        s.roughness *= mr.g;
    }
    s.occlusion = 1.0;
    if (has(TEXTURE_OCCLUSION)) {
        float o = texture(occlusionTexture, uvOf(TEXTURE_OCCLUSION)).r;
        s.occlusion = 1.0 + material.factors.w * (o - 1.0);
    }
    s.emissive = material.emissive.rgb;
    if (has(TEXTURE_EMISSIVE)) s.emissive *= texture(emissiveTexture, uvOf(TEXTURE_EMISSIVE)).rgb;

    bool isTriangle = drawn.y != NO_TRIANGLE;
    float side = isTriangle && !gl_FrontFacing ? -1.0 : 1.0;
    vec3 n = viewNormal;  // of the front
    if ((drawn.z & DRAW_HAS_NORMALS) == 0u || dot(n, n) == 0.0) {
        n = cross(dFdx(viewPosition), dFdy(viewPosition));  // flat: of the plane
        float towards = view.perspective != 0u ? dot(n, viewPosition) : -n.z;
        n *= towards > 0.0 ? -side : side;
    }
    n = dot(n, n) > 0.0 ? normalize(n) : vec3(0.0, 0.0, side);
    if (has(TEXTURE_NORMAL) && isTriangle) n = mapNormal(n);
    s.normal = n * side;  // a back face is the front inverted, bumps and all
    s.lit = (material.flags & MATERIAL_UNLIT) == 0u && isTriangle;
    if (!s.lit) s.emissive = s.baseColor;  // points and lines are unlit
    return s;
}
