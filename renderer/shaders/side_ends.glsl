// SPDX-License-Identifier: Apache-2.0
// Ends of edges from the one set of positions.
vec4 nearEnd(uint instance, uint vertex) {
    return nearCorner(instance, positionOf(instances[instance].vertexBase + vertex));
}

vec4 farEnd(uint instance, uint vertex, vec4 light) {
    return volumeEnd(instance, positionOf(instances[instance].vertexBase + vertex), light);
}
