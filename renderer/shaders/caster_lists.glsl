// SPDX-License-Identifier: Apache-2.0
// Which list a caster's side quads go to.
layout(std430, binding = BIND_CASTERS) buffer Casters { CasterState casters[]; };

/// Of light l of the group: 1 + the face of its extent that the caster's volume ends behind, or 0.
uint endOfVolume(uint instance, uint l) { return casters[instance].ends[l / 10u] >> (3u * (l % 10u)) & 7u; }

/// Whether the far ends of view rays may lie in the caster's volume: those of an orthographic eye are infinitely far,
/// where volumes that end are not. A perspective eye sees no end: its counts from infinity begin before the dark cap.
bool mayHoldFarEnds(uint instance, uint l) {
    return instances[instance].eyeInModel.w == 0.0 && endOfVolume(instance, l) == 0u;
}

/// @param l  a light of the group; @param even  the edge's component has only edges of even valence
uint listOf(uint instance, uint l, bool even) {
    if ((casters[instance].countedByFail >> l & 1u) != 0u) return LIST_FAIL;
    bool halved = even && (instances[instance].flags & INSTANCE_WHOLE) == 0u && (casters[instance].lightOn >> l & 1u) == 0u;
    return halved ? LIST_HALVED : LIST_WHOLE;
}
