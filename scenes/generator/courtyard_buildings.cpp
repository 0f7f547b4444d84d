// SPDX-License-Identifier: Apache-2.0
// Ground, walls with the gate, arcade and fountain of the courtyard.
#include <fmt/format.h>

#include "courtyard.h"
#include "stage.h"

namespace generator {
namespace {

/// The masonry over a round opening of half width `radius` about x = 0: from the springing line up to `top`.
Shape overArch(double radius, double spring, double top, double back, double front) {
    std::vector<dvec2> lower, upper;
    for (int i = 0; i <= 16; ++i) {
        const double degrees = 180 - 180.0 * i / 16;
        lower.push_back({radius * cosDegrees(degrees), spring + radius * sinDegrees(degrees)});
        upper.push_back({lower.back().x, top});
    }
    return plate(lower, upper, back, front);
}

/// The dressed stones round an arch, wedge by wedge, standing out from the wall.
Shape voussoirs(double radius, double spring, double thickness, int count, double back, double front) {
    Shape result;
    for (int i = 0; i < count; ++i) {
        std::vector<dvec2> lower, upper;
        for (int k = 0; k <= 2; ++k) {
            const double degrees = 180 - 180.0 * (i + 0.04 + 0.46 * k) / count;
            const dvec2 out{cosDegrees(degrees), sinDegrees(degrees)};
            lower.push_back(dvec2(0, spring) + out * (radius - 0.03));
            upper.push_back(dvec2(0, spring) + out * (radius + thickness + (i == count / 2 ? 0.12 : 0)));
        }
        result.add(plate(lower, upper, back, front));
    }
    return result;
}

Shape arcadeColumn() {
    Shape result = bevelledBox({-0.27, 0, -0.27}, {0.27, 0.18, 0.27}, 0.03);
    result.add(lathe({{0, 0.18},
                      {0.25, 0.18},
                      {0.26, 0.22},
                      {0.22, 0.28},
                      {0.17, 0.32},
                      {0.19, 1.0},
                      {0.16, 1.9},
                      {0.2, 1.95},
                      {0.16, 2.0},
                      {0.2, 2.1},
                      {0.27, 2.2},
                      {0, 2.2}},
                     20));
    return result.add(bevelledBox({-0.3, 2.2, -0.3}, {0.3, 2.36, 0.3}, 0.03));
}

}  // namespace

int addPiece(Document& document, const char* name, const Shape& shape, int material, bool textured,
             const dvec3& translation, Kind kind) {
    const GeometryOptions options{.creaseDegrees = 35, .texCoords = textured, .tangents = textured};
    const int mesh = document.mesh(name, {{geometryOf(shape, options), material}}, kind);
    return document.node({.name = name, .translation = translation, .mesh = mesh});
}

void addWalls(Document& document, const CourtyardMaterials& m) {
    const Shape ground =
        sheet(9, 12, [](double u, double v) { return dvec3(mix(-9, 9, u), 0, mix(-14, 10, v)); }, {9, 12});
    addPiece(document, "Ground", ground, m.paving, true, dvec3(0), Kind::Receiver);

    // North, with the gate; the pieces overlap a little so that none share an edge.
    Shape north = overArch(1.35, 2.1, 4.6, -0.3, 0.3);
    north.add(box({-7.8, 0, -0.3}, {-1.35, 4.62, 0.3})).add(box({1.35, 0, -0.3}, {7.8, 4.62, 0.3}));
    for (int i = 0; i < 13; ++i)
        north.add(bevelledBox({-7.7 + 1.22 * i, 4.5, -0.34}, {-7.0 + 1.22 * i, 5.2, 0.34}, 0.04));
    addPiece(document, "NorthWall", north.boxMapped(1.6), m.brick, true, {0, 0, -7});
    Shape trim = voussoirs(1.35, 2.1, 0.34, 13, -0.36, 0.36);
    for (const double side : {-1.0, 1.0})
        for (int i = 0; i < 5; ++i)
            trim.add(bevelledBox({side * 1.5 - 0.19, 0.42 * i + 0.005, -0.36},
                                 {side * 1.5 + 0.19, 0.42 * i + 0.415, 0.36}, 0.025));
    addPiece(document, "GateTrim", trim, m.stone, false, {0, 0, -7});

    Shape grille;  // half raised
    for (int i = -3; i <= 3; ++i) grille.add(bar({0.36 * i, 1.0, 0.02}, {0.36 * i, 3.6, 0.02}, 0.028, 6));
    for (const double y : {1.2, 1.9, 2.6}) grille.add(bar({-1.4, y, -0.03}, {1.4, y, -0.03}, 0.024, 6));
    addPiece(document, "Portcullis", grille, m.iron, false, {0, 0, -7});

    Shape west = box({-0.3, 0, -7}, {0.3, 3.7, 9.4});
    for (const double z : {-4.6, -0.6, 3.4, 7.4}) {
        west.add(box({0.2, 0, z - 0.3}, {0.75, 2.4, z + 0.3}).bent([](const dvec3& p) {
            return p.x > 0.5 && p.y > 1 ? p - dvec3(0.3, 0, 0) : p;
        }));
    }
    addPiece(document, "WestWall", west.boxMapped(1.6), m.brick, true, {-7.5, 0, 0});
    Shape coping = bevelledBox({-0.38, 3.68, -7.2}, {0.38, 3.84, 9.4}, 0.04);
    addPiece(document, "WestCoping", coping, m.stone, false, {-7.5, 0, 0});
    addPiece(document, "SouthWall", box({-7.8, 0, -0.3}, {8.2, 2.6, 0.3}).boxMapped(1.6), m.brick, true, {0, 0, 9.7});
    addPiece(document, "Beyond", box({-4.5, 0, -0.3}, {4.5, 3.4, 0.3}).boxMapped(1.6), m.brick, true, {0, 0, -13});
}

void addArcade(Document& document, const CourtyardMaterials& m) {
    constexpr double kX = 5.1, kBay = 2.8, kFirst = -6.3;
    const int column = document.mesh("ArcadeColumn", {{geometryOf(arcadeColumn(), {.texCoords = false}), m.stone}});
    const Shape arch = overArch(1.08, 2.36, 3.8, -0.24, 0.24)
                           .add(box({-1.42, 2.3, -0.23}, {-1.08, 3.81, 0.23}))
                           .add(box({1.08, 2.3, -0.23}, {1.42, 3.81, 0.23}));
    const int archMesh = document.mesh(
        "ArcadeArch",
        {{geometryOf(arch.rotated(turn(90, {0, 1, 0})).boxMapped(1.6), {.creaseDegrees = 35, .tangents = true}),
          m.brick}});
    const Shape ring = voussoirs(1.08, 2.36, 0.2, 9, -0.28, 0.28).rotated(turn(90, {0, 1, 0}));
    const int ringMesh = document.mesh("ArcadeRing", {{geometryOf(ring, {.texCoords = false}), m.stone}});
    for (int i = 0; i <= 5; ++i) {
        const double z = kFirst + kBay * i;
        document.node({.name = fmt::format("Column{}", i + 1), .translation = {kX, 0, z}, .mesh = column});
        if (i == 5) break;
        const dvec3 middle{kX, 0, z + kBay / 2};
        document.node({.name = fmt::format("Arch{}", i + 1), .translation = middle, .mesh = archMesh});
        document.node({.name = fmt::format("Ring{}", i + 1), .translation = middle, .mesh = ringMesh});
    }
    addPiece(document, "EastWall", box({-0.3, 0, -7}, {0.3, 4.2, 9.4}).boxMapped(1.6), m.brick, true, {7.8, 0, 0});
    Shape roof =
        box({4.7, 3.8, -7.05}, {8.2, 4.0, 9.2}).bent([](const dvec3& p) { return p.x > 6 ? p + dvec3(0, 0.7, 0) : p; });
    addPiece(document, "ArcadeRoof", roof.boxMapped(1), m.wood, true);
}

void addFountain(Document& document, const CourtyardMaterials& m) {
    const dvec3 place{0, 0, -1.2};
    Shape stone = lathe({{1.25, 0.12},
                         {1.25, 0},
                         {1.7, 0},
                         {1.7, 0.12},
                         {1.55, 0.2},
                         {1.5, 0.5},
                         {1.62, 0.58},
                         {1.62, 0.66},
                         {1.36, 0.66},
                         {1.32, 0.5},
                         {1.25, 0.12}},
                        32);
    stone.add(lathe({{0, 0},
                     {0.5, 0},
                     {0.46, 0.3},
                     {0.24, 0.42},
                     {0.2, 0.95},
                     {0.3, 1.05},
                     {0.75, 1.2},
                     {0.8, 1.3},
                     {0.72, 1.3},
                     {0.3, 1.18},
                     {0.22, 1.3},
                     {0.22, 1.55},
                     {0.3, 1.62},
                     {0, 1.62}},
                    28));
    addPiece(document, "Fountain", stone, m.stone, false, place);
    addPiece(document, "Water", lathe({{0, 0.02}, {1.3, 0.02}, {1.34, 0.48}, {0, 0.48}}, 32), m.water, false, place);

    // The morphing body: a ball of bronze that grows six spikes, or stretches into a twisted drop.
    const auto spiky = [](const dvec3& p) {
        const double far = std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) / 0.42;
        return p * (0.62 + 0.8 * far * far * far * far * far * far);
    };
    const auto drop = [](const dvec3& p) {
        const dquat twist = turn(260 * p.y, {0, 1, 0});
        const double waist = 0.55 + 0.55 * p.y * p.y / 0.18;
        return twist * dvec3(p.x * waist * 1.25, p.y * 1.45, p.z * waist * 0.7);
    };
    const Shape ball = icosphere(3).scaled(dvec3(0.42));
    const GeometryOptions options{.creaseDegrees = 180, .texCoords = false, .targets = {spiky, drop}};
    const int mesh = document.mesh("Spirit", {{geometryOf(ball, options), m.bronze}});
    const int node = document.node({.name = "Spirit", .translation = place + dvec3(0, 2.12, 0), .mesh = mesh});
    const auto times = evenly(kSequenceSeconds, 5);
    document.weigh(node, times, {0.9, 0, 0.35, 0.35, 0, 1, 0.35, 0.35, 0.9, 0});
    swing(document, node, {0, 1, 0}, 9, [](double t) { return 180 * t; });
}

}  // namespace generator
