// SPDX-License-Identifier: Apache-2.0
// Sets a light's bit where its shadow map holds something nearer to it than what is seen: one texel, one comparison.
// Around a light the map has six faces, those of a cube with the world's axes.
// variant: SAMPLES 4
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "gbuffer.glsl"
#include "lights.glsl"

layout(location = 0) out uint outMask;
layout(location = 0) uniform uint light;  // in the frame's list
layout(location = 2) uniform uint faces;  // 6 or 1
layout(location = 3) uniform mat3 worldFromView;
layout(location = 6) uniform mat4 mapFromView[6];
layout(binding = UNIT_SHADOW_MAP) uniform sampler2DArray map;

/// Positive and negative X, Y, Z.
uint faceTowards(vec3 d) {
    vec3 a = abs(d);
    uint axis = a.x >= a.y && a.x >= a.z ? 0u : (a.y >= a.z ? 1u : 2u);
    return 2u * axis + uint(d[axis] < 0.0);
}

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    float depth = texelFetch(depthTexture, at, gbufferSample).r;
    if (depth == view.emptyDepth) discard;
    uint triangle = texelFetch(triangleTexture, at, gbufferSample).r;
    uint bit = 1u << (light % LIGHTS_PER_GROUP);
    if (triangle == NO_TRIANGLE || (facedLights(triangle, light / LIGHTS_PER_GROUP) & bit) == 0u) discard;
    vec2 ndc = ndcHere();
    vec3 p = viewPositionAt(eyeDistance(triangle, depth, ndc), ndc);
    uint face = faces == 1u ? 0u : faceTowards(worldFromView * (p - lights[light].position.xyz));
    vec4 clip = mapFromView[face] * vec4(p, 1.0);
    vec2 place = VIEWPORT_SCALE * clip.xy / clip.w;
    // Outside one face that is all there is nothing shines, or nothing is seen.
    if (clip.w <= 0.0 || (faces == 1u && any(greaterThan(abs(place), vec2(1.0))))) discard;
    ivec2 size = textureSize(map, 0).xy;
    ivec2 texel = clamp(ivec2((0.5 + vec2(0.5, -0.5) * place) * vec2(size)), ivec2(0), size - 1);  // row 0 is the top
    if (texelFetch(map, ivec3(texel, face), 0).r <= clip.z / clip.w) discard;
    outMask = bit;
}
