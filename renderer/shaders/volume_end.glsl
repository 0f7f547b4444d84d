// SPDX-License-Identifier: Apache-2.0
// Where volumes end, their sides and their dark caps in the same bits: behind all that the light shines on (T2), at a
// distance, or else at infinity (w = 0).
#include "corners.glsl"
#include "caster_lists.glsl"

layout(std430, binding = BIND_LIGHTS_IN_MODEL) readonly buffer LightsInModel { vec4 lightsInModel[]; };

layout(location = 0) uniform uint lightIndex;  // of all
layout(location = 1) uniform uint totalLights;
layout(location = VOLUME_END) uniform float endMetres;  // from the light, of a directional one from the caster; or 0
layout(location = EXTENT_FACES) uniform vec4 extentFaces[6];

vec4 lightOf(uint instance) { return lightsInModel[instance * totalLights + lightIndex]; }

uint endOf(uint instance) { return endOfVolume(instance, lightIndex % LIGHTS_PER_GROUP); }

/// The end of the volume over p, in model space.
vec4 volumeEnd(uint instance, vec3 p, vec4 light) {
    uint face = endOf(instance);
    if (face == 0u && endMetres == 0.0) return farCorner(instance, p, light);
    precise vec3 direction = p * light.w - light.xyz;
    vec3 inView = viewFromModel(instance, vec4(p, 1.0)), away = viewFromModel(instance, vec4(direction, 0.0));
    precise float times;
    if (face == 0u) {
        precise float metres = length(away);
        times = max(endMetres - light.w * metres, 0.0) / metres;
    } else {
        vec4 plane = extentFaces[face - 1u];
        times = (plane.w - dot(plane.xyz, inView)) / dot(plane.xyz, away);
    }
    precise vec3 end = inView + times * away;
    return clipFromView(end, 1.0);
}
