// SPDX-License-Identifier: Apache-2.0
// All lights in one pass over the image (not over the geometry): G-buffer, masks and facing bits to radiance.
// variant: SAMPLES 4
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "gbuffer.glsl"
#include "lights.glsl"
#include "seen.glsl"

layout(location = 0) out vec4 outRadiance;

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    float depth = texelFetch(depthTexture, at, gbufferSample).r;
    if (depth == view.emptyDepth) {
        outRadiance = view.background;
        return;
    }
    uint triangle = texelFetch(triangleTexture, at, gbufferSample).r;
    vec3 radiance = texelFetch(emissiveTexture, at, gbufferSample).rgb;
    vec4 properties = texelFetch(propertiesTexture, at, gbufferSample);
    if (properties.w > 0.5) {
        vec2 ndc = ndcHere();
        vec3 p = viewPositionAt(eyeDistance(triangle, depth, ndc), ndc);
        Shading s = shadingAt(at, properties, p);
        radiance += ambient(s.baseColor, properties.z, s.n);
        for (uint group = 0u; group * LIGHTS_PER_GROUP < view.lightCount; ++group) {
            uint reaching = reachingLights(triangle, group, p);
            uint first = group * LIGHTS_PER_GROUP;
            uint count = min(view.lightCount - first, LIGHTS_PER_GROUP);
            for (uint i = 0u; i < count; ++i) {
                if ((reaching >> i & 1u) == 0u) continue;
                LightData light = lights[first + i];
                vec3 l;
                float strength = arriving(light, p, l);
                if (strength > 0.0) radiance += strength * light.color.rgb * reflectance(s, l);
            }
        }
    }
    outRadiance = vec4(radiance, 1.0);
}
