// SPDX-License-Identifier: Apache-2.0
// Brabec & Seidel 2003, section 4.3: every edge is drawn as a quad whose corners fetch the edge's flags and positions
// from the textures, and leave the view when it is no silhouette. What the paper had to copy through the host, the
// vertex stage reads here.
// variant: EDGE_ON 1
// variant: TALLY 1, EDGE_ON 1
// variant: TALLY 1
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "every_edge.glsl"
#include "stored_edges.glsl"
#include "texels.glsl"

layout(std430, binding = BIND_QUADS) readonly buffer FirstTexels { uint firstTexels[]; };  // per instance

layout(binding = UNIT_EDGE_FLAGS) uniform usampler2D edgeFlags;  // see edge_texels.frag.glsl
layout(binding = UNIT_IN_VIEW) uniform sampler2D inView;         // see vertex_texels.frag.glsl
layout(binding = UNIT_IN_MODEL) uniform sampler2D inModel;

vec4 nearEnd(uint instance, uint vertex) {
    return clipFromView(texelFetch(inView, texelOf(firstTexels[instance] + vertex), 0).xyz, 1.0);
}

vec4 farEnd(uint instance, uint vertex, vec4 light) {
    return volumeEnd(instance, texelFetch(inModel, texelOf(firstTexels[instance] + vertex), 0).xyz, light);
}

void main() {
    gl_Position = kRejected;
    uint placed = uint(gl_VertexID) >> 2u;
    uvec4 flags = texelFetch(edgeFlags, texelOf(placed), 0) >> l & 1u;
    bool again = gl_InstanceID == 1;
    if ((flags.x | flags.y) == 0u || (again && flags.z == 0u)) return;
    uint instance;
    Edge edge;
    if (!findEdge(placed, instance, edge) || !isInList(instance, edge, flags.w != 0u)) return;
    setCorner(instance, edge, flags.y != 0u, uint(gl_VertexID) & 3u);
}
