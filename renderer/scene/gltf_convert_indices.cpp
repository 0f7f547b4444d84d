// SPDX-License-Identifier: Apache-2.0
#include "scene/gltf_convert_indices.h"

#include <fmt/format.h>

#include <numeric>

namespace umbrage {
namespace {

using Indices = std::vector<std::uint32_t>;

Indices readIndices(const GltfConversion& conversion, const tinygltf::Primitive& primitive, std::uint32_t vertexCount,
                    const std::string& pointer) {
    if (primitive.indices < 0) {
        conversion.budget.spend(std::uint64_t{vertexCount} * sizeof(std::uint32_t), conversion.file, pointer);
        Indices indices(vertexCount);
        std::iota(indices.begin(), indices.end(), 0u);
        return indices;
    }
    const std::string place = pointer + "/indices";
    Indices indices = conversion.reader.integers(primitive.indices, place);
    const int componentType = conversion.model.accessors[static_cast<std::size_t>(primitive.indices)].componentType;
    const std::uint32_t restart = componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE    ? 0xFFu
                                  : componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ? 0xFFFFu
                                                                                            : 0xFFFFFFFFu;
    for (std::size_t i = 0; i < indices.size(); ++i) {
        if (indices[i] >= vertexCount) {
            failAt(conversion.file, place,
                   fmt::format("index {} of accessor {} is {}, but there are {} vertices", i, primitive.indices,
                               indices[i], vertexCount));
        }
        if (indices[i] == restart) {
            failAt(conversion.file, place,
                   fmt::format("index {} is {}, the primitive restart value, which glTF forbids", i, restart));
        }
    }
    return indices;
}

// The formulas of glTF 2.0, 3.7.2.1.
Indices linesOf(const Indices& v, bool closed) {
    Indices lines;
    lines.reserve(v.size() * 2);
    for (std::size_t i = 0; i + 1 < v.size(); ++i) {
        lines.insert(lines.end(), {v[i], v[i + 1]});
    }
    if (closed && v.size() > 2) {
        lines.insert(lines.end(), {v.back(), v.front()});
    }
    return lines;
}

Indices trianglesOfStrip(const Indices& v) {
    Indices triangles;
    triangles.reserve(v.size() * 3);
    for (std::size_t i = 0; i + 2 < v.size(); ++i) {
        triangles.insert(triangles.end(), {v[i], v[i + 1 + i % 2], v[i + 2 - i % 2]});
    }
    return triangles;
}

Indices trianglesOfFan(const Indices& v) {
    Indices triangles;
    triangles.reserve(v.size() * 3);
    for (std::size_t i = 0; i + 2 < v.size(); ++i) {
        triangles.insert(triangles.end(), {v[i + 1], v[i + 2], v[0]});
    }
    return triangles;
}

}  // namespace

ElementList listElements(const GltfConversion& conversion, const tinygltf::Primitive& primitive,
                         std::uint32_t vertexCount, const std::string& pointer) {
    Indices v = readIndices(conversion, primitive, vertexCount, pointer);
    const bool isConnected = primitive.mode != TINYGLTF_MODE_POINTS && primitive.mode != TINYGLTF_MODE_LINE &&
                             primitive.mode != TINYGLTF_MODE_TRIANGLES;
    if (isConnected) {
        conversion.budget.spend(v.size() * 3 * sizeof(std::uint32_t), conversion.file, pointer);
    }
    switch (primitive.mode) {
        case TINYGLTF_MODE_POINTS:
            return {Topology::Points, std::move(v)};
        case TINYGLTF_MODE_LINE_LOOP:
            return {Topology::Lines, linesOf(v, true)};
        case TINYGLTF_MODE_LINE_STRIP:
            return {Topology::Lines, linesOf(v, false)};
        case TINYGLTF_MODE_TRIANGLE_STRIP:
            return {Topology::Triangles, trianglesOfStrip(v)};
        case TINYGLTF_MODE_TRIANGLE_FAN:
            return {Topology::Triangles, trianglesOfFan(v)};
        default:
            break;
    }
    const bool isLines = primitive.mode == TINYGLTF_MODE_LINE;
    if (const std::size_t rest = v.size() % (isLines ? 2 : 3); rest != 0) {
        conversion.notes.add(pointer,
                             fmt::format("{} vertices at the end make no whole element and are ignored", rest));
        v.resize(v.size() - rest);
    }
    return {isLines ? Topology::Lines : Topology::Triangles, std::move(v)};
}

}  // namespace umbrage
