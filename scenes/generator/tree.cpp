// SPDX-License-Identifier: Apache-2.0
// Laine's TREE and TREE-DECOMPOSED: a bare tree of a trunk and 48 branches, each a closed tapering tube with a tip. A
// tube of k rings of n points has 2nk - 2 triangles; the table below adds up to his count (an even one: closed).
#include <fmt/format.h>

#include "scenes.h"
#include "stage.h"

namespace generator {
namespace {

constexpr std::size_t kTriangles = 2172, kParts = 49;

struct Branch {
    std::vector<dvec3> path;  // base to tip
    double radius = 0;        // at the base

    dvec3 at(double t) const {
        const double place = t * static_cast<double>(path.size() - 1);
        const auto i = std::min(static_cast<std::size_t>(place), path.size() - 2);
        return glm::mix(path[i], path[i + 1], place - static_cast<double>(i));
    }
};

struct Generation {
    int count, sides, rings, parentsFirst, parentsCount;
    double lengthMetres, rise, fromT, toT;
};

Branch grow(Random& random, const Branch& parent, const Generation& g, double azimuth, double t) {
    const double length = g.lengthMetres * random.between(0.8, 1.2) * (1.25 - 0.6 * t);
    const dvec3 base = parent.at(t), along = glm::normalize(parent.at(std::min(1.0, t + 0.1)) - parent.at(t - 0.05));
    dvec3 side = dvec3(sinDegrees(azimuth), 0, cosDegrees(azimuth));
    side = glm::normalize(side - along * glm::dot(side, along));
    dvec3 direction = glm::normalize(side + along * g.rise);
    Branch branch{{base}, parent.radius * (1 - 0.85 * t) * 0.75};
    for (int i = 0; i < g.rings; ++i) {
        branch.path.push_back(branch.path.back() + direction * (length / g.rings));
        const dvec3 wander{random.between(-0.3, 0.3), random.between(0.02, 0.3), random.between(-0.3, 0.3)};
        direction = glm::normalize(direction + wander);
    }
    return branch;
}

std::vector<Shape> treeParts() {
    Random random(2005);
    std::vector<Branch> branches{
        {splineThrough({{0, 0, 0}, {0.12, 1.1, 0.05}, {-0.05, 2.3, 0.12}, {0.1, 3.5, -0.02}, {0.02, 4.5, 0.1}}, 12),
         0.26}};
    std::vector<Shape> parts;
    const auto addPart = [&](const Branch& b, int sides) {
        std::vector<double> radii;
        const std::size_t last = b.path.size() - 1;
        for (std::size_t i = 0; i < last; ++i)
            radii.push_back(b.radius * (1 - 0.85 * static_cast<double>(i) / static_cast<double>(last)));
        if (b.path.front().y == 0) radii.front() *= 1.5;  // the root flare
        radii.push_back(0);
        parts.push_back(tube(ringsAlong(b.path, radii), sides));
    };
    addPart(branches.front(), 10);
    const Generation generations[] = {{8, 6, 6, 0, 1, 2.1, 0.9, 0.3, 0.88},    // limbs on the trunk
                                      {25, 5, 4, 1, 8, 1.15, 0.9, 0.3, 0.9},   // branches on the limbs
                                      {12, 4, 4, 9, 25, 0.6, 1.0, 0.4, 0.85},  // twigs on the branches
                                      {3, 5, 3, 9, 25, 0.7, 1.2, 0.5, 0.8}};
    double azimuth = 0;
    for (const Generation& g : generations)
        for (int i = 0; i < g.count; ++i) {
            azimuth += 137.5;  // the golden angle spreads neighbours
            const auto parent = static_cast<std::size_t>(g.parentsFirst + (g.count > 8 ? i : i * 7) % g.parentsCount);
            const double t = mix(g.fromT, g.toT, (i + random.between(0, 0.9)) / g.count);
            branches.push_back(grow(random, branches[parent], g, azimuth, t));
            addPart(branches.back(), g.sides);
        }
    return parts;
}

void setStage(Document& document) {
    addGround(document, 14, 8, {0.55, 0.56, 0.5});
    addMovingLight(document, {.name = "Lamp", .color = {1, 0.9, 0.75}, .intensity = 260},
                   {{-4.5, 6, 3}, {-2, 7, 4.5}, {2, 6.5, 4.5}, {4.5, 6, 3}});
    addCamera(document, "Camera", 45, 0.1, {{3.5, 3, 8.5}, {0.5, 3.4, 9.4}, {-3.5, 2.8, 8.6}},
              {{0, 2.2, 0}, {0, 2.1, 0}, {0, 2.2, 0}});
}

int barkOf(Document& document) {
    return document.material({.name = "Bark", .color = {0.45, 0.34, 0.25}, .roughness = 0.9});
}

void promiseFigures(Document& document, std::size_t parts) {
    document.promise("triangles of the tree", document.casters().triangles, kTriangles);
    document.promise("closed pieces", document.casters().pieces, kParts);
    document.promise("parts", parts, kParts);
}

}  // namespace

void tree(Document& document) {
    const std::vector<Shape> parts = treeParts();
    Shape whole;
    for (const Shape& part : parts) whole.add(part);
    addSolid(document, "Tree", whole, barkOf(document), dvec3(0), 70);
    setStage(document);
    promiseFigures(document, parts.size());
}

void treeDecomposed(Document& document) {
    const std::vector<Shape> parts = treeParts();
    const int bark = barkOf(document);
    const int root = document.node({.name = "Tree"});
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const std::string name = fmt::format("Branch{:02}", i);
        const int mesh = document.mesh(name, {{geometryOf(parts[i], {.creaseDegrees = 70, .texCoords = false}), bark}});
        document.node({.name = name, .parent = root, .mesh = mesh});
    }
    setStage(document);
    promiseFigures(document, parts.size());
}

}  // namespace generator
