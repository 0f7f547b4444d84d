// SPDX-License-Identifier: Apache-2.0
#include "stage.h"

namespace generator {

void addGround(Document& document, double halfSize, int cells, const dvec3& color) {
    const Shape shape = sheet(
        cells, cells,
        [&](double u, double v) { return dvec3(mix(-halfSize, halfSize, u), 0, mix(-halfSize, halfSize, v)); }, {1, 1});
    const int material = document.material({.name = "Ground", .color = color, .roughness = 0.9});
    const int mesh = document.mesh("Ground", {{geometryOf(shape, {.texCoords = false}), material}}, Kind::Receiver);
    document.node({.name = "Ground", .mesh = mesh});
}

int addMovingLight(Document& document, const LightSpec& spec, const std::vector<dvec3>& positions) {
    const int node =
        document.node({.name = spec.name, .translation = positions.front(), .light = document.light(spec)});
    if (positions.size() > 1)
        document.translate(node, evenly(kSequenceSeconds, static_cast<int>(positions.size())), positions);
    return node;
}

int addAimedLight(Document& document, const LightSpec& spec, const dvec3& from, const std::vector<dvec3>& to) {
    const int node = document.node(
        {.name = spec.name, .translation = from, .rotation = lookAt(from, to.front()), .light = document.light(spec)});
    if (to.size() > 1) {
        std::vector<dquat> keys;
        for (const dvec3& target : to) keys.push_back(lookAt(from, target));
        document.rotate(node, evenly(kSequenceSeconds, static_cast<int>(to.size())), keys);
    }
    return node;
}

int addCamera(Document& document, const char* name, double yfovDegrees, double znear,
              const std::vector<dvec3>& positions, const std::vector<dvec3>& targets) {
    const int node = document.node({.name = name,
                                    .translation = positions.front(),
                                    .rotation = lookAt(positions.front(), targets.front()),
                                    .camera = document.camera(name, yfovDegrees, znear)});
    if (positions.size() > 1) {
        const auto times = evenly(kSequenceSeconds, static_cast<int>(positions.size()));
        std::vector<dquat> rotations;
        for (std::size_t i = 0; i < positions.size(); ++i) rotations.push_back(lookAt(positions[i], targets[i]));
        document.translateSmoothly(node, times, positions);
        document.rotate(node, times, rotations);
    }
    return node;
}

int addSolid(Document& document, const char* name, const Shape& shape, int material, const dvec3& translation,
             double creaseDegrees) {
    const int mesh =
        document.mesh(name, {{geometryOf(shape, {.creaseDegrees = creaseDegrees, .texCoords = false}), material}});
    return document.node({.name = name, .translation = translation, .mesh = mesh});
}

void swing(Document& document, int node, const dvec3& axis, int keys, const std::function<double(double)>& degreesAt,
           const dquat& rest) {
    const auto times = evenly(kSequenceSeconds, keys);
    std::vector<dquat> values;
    for (const double time : times) values.push_back(rest * turn(degreesAt(time / kSequenceSeconds), axis));
    document.rotate(node, times, values);
}

}  // namespace generator
