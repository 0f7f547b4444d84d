// SPDX-License-Identifier: Apache-2.0
// Triangle soups into indexed vertices with normals, tangents, joints and morph targets, as glTF stores them.
#pragma once

#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <vector>

#include "shapes.h"

namespace generator {

struct GeometryOptions {
    double creaseDegrees = 40;  // faces that meet at more than this keep their own normals; 180: all smooth
    bool texCoords = true;      // off: one vertex per position where all is smooth
    bool tangents = false;      // for normal maps
    bool joints = false;
    /// One per morph target: where a position goes.
    std::vector<std::function<dvec3(const dvec3&)>> targets{};
};

struct MorphDelta {
    std::vector<glm::vec3> positions, normals;
};

struct Geometry {
    std::vector<glm::vec3> positions, normals;
    std::vector<glm::vec4> tangents;
    std::vector<glm::vec2> texCoords;
    std::vector<glm::u8vec4> joints;
    std::vector<glm::vec4> weights;
    std::vector<MorphDelta> targets;
    std::vector<std::uint32_t> indices;
};

Geometry geometryOf(const Shape& shape, const GeometryOptions& options = {});

}  // namespace generator
