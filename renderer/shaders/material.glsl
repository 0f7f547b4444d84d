// SPDX-License-Identifier: Apache-2.0
// A surface's material at a fragment: glTF 2.0 section 3.9, with KHR_texture_transform, _unlit and _emissive_strength.
#include "shared.h"

layout(std430, binding = BIND_MATERIALS) readonly buffer Materials { MaterialData materials[]; };
layout(std430, binding = BIND_DRAWS) readonly buffer Draws { DrawData draws[]; };

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
layout(location = 5) flat in uint drawIndex;

struct Surface {
    vec3 baseColor;
    float alpha;
    vec3 normal;  // view space, unit, towards the viewer's side
    float metallic, roughness, occlusion;
    vec3 emissive;
    bool lit;
};

vec2 uvOf(MaterialData material, uint texture) {
    vec4 row0 = material.uvRows[2u * texture], row1 = material.uvRows[2u * texture + 1u];
    vec3 uv = vec3(row0.w > 0.5 ? texCoords.zw : texCoords.xy, 1.0);
    return vec2(dot(row0.xyz, uv), dot(row1.xyz, uv));
}

bool has(MaterialData material, uint texture) { return (material.textures >> texture & 1u) != 0u; }

/// Perturbs the normal by the normal map. Without tangents in the file the frame comes from screen-space derivatives
/// of position and texture coordinates.
vec3 mapNormal(MaterialData material, vec3 n, uint drawFlags, bool front) {
    vec2 uv = uvOf(material, TEXTURE_NORMAL);
    vec3 m = texture(normalTexture, uv).xyz * 2.0 - 1.0;
    m.xy *= material.factors.z;
    vec3 t, b;
    if ((drawFlags & DRAW_HAS_TANGENTS) != 0u) {
        t = viewTangent.xyz;
        b = cross(viewNormal, t) * viewTangent.w;
        if (!front) {
            t = -t;
            b = -b;
        }
    } else {
        vec3 px = dFdx(viewPosition), py = dFdy(viewPosition);
        vec2 ux = dFdx(uv), uy = dFdy(uv);
        vec3 xPerp = cross(py, n), yPerp = cross(n, px);
        t = xPerp * ux.x + yPerp * uy.x;
        b = xPerp * ux.y + yPerp * uy.y;
        float orientation = dot(cross(px, py), n) < 0.0 ? -1.0 : 1.0;
        t *= orientation;
        b *= orientation;
    }
    float scale = max(dot(t, t), dot(b, b));
    if (scale < 1e-30) return n;
    t *= inversesqrt(scale);
    b *= inversesqrt(scale);
    return normalize(t * m.x + b * m.y + n * m.z);
}

Surface surfaceHere() {
    DrawData draw = draws[drawIndex];
    MaterialData material = materials[draw.material];
    Surface s;
    vec4 base = material.baseColor;
    if ((draw.flags & DRAW_HAS_COLORS) != 0u) base *= vertexColor;
    if (has(material, TEXTURE_BASE_COLOR)) base *= texture(baseColorTexture, uvOf(material, TEXTURE_BASE_COLOR));
    s.baseColor = base.rgb;
    s.alpha = base.a;
    s.metallic = material.factors.x;
    s.roughness = material.factors.y;
    if (has(material, TEXTURE_METALLIC_ROUGHNESS)) {
        vec4 mr = texture(metallicRoughnessTexture, uvOf(material, TEXTURE_METALLIC_ROUGHNESS));
        s.metallic *= mr.b;
        s.roughness *= mr.g;
    }
    s.occlusion = 1.0;
    if (has(material, TEXTURE_OCCLUSION)) {
        float o = texture(occlusionTexture, uvOf(material, TEXTURE_OCCLUSION)).r;
        s.occlusion = 1.0 + material.factors.w * (o - 1.0);
    }
    s.emissive = material.emissive.rgb;
    if (has(material, TEXTURE_EMISSIVE)) s.emissive *= texture(emissiveTexture, uvOf(material, TEXTURE_EMISSIVE)).rgb;

    bool isTriangle = draw.firstPlacedTriangle != NO_TRIANGLE;
    bool front = !isTriangle || gl_FrontFacing;
    if ((draw.flags & DRAW_HAS_NORMALS) != 0u) {
        s.normal = normalize(viewNormal) * (front ? 1.0 : -1.0);
    } else {
        vec3 n = cross(dFdx(viewPosition), dFdy(viewPosition));  // flat: the plane, turned to the viewer
        float towards = view.perspective != 0u ? dot(n, viewPosition) : -n.z;
        s.normal = dot(n, n) > 0.0 ? normalize(towards > 0.0 ? -n : n) : vec3(0.0, 0.0, 1.0);
    }
    if (has(material, TEXTURE_NORMAL) && isTriangle) s.normal = mapNormal(material, s.normal, draw.flags, front);
    s.lit = (material.flags & MATERIAL_UNLIT) == 0u && isTriangle;
    if (!s.lit) s.emissive = s.baseColor;  // points and lines are unlit
    return s;
}
