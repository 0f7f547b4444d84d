// SPDX-License-Identifier: Apache-2.0
// A vaulted hall of many triangles and few meshes, placed by node instances, with 32 lights of limited range. The nave
// runs along -Z in bays of 4 m.
#include <fmt/format.h>

#include "scenes.h"
#include "stage.h"

namespace generator {
namespace {

constexpr int kBays = 10;
constexpr double kBay = 4, kNaveHalf = 4, kHallHalf = 8, kSpring = 4.6;

Shape column() {
    Shape result = lathe(resampled({{0.0, 0.5}, {0.42, 0.5}, {0.36, 4.1}, {0, 4.1}}, 18), 48).bent([](const dvec3& p) {
        const double radius = std::sqrt(p.x * p.x + p.z * p.z);
        if (radius < 0.3) return p;
        // Sixteen flutes; cos(16 a) by doubling cos(a) four times, without an arc function.
        double wave = p.z / radius;
        for (int i = 0; i < 4; ++i) wave = 2 * wave * wave - 1;
        const double groove = 1 - 0.035 * (1 + wave);
        return dvec3(p.x * groove, p.y, p.z * groove);
    });
    result.add(bevelledBox({-0.6, 0, -0.6}, {0.6, 0.25, 0.6}, 0.04));
    result.add(lathe({{0, 0.25},
                      {0.56, 0.25},
                      {0.6, 0.3},
                      {0.56, 0.36},
                      {0.46, 0.4},
                      {0.46, 0.44},
                      {0.5, 0.48},
                      {0.44, 0.52},
                      {0, 0.52}},
                     32));
    result.add(lathe(
        {{0, 4.05}, {0.4, 4.05}, {0.44, 4.1}, {0.4, 4.15}, {0.46, 4.25}, {0.56, 4.36}, {0.6, 4.4}, {0, 4.4}}, 32));
    result.add(bevelledBox({-0.65, 4.4, -0.65}, {0.65, kSpring, 0.65}, 0.04));
    for (int i = 0; i < 12; ++i)
        result.add(sphere(0.09, 8, 6).scaled({1, 1.5, 1}).moved({0, 4.22, 0.48}).rotated(turn(30 * i, {0, 1, 0})));
    return result;
}

/// Half a circle of `radius` in the plane of x and y over the springing line, then a flat top at `top`.
Shape arch(double radius, double thickness, double top, double back, double front) {
    std::vector<dvec2> lower, upper;
    for (int i = 0; i <= 20; ++i) {
        const double degrees = 180 - 9.0 * i;
        lower.push_back({radius * cosDegrees(degrees), radius * sinDegrees(degrees)});
        const double outer = radius + thickness;
        upper.push_back(top > 0 ? dvec2(lower.back().x, top)
                                : dvec2(outer * cosDegrees(degrees), outer * sinDegrees(degrees)));
    }
    return plate(lower, upper, back, front);
}

/// A round moulding along half a circle.
Shape roll(double radius, double thickness, int points, int sides) {
    std::vector<Ring> rings;
    for (int i = 0; i < points; ++i) {
        const double degrees = 180 - 180.0 * i / (points - 1);
        const dvec3 out{cosDegrees(degrees), sinDegrees(degrees), 0};
        rings.push_back({out * radius, out * thickness, dvec3(0, 0, thickness)});
    }
    return tube(rings, sides);
}

Shape tile() {
    Shape result = bevelledBox({-0.5, -0.12, -0.5}, {0.5, 0, 0.5}, 0.02);
    return result.add(lathe({{0, -0.05}, {0.3, -0.05}, {0.3, 0.004}, {0.26, 0.012}, {0.12, 0.006}, {0, 0.012}}, 16));
}

Shape bench() {
    Shape result = bevelledBox({-1.2, 0.4, -0.22}, {1.2, 0.46, 0.22}, 0.015);
    result.add(bevelledBox({-1.2, 0.5, 0.2}, {1.2, 0.95, 0.25}, 0.015).rotated(turn(4, {1, 0, 0})));
    for (const double x : {-1.1, 0.0, 1.1}) result.add(bevelledBox({x - 0.04, 0, -0.2}, {x + 0.04, 0.42, 0.2}, 0.01));
    return result;
}

Shape baluster() {
    return lathe({{0, 0},
                  {0.09, 0},
                  {0.09, 0.06},
                  {0.05, 0.1},
                  {0.085, 0.25},
                  {0.08, 0.34},
                  {0.035, 0.55},
                  {0.055, 0.6},
                  {0.05, 0.66},
                  {0.09, 0.7},
                  {0.09, 0.75},
                  {0, 0.75}},
                 12);
}

/// The origin is the hook in the vault; the ring of candles hangs 3.4 m below it on a chain of links.
Shape chandelier() {
    Shape result = torus({0.8, 0.8}, 0.035, 0.05, 32, 10).moved({0, -3.4, 0});
    for (int i = 0; i < 8; ++i) {
        const dvec3 place{0.8 * cosDegrees(45 * i), -3.4, 0.8 * sinDegrees(45 * i)};
        result.add(lathe({{0, 0.03}, {0.07, 0.05}, {0.025, 0.07}, {0.025, 0.24}, {0, 0.26}}, 10).moved(place));
        if (i % 2 == 0) result.add(bar({place.x / 20, -2.3, place.z / 20}, place, 0.012, 6));
    }
    return result;
}

/// A bay of the side wall at x = 0 facing +X, from z = -2 to 2, with a window from 2.2 m to a round top at 5.2 m.
Shape wallBay() {
    Shape result = arch(0.8, 0, 4.6, -0.25, 0.25).moved({0, 4.4, 0});
    result.add(box({-2, 0, -0.3}, {2, 2.2, 0.3}));  // the pieces overlap, so that no two share an edge
    result.add(box({-2, 2.1, -0.25}, {-0.8, 9.1, 0.25}));
    result.add(box({0.8, 2.1, -0.25}, {2, 9.1, 0.25}));
    result.add(bar({0, 2.2, 0}, {0, 5.2, 0}, 0.05, 8));
    for (const double y : {3.2, 4.2}) result.add(bar({-0.8, y, 0}, {0.8, y, 0}, 0.035, 8));
    return result.rotated(turn(90, {0, 1, 0}));
}

Shape vaultBay() {
    Shape result = arch(kNaveHalf, 0.3, 0, -kBay / 2, kBay / 2);
    for (int i = 1; i < 8; ++i)
        for (const double z : {-1.0, 1.0})
            result.add(bevelledBox({-0.5, kNaveHalf - 0.1, z - 0.6}, {0.5, kNaveHalf + 0.05, z + 0.6}, 0.05)
                           .rotated(turn(90 - 22.5 * i, {0, 0, 1})));
    return result;
}

/// 5 chandeliers, 16 torches, 8 moonlit windows and 3 wisps.
void addLights(Document& document, int chandelierMesh, int linkMesh) {
    int lights = 0;
    for (int i = 0; i < 5; ++i, ++lights) {
        const std::string name = fmt::format("Chandelier{}", i + 1);
        const int node = document.node({.name = name, .translation = {0, 8.5, -4.0 - 8 * i}, .mesh = chandelierMesh});
        document.node(
            {.name = name + "Light",
             .parent = node,
             .translation = {0, -3.0, 0},
             .light = document.light({.name = name, .color = {1, 0.78, 0.48}, .intensity = 55, .rangeMetres = 11})});
        for (int k = 0; k < 14; ++k)
            document.node({.name = fmt::format("{}Link{}", name, k + 1),
                           .parent = node,
                           .translation = {0, -0.08 - 0.16 * k, 0},
                           .rotation = turn(k % 2 ? 90 : 0, {0, 1, 0}) * turn(90, {0, 0, 1}),
                           .mesh = linkMesh});
        if (i < 2) swing(document, node, {0, 0, 1}, 17, [i](double t) { return 5 * sinDegrees(360 * t + 90 * i); });
    }
    for (int i = 0; i < 16; ++i, ++lights) {
        const double side = i % 2 ? 1 : -1;
        addMovingLight(
            document,
            {.name = fmt::format("Torch{}", i + 1), .color = {1, 0.55, 0.25}, .intensity = 14, .rangeMetres = 6},
            {{side * (kHallHalf - 0.7), 2.4, -4.0 - kBay * (i / 2)}});
    }
    for (int i = 0; i < 8; ++i, ++lights) {
        const double z = -2.0 - kBay * (i + 1);
        const dvec3 from{-kHallHalf - 4, 8, z + 1.5}, to{-1, 0, z};
        const LightSpec spec{.name = fmt::format("Window{}", i + 1),
                             .type = "spot",
                             .color = {0.55, 0.7, 1},
                             .intensity = 420,
                             .rangeMetres = 22,
                             .innerConeDegrees = 8,
                             .outerConeDegrees = 14};
        if (i < 2)
            addAimedLight(document, spec, from, {to - dvec3(0, 0, 0.6), to, to + dvec3(0, 0, 0.6)});
        else
            addAimedLight(document, spec, from, {to});
    }
    const dvec3 wisps[] = {{0.6, 1, 0.8}, {0.8, 0.7, 1}, {1, 0.9, 0.6}};
    for (int i = 0; i < 3; ++i, ++lights) {
        std::vector<dvec3> path;
        for (int k = 0; k < 9; ++k)
            path.push_back(
                {(i - 1) * 1.8 + 0.9 * sinDegrees(45 * k), 1.2 + 0.3 * cosDegrees(90 * k), -7.0 - 5 * i - 0.5 * k});
        addMovingLight(document,
                       {.name = fmt::format("Wisp{}", i + 1), .color = wisps[i], .intensity = 8, .rangeMetres = 7},
                       path);
    }
    document.promise("lights", lights, 32);
}

}  // namespace

void hall(Document& document) {
    const int stone = document.material({.name = "Stone", .color = {0.66, 0.62, 0.54}, .roughness = 0.85});
    const int floor = document.material({.name = "Floor", .color = {0.5, 0.42, 0.36}, .roughness = 0.5});
    const int plaster = document.material({.name = "Plaster", .color = {0.7, 0.68, 0.62}, .roughness = 0.9});
    const int wood = document.material({.name = "Wood", .color = {0.38, 0.24, 0.14}, .roughness = 0.7});
    const int iron = document.material({.name = "Iron", .color = {0.25, 0.24, 0.23}, .roughness = 0.5});
    const auto mesh = [&](const char* name, const Shape& shape, int material) {
        return document.mesh(name, {{geometryOf(shape, {.texCoords = false}), material}});
    };
    int count = 0;
    const auto place = [&](int m, const dvec3& at, double degrees = 0) {
        document.node(
            {.name = fmt::format("N{}", ++count), .translation = at, .rotation = turn(degrees, {0, 1, 0}), .mesh = m});
    };

    const int columnMesh = mesh("Column", column(), stone), tileMesh = mesh("Tile", tile(), floor);
    const int benchMesh = mesh("Bench", bench(), wood), balusterMesh = mesh("Baluster", baluster(), stone);
    const int wallMesh = mesh("WallBay", wallBay(), plaster), vaultMesh = mesh("VaultBay", vaultBay(), plaster);
    const int sideArch = mesh(
        "SideArch", Shape(arch(kBay / 2 - 0.5, 0, 2.2, -0.35, 0.35)).add(roll(kBay / 2 - 0.5, 0.12, 24, 10)), stone);
    const int rib = mesh("Rib", roll(kNaveHalf, 0.2, 40, 12), stone);
    const int clerestory = mesh("Clerestory", box({-2, 0, -0.2}, {2, 0.9, 0.2}), plaster);
    const int railing = mesh("Railing", bevelledBox({-1.9, 0.75, -0.12}, {1.9, 0.87, 0.12}, 0.02), stone);
    const int aisleRoof = mesh("AisleRoof", box({-2, 7.4, -2.2}, {2, 7.7, 2.2}), wood);
    const int endWall = mesh("EndWall", box({-kHallHalf - 0.5, 0, -0.25}, {kHallHalf + 0.5, 9.5, 0.25}), plaster);

    for (int bay = 0; bay < kBays; ++bay) {
        const double z = -kBay * bay - kBay / 2;
        place(vaultMesh, {0, kSpring, z});
        place(rib, {0, kSpring, z + kBay / 2});
        for (const double side : {-1.0, 1.0}) {
            place(columnMesh, {side * kNaveHalf, 0, z + kBay / 2});
            place(wallMesh, {side * kHallHalf, 0, z});
            place(sideArch, {side * kNaveHalf, kSpring, z}, 90);
            place(clerestory, {side * kNaveHalf, kSpring + 2.2, z}, 90);
            place(aisleRoof, {side * (kNaveHalf + 2.2), 0, z}, 90);
            place(benchMesh, {side * 1.9, 0, z + 1});
            place(benchMesh, {side * 1.9, 0, z - 1});
            place(railing, {side * 6.4, 0, z}, 90);
            for (int k = 0; k < 15; ++k) place(balusterMesh, {side * 6.4, 0, z - 1.75 + 0.25 * k});
        }
        for (int x = 0; x < 16; ++x)
            for (int k = 0; k < 4; ++k) place(tileMesh, {x - 7.5, 0, z - 1.5 + k}, 90 * ((x + k) % 2));
    }
    place(endWall, {0, 0, -kBay * kBays - 0.25});
    place(endWall, {0, 0, 3});
    const int chandelierMesh = mesh("Chandelier", chandelier(), iron);
    const int linkMesh = mesh("Link", torus({0.09, 0.045}, 0.014, 0.014, 12, 6), iron);
    addLights(document, chandelierMesh, linkMesh);
    addCamera(document, "Camera", 55, 0.1, {{0.6, 1.9, 1.5}, {0.2, 2.1, -0.5}, {-0.4, 2.3, -2.5}},
              {{0, 2.9, -14}, {0, 2.9, -16}, {0.3, 2.9, -18}});
    document.promise("at least 250,000 triangles", std::min<std::size_t>(document.everything().triangles, 250000),
                     250000);
}

}  // namespace generator
