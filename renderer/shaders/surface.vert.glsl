// SPDX-License-Identifier: Apache-2.0
// Visible geometry: for the G-buffer, for blended surfaces and for the search for exposed back faces; with MOTION also
// where the eye of the frame before saw it.
// variant: MOTION 1
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "geometry.glsl"
#include "view.glsl"

layout(std430, binding = BIND_DRAWS) readonly buffer Draws { DrawData draws[]; };

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 tangent;
layout(location = 3) in vec2 texCoord0;
layout(location = 4) in vec2 texCoord1;
layout(location = 5) in vec4 color;
layout(location = 6) in uint draw;  // advances with the base instance

layout(location = 0) out vec3 viewPosition;
layout(location = 1) out vec3 viewNormal;
layout(location = 2) out vec4 viewTangent;
layout(location = 3) out vec4 texCoords;
layout(location = 4) out vec4 vertexColor;
layout(location = 5) flat out uvec3 drawn;  // instance, first placed triangle, flags

#ifdef MOTION
layout(std430, binding = BIND_PREVIOUS) readonly buffer Previous { vec4 previousViewFromModel[]; };  // 3 rows each
layout(location = 7) in vec3 previousPosition;
layout(location = 6) out vec3 previousViewPosition;
#endif

out gl_PerVertex {
    invariant vec4 gl_Position;
    float gl_PointSize;
};

void main() {
    uint instance = draws[draw].instance;
    vec3 p = viewFromModel(instance, vec4(position, 1.0));
    gl_Position = clipFromView(p, 1.0);
    gl_PointSize = 1.0;
    viewPosition = p;
    viewNormal = vec3(dot(instances[instance].normalFromModel[0].xyz, normal),
                      dot(instances[instance].normalFromModel[1].xyz, normal),
                      dot(instances[instance].normalFromModel[2].xyz, normal));
    viewTangent = vec4(viewFromModel(instance, vec4(tangent.xyz, 0.0)), tangent.w);
    if ((instances[instance].flags & INSTANCE_MIRRORED) != 0u) viewTangent.w = -viewTangent.w;
    texCoords = vec4(texCoord0, texCoord1);
    vertexColor = color;
#ifdef MOTION
    // The same expressions as above: what stands still does not move.
    precise vec3 before;
    before.x = dot(previousViewFromModel[3u * instance], vec4(previousPosition, 1.0));
    before.y = dot(previousViewFromModel[3u * instance + 1u], vec4(previousPosition, 1.0));
    before.z = dot(previousViewFromModel[3u * instance + 2u], vec4(previousPosition, 1.0));
    previousViewPosition = before;
#endif
    drawn = uvec3(instance, draws[draw].firstPlacedTriangle, draws[draw].flags);
}
