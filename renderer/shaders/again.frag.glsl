// SPDX-License-Identifier: Apache-2.0
// Opaque surfaces drawn again for what the G-buffer does not hold: IDS, MOTION, or one for each fragment, to be added up.
// variant: IDS 1
// variant: MOTION 1
// variant: ALPHA_TEST 1
#version 450 core
#extension GL_GOOGLE_include_directive : require
#ifndef ALPHA_TEST
layout(early_fragment_tests) in;
#endif
#include "view.glsl"
#include "material.glsl"

#if defined(IDS)
layout(std430, binding = BIND_INSTANCES) readonly buffer Instances { InstanceData instances[]; };
layout(location = 0) out uvec4 outIds;
#elif defined(MOTION)
layout(location = 6) in vec3 previousViewPosition;
layout(location = 1) uniform vec2 previousRayScale;
layout(location = 0) out vec4 outMotion;

/// In pixels from the middle of the picture, to the right and down.
vec2 pixelOf(vec3 p, vec2 rayScale) {
    vec2 ndc = p.xy / (rayScale * (view.perspective != 0u ? -p.z : 1.0));
    return vec2(ndc.x, -ndc.y) / view.pixelSize;
}
#else
layout(std430, binding = BIND_FILL) buffer Fragments { uint fragmentsOf[]; };  // per material, samples
layout(location = 0) out vec4 outCount;
#endif

void main() {
#ifdef ALPHA_TEST
    if (surfaceHere().alpha < material.emissive.w) discard;
#endif
#if defined(IDS)
    uint first = drawn.y == NO_TRIANGLE ? 0u : drawn.y - instances[drawn.x].placedTriangleBase;
    outIds = uvec4(drawn.x, material.entry, first + uint(gl_PrimitiveID), 0u) + 1u;
#elif defined(MOTION)
    bool wasBehind = view.perspective != 0u && previousViewPosition.z >= 0.0;
    vec2 motion = pixelOf(viewPosition, view.rayScale.xy) - pixelOf(previousViewPosition, previousRayScale);
    outMotion = vec4(wasBehind ? vec2(0.0) : motion, 0.0, 0.0);
#else
    atomicAdd(fragmentsOf[material.entry], uint(bitCount(gl_SampleMaskIn[0])));
    outCount = vec4(1.0);
#endif
}
