// SPDX-License-Identifier: Apache-2.0
// Side quads cut by the plane from which near-cap counts: polygons of up to five corners, three triangles for each
// quad. The fan begins at the corner that comes first, whichever way round the quad runs, so that coincident ones are
// cut alike (R6).
// variant: EDGE_ON 1
// variant: TALLY 1, EDGE_ON 1
// variant: TALLY 1
#version 450 core
#extension GL_GOOGLE_include_directive : require
out gl_PerVertex { invariant vec4 gl_Position; };
#include "side_quad.glsl"
#include "side_ends.glsl"
#include "listed_edge.glsl"
#include "cut.glsl"

layout(location = 2) uniform uint firstSlot;

void main() {
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0);  // outside: dropped
    uint vertex = uint(gl_VertexID);
    ListedEdge side = listedEdge(firstSlot + vertex / 9u);
    bool reversed = runsReversed(side.instance, side.negative);
    uint vertexBase = instances[side.instance].vertexBase;
    vec4 lightInModel = lightOf(side.instance);
    dvec3 light = viewFromModelInDouble(side.instance, lightInModel);
    Corner corners[4];  // a, a', b', b
    corners[0] = nearCut(side.instance, positionOf(vertexBase + side.edge.a));
    corners[3] = nearCut(side.instance, positionOf(vertexBase + side.edge.b));
    corners[1] = farCut(corners[0], light, lightInModel.w);
    corners[2] = farCut(corners[3], light, lightInModel.w);
#ifdef TALLY
    caster = side.instance;
#endif
#ifdef EDGE_ON
    nearA = corners[0].clip;
    farA = corners[1].clip;
    nearB = corners[3].clip;
    farB = corners[2].clip;
#endif

    vec4 polygon[6];
    uint size = 0u;
    for (int i = 0; i < 4; ++i) {
        int next = (i + 1) & 3;
        if (isBeyond(corners[i])) polygon[size++] = corners[i].clip;
        if (isBeyond(corners[i]) != isBeyond(corners[next])) polygon[size++] = clipOfCut(corners[i], corners[next]);
    }
    uint triangle = vertex % 9u / 3u, corner = vertex % 3u;
    if (triangle + 2u >= size) return;
    uint ahead = (corner == 1u) != reversed ? 1u : 2u;
    gl_Position = polygon[corner == 0u ? 0u : triangle + ahead];
}
