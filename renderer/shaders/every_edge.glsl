// SPDX-License-Identifier: Apache-2.0
// For techniques that draw every edge, of which only those in one list of one light shall show.
#include "side_quad.glsl"

layout(location = 2) uniform uint facingBase;
layout(location = 3) uniform uint l;     // the light's place in its group
layout(location = 4) uniform uint list;  // LIST_... (+ LIST_EDGE_ON)

/// Outside the view: a primitive with all its corners there is dropped.
const vec4 kRejected = vec4(2.0, 2.0, 2.0, 1.0);

bool isInList(uint instance, Edge edge, bool edgeOn) {
    return listOf(instance, l, (edge.left & EDGE_EVEN) != 0u) + (edgeOn ? LIST_EDGE_ON : 0u) == list;
}
