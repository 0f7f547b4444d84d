// SPDX-License-Identifier: Apache-2.0
// TEXTURES: which the material has, where that is known.
// variant: ALPHA_TEST 1
// variant: TEXTURES 5u
#version 450 core
#extension GL_GOOGLE_include_directive : require
#ifdef ALPHA_TEST
#else
layout(early_fragment_tests) in;
#endif
#include "view.glsl"
#include "material.glsl"
#include "octahedron.glsl"

layout(location = 0) out uint outTriangle;
layout(location = 1) out vec4 outBaseColor;
layout(location = 2) out vec2 outNormal;
layout(location = 3) out vec4 outProperties;  // metallic, roughness, occlusion, lit
layout(location = 4) out vec4 outEmissive;

void main() {
    Surface s = surfaceHere();
#ifdef ALPHA_TEST
    if (s.alpha < material.emissive.w) discard;
#endif
    uint first = drawn.y;
    outTriangle = first == NO_TRIANGLE ? NO_TRIANGLE : first + uint(gl_PrimitiveID);
    outBaseColor = vec4(s.lit ? s.baseColor : vec3(0.0), 1.0);
    outNormal = octahedronFromUnit(s.normal);
    outProperties = vec4(s.metallic, s.roughness, s.occlusion, s.lit ? 1.0 : 0.0);
    outEmissive = vec4(min(s.emissive, 65504.0), 1.0);  // the largest half: finite stays finite
}
