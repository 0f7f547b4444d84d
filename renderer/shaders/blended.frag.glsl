// SPDX-License-Identifier: Apache-2.0
// BLEND surfaces, over the resolved image in order of depth, lit by all lights without shadows (G7).
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "view.glsl"
#include "material.glsl"
#include "lights.glsl"

layout(location = 0) out vec4 outRadiance;

void main() {
    Surface surface = surfaceHere();
    vec3 radiance = surface.emissive;
    if (surface.lit) {
        Shading s;
        s.baseColor = surface.baseColor;
        s.metallic = surface.metallic;
        s.roughness = surface.roughness;
        s.n = surface.normal;
        s.v = view.perspective != 0u ? normalize(-viewPosition) : vec3(0.0, 0.0, 1.0);
        radiance += ambient(s.baseColor, surface.occlusion, s.n);
        for (uint i = 0u; i < view.lightCount; ++i) {
            LightData light = lights[i];
            vec3 l;
            float strength = arriving(light, viewPosition, l);
            if (strength > 0.0) radiance += strength * light.color.rgb * reflectance(s, l);
        }
    }
    outRadiance = vec4(radiance * surface.alpha, surface.alpha);
}
