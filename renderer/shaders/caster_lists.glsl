// SPDX-License-Identifier: Apache-2.0
// Which list a caster's side quads go to.
layout(std430, binding = BIND_CASTERS) buffer Casters { CasterState casters[]; };

/// @param l  a light of the group; @param even  the edge's component has only edges of even valence
uint listOf(uint instance, uint l, bool even) {
    if ((casters[instance].countedByFail >> l & 1u) != 0u) return LIST_FAIL;
    bool halved = even && (instances[instance].flags & INSTANCE_WHOLE) == 0u && (casters[instance].lightOn >> l & 1u) == 0u;
    return halved ? LIST_HALVED : LIST_WHOLE;
}
