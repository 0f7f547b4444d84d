// SPDX-License-Identifier: Apache-2.0
#include "scene/scene.h"

#include <algorithm>

namespace umbrage {

std::uint32_t Mesh::triangleCount() const {
    std::uint32_t indexCount = 0;
    for (const Primitive& primitive : primitives) {
        if (primitive.topology == Topology::Triangles) {
            indexCount += primitive.indexCount;
        }
    }
    return indexCount / 3;
}

double Animation::durationSeconds() const {
    double seconds = 0.0;
    for (const Track& track : tracks) seconds = std::max(seconds, double(track.timesSeconds.back()));
    return seconds;
}

}  // namespace umbrage
