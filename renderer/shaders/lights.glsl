// SPDX-License-Identifier: Apache-2.0
// Punctual lights (KHR_lights_punctual): candela and lux, range window, spot cones.
#include "shared.h"
#include "brdf.glsl"

layout(std430, binding = BIND_LIGHTS) readonly buffer Lights { LightData lights[]; };

/// What arrives at p on a surface that faces the light: irradiance at normal incidence in rgb's units; 0 out of range
/// or cone. `l` becomes the unit direction to the light.
float arriving(LightData light, vec3 p, out vec3 l) {
    if (light.position.w == 0.0) {
        l = light.position.xyz;
        return light.color.w;
    }
    vec3 d = light.position.xyz - p;
    float d2 = max(dot(d, d), 1e-12);
    l = d * inversesqrt(d2);
    float ratio = d2 * light.direction.w;  // (distance / range)^2
    float window = clamp(1.0 - ratio * ratio, 0.0, 1.0);
    float cone = clamp(dot(light.direction.xyz, -l) * light.cone.x + light.cone.y, 0.0, 1.0);
    return light.color.w * window * cone * cone / d2;
}

vec3 ambient(vec3 baseColor, float occlusion, vec3 n) {
    float up = 0.5 + 0.5 * dot(n, view.upInView.xyz);
    return baseColor * occlusion * mix(view.ambientGround.rgb, view.ambientSky.rgb, up);
}
