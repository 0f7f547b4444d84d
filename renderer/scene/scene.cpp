// SPDX-License-Identifier: Apache-2.0
#include "scene/scene.h"

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

}  // namespace umbrage
