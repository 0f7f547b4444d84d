// SPDX-License-Identifier: Apache-2.0
// Corners of shadow volumes in clip space, and for what is seen edge-on the lines that bound it (see count.frag.glsl).
#include "geometry.glsl"
#include "view.glsl"

#ifdef EDGE_ON
// The lines near + t far, t >= 0, the same for all corners; the other borders are near to near and far to far.
layout(location = 0) flat out vec4 nearA;
layout(location = 1) flat out vec4 farA;
layout(location = 2) flat out vec4 nearB;
layout(location = 3) flat out vec4 farB;
#endif

#ifdef TALLY
layout(location = 4) flat out uint caster;
#endif

#ifdef PARTS
layout(std430, binding = BIND_PART_OF) readonly buffer PartOf { uint partOf[]; };        // by cluster, for each light
layout(std430, binding = BIND_CLUSTERS) readonly buffer Clusters { uint clusters[]; };  // per placed triangle
layout(location = FIRST_CLUSTER) uniform uint firstCluster;                              // of this light
layout(location = 5) flat out uint part;

uint partOfTriangle(uint placed) { return partOf[firstCluster + clusters[placed]]; }
#endif

vec4 nearCorner(uint instance, vec3 p) { return clipFromView(viewFromModel(instance, vec4(p, 1.0)), 1.0); }

/// The projection of p from the light to infinity.
vec4 farCorner(uint instance, vec3 p, vec4 light) {
    precise vec3 direction = p * light.w - light.xyz;
    return clipFromView(viewFromModel(instance, vec4(direction, 0.0)), 0.0);
}
