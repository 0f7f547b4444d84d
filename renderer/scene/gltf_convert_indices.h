// SPDX-License-Identifier: Apache-2.0
// Indices of glTF primitives: every mode becomes a list of triangles, lines or points.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "scene/gltf_convert.h"

namespace umbrage {

struct ElementList {
    Topology topology = Topology::Triangles;
    std::vector<std::uint32_t> indices;  // relative to the primitive's first vertex
};

/// @throws Error(Input) for an index that names no vertex
ElementList listElements(const GltfConversion& conversion, const tinygltf::Primitive& primitive,
                         std::uint32_t vertexCount, const std::string& pointer);

}  // namespace umbrage
