// SPDX-License-Identifier: Apache-2.0
// What the silhouette passes share: lights in model space and which list a caster's quads go to.
#include "caster_lists.glsl"
layout(std430, binding = BIND_LIGHTS_IN_MODEL) readonly buffer LightsInModel { vec4 lightsInModel[]; };
layout(std430, binding = BIND_SUMMARY) buffer Summaries { LightSummary summaries[]; };

layout(location = 2) uniform uint lightCount;  // of this group
layout(location = 3) uniform uint firstLight;  // of this group, in all
layout(location = 4) uniform uint totalLights;
layout(location = 5) uniform uint countLit;

/// (position, 1) or (direction towards the light, 0), of light l of this group.
vec4 lightInModel(uint instance, uint l) { return lightsInModel[instance * totalLights + firstLight + l]; }

#ifdef PARTS
// Counting by parts: each has its own constants and hazards, of both ends of the view rays.
layout(std430, binding = BIND_PARTS) buffer Parts { SplitPart parts[]; };
layout(std430, binding = BIND_PART_OF) readonly buffer PartOf { uint partOf[]; };        // by cluster, for each light
layout(std430, binding = BIND_CLUSTERS) readonly buffer Clusters { uint clusters[]; };  // per placed triangle
layout(location = 8) uniform uint clusterCount;

uint partOfTriangle(uint placed, uint l) { return partOf[l * clusterCount + clusters[placed]]; }
#endif
