// SPDX-License-Identifier: Apache-2.0
// Cloths, furniture, lamps and the tree of the courtyard. Cloths and leaves are open sheets of one layer.
#include <fmt/format.h>

#include "courtyard.h"
#include "stage.h"

namespace generator {
namespace {

/// A hanging cloth of `width` x `drop` whose upper middle is the origin, facing +Z, in waves that grow downwards.
Shape banner(double width, double drop, double phaseDegrees) {
    return sheet(8, 14,
                 [&](double u, double v) {
                     const double wave = 0.09 * v * sinDegrees(360 * u + 200 * v + phaseDegrees) + 0.05 * v * v;
                     const double tail =
                         v == 1 ? 0.18 * std::abs(2 * u - 1) : 0.0;  // the lower edge rises to the middle
                     return dvec3((u - 0.5) * width * (1 - 0.06 * v), -drop * v - tail + 0.1 * v, wave);
                 },
                 {1, 1});
}

void addOpen(Document& document, const std::string& name, const Shape& shape, int material, const dvec3& at,
             double degrees = 0) {
    const int mesh =
        document.mesh(name, {{geometryOf(shape, {.creaseDegrees = 80, .texCoords = false}), material}}, Kind::Open);
    document.node({.name = name, .translation = at, .rotation = turn(degrees, {0, 1, 0}), .mesh = mesh});
}

}  // namespace

void addCloths(Document& document, const CourtyardMaterials& m) {
    const struct {
        const char* name;
        dvec3 at;
        double degrees;
        int cloth;
    } banners[] = {{"BannerNorthWest", {-3.1, 4.0, -6.55}, 0, m.redCloth},
                   {"BannerNorthEast", {3.1, 4.0, -6.55}, 0, m.blueCloth},
                   {"BannerWest1", {-7.05, 3.3, -2.6}, 90, m.blueCloth},
                   {"BannerWest2", {-7.05, 3.3, 1.4}, 90, m.redCloth}};
    double phase = 0;
    for (const auto& [name, at, degrees, cloth] : banners) {
        addOpen(document, name, banner(1.15, 2.2, phase += 70), cloth, at, degrees);
        const dvec3 along = turn(degrees, {0, 1, 0}) * dvec3(0.7, 0, 0);
        addPiece(document, (std::string(name) + "Rod").c_str(), bar(-along, along, 0.03, 8), m.iron, false, at);
    }

    const Shape awning = sheet(10, 8,
                               [](double u, double v) {
                                   const double sag =
                                       0.16 * smooth(1 - std::abs(2 * u - 1)) * smooth(1 - std::abs(2 * v - 1));
                                   return dvec3(mix(-7.2, -4.2, u), mix(2.9, 2.15, u) - sag, mix(-6.6, -3.4, v));
                               },
                               {1, 1});
    addOpen(document, "Awning", awning, m.ochreCloth, dvec3(0));

    // A line of pennants across the court.
    const auto lineAt = [](double t) {
        return glm::mix(dvec3(-7.2, 3.7, -1.0), dvec3(5.1, 3.6, 2.2), t) - dvec3(0, 1.1 * 4 * t * (1 - t) * 0.6, 0);
    };
    std::vector<dvec3> rope;
    for (int i = 0; i <= 24; ++i) rope.push_back(lineAt(i / 24.0));
    addPiece(document, "Line", tube(ringsAlong(rope, std::vector<double>(25, 0.014)), 5), m.leather, false);
    Shape pennants[3];
    Random random(7);
    for (int i = 0; i < 21; ++i) {
        const double t = (i + 0.7) / 21.6;
        const dvec3 a = lineAt(t - 0.014), b = lineAt(t + 0.014);
        const dvec3 sway{random.between(-0.08, 0.08), -0.42, random.between(-0.12, 0.12)};
        const dvec3 tip = (a + b) / 2.0 + sway;
        pennants[i % 3].triangle({.position = a}, {.position = tip}, {.position = b});
    }
    const int cloths[] = {m.redCloth, m.ochreCloth, m.blueCloth};
    for (int i = 0; i < 3; ++i) addOpen(document, fmt::format("Pennants{}", i + 1), pennants[i], cloths[i], dvec3(0));
}

void addFurniture(Document& document, const CourtyardMaterials& m) {
    Shape poles;
    for (const double z : {-6.4, -3.6}) poles.add(bar({-4.3, 0, z}, {-4.3, 2.2, z}, 0.05, 8));
    poles.add(bar({-4.25, 2.12, -6.6}, {-4.25, 2.12, -3.4}, 0.04, 8));
    addPiece(document, "AwningPoles", poles, m.bark, false);

    Shape crates =
        bevelledBox({-0.45, 0, -0.45}, {0.45, 0.9, 0.45}, 0.03).rotated(turn(12, {0, 1, 0})).moved({-6.2, 0, -5.4});
    crates.add(
        bevelledBox({-0.4, 0, -0.4}, {0.4, 0.7, 0.4}, 0.03).rotated(turn(-20, {0, 1, 0})).moved({-5.2, 0, -5.9}));
    crates.add(bevelledBox({-0.32, 0, -0.32}, {0.32, 0.6, 0.32}, 0.03)
                   .rotated(turn(35, {0, 1, 0}))
                   .moved({-6.15, 0.9, -5.35}));
    addPiece(document, "Crates", crates.boxMapped(1), m.wood, true);
    const Shape barrel = lathe(
        {{0, 0}, {0.3, 0}, {0.36, 0.25}, {0.38, 0.45}, {0.36, 0.65}, {0.3, 0.9}, {0.27, 0.9}, {0.27, 0.86}, {0, 0.86}},
        20, 1);
    addPiece(document, "Barrel1", barrel, m.wood, true, {-5.3, 0, -4.5});
    addPiece(document, "Barrel2", barrel, m.wood, true, {-6.5, 0, -4.1});

    Shape bench = bevelledBox({-0.25, 0.42, -1}, {0.25, 0.54, 1}, 0.03);
    for (const double z : {-0.7, 0.7}) bench.add(bevelledBox({-0.2, 0, z - 0.14}, {0.2, 0.43, z + 0.14}, 0.02));
    addPiece(document, "Bench", bench, m.stone, false, {-6.4, 0, 5.2});

    // A gallows for the swinging lamp.
    Shape gallows = bevelledBox({-0.09, 0, -0.09}, {0.09, 3.05, 0.09}, 0.02);
    gallows.add(bevelledBox({-0.2, 2.84, -0.07}, {1.15, 2.98, 0.07}, 0.02));
    gallows.add(bar({0.05, 2.3, 0}, {0.65, 2.86, 0}, 0.045, 8));
    gallows.add(bevelledBox({-0.32, 0, -0.32}, {0.32, 0.16, 0.32}, 0.03));
    addPiece(document, "Gallows", gallows.boxMapped(1), m.wood, true, {-3.9, 0, -1.6});

    // A framed pane of tinted glass, standing on the right.
    Shape frame;
    for (const double x : {-0.6, 0.6}) frame.add(bevelledBox({x - 0.045, 0, -0.045}, {x + 0.045, 1.75, 0.045}, 0.01));
    for (const double y : {0.3, 0.98, 1.66})
        frame.add(bevelledBox({-0.6, y - 0.035, -0.035}, {0.6, y + 0.035, 0.035}, 0.01));
    for (const double x : {-0.6, 0.6}) frame.add(bevelledBox({x - 0.06, 0, -0.3}, {x + 0.06, 0.08, 0.3}, 0.01));
    const dquat pose = turn(-24, {0, 1, 0});
    const dvec3 place{2.6, 0, 3.6};
    addPiece(document, "GlassFrame", frame.rotated(pose).boxMapped(1), m.wood, true, place);
    const Shape pane =
        sheet(1, 1, [](double u, double v) { return dvec3(mix(-0.56, 0.56, u), mix(1.63, 0.33, v), 0); }, {1, 1});
    addOpen(document, "Glass", pane.rotated(pose), m.glass, place);
}

void addPlantedTree(Document& document, const CourtyardMaterials& m) {
    const dvec3 place{3.5, 0, 1.2};
    const Shape pot = lathe({{0, 0},
                             {0.42, 0},
                             {0.5, 0.1},
                             {0.48, 0.16},
                             {0.62, 0.62},
                             {0.68, 0.66},
                             {0.68, 0.74},
                             {0.58, 0.74},
                             {0.56, 0.64},
                             {0, 0.64}},
                            24);
    addPiece(document, "Planter", pot, m.stone, false, place);

    Random random(3);
    Shape wood, leaves;
    const auto trunk = splineThrough({{0, 0.6, 0}, {0.06, 1.1, 0.03}, {-0.04, 1.6, 0.06}, {0.03, 2.1, 0}}, 8);
    wood.add(tube(ringsAlong(trunk, {0.09, 0.08, 0.075, 0.07, 0.06, 0.05, 0.035, 0}), 8));
    for (int i = 0; i < 9; ++i) {
        const double azimuth = 137.5 * i, base = 1.15 + 0.09 * i;
        const dvec3 out{sinDegrees(azimuth), 0, cosDegrees(azimuth)};
        const dvec3 start{0, base, 0.02};
        const double reach = random.between(0.5, 0.75), rise = random.between(0.25, 0.6);
        const dvec3 end = start + out * reach + dvec3(0, rise, 0);
        const dvec3 bend = (start + end) / 2.0 + dvec3(0, -0.06, 0);
        wood.add(tube(ringsAlong({start, bend, end}, {0.035, 0.022, 0}), 5));
        for (int k = 0; k < 26; ++k) {
            const double along = random.between(0.0, 1.15);
            const dvec3 off{random.between(-0.24, 0.24), random.between(-0.16, 0.26), random.between(-0.24, 0.24)};
            const dvec3 at = glm::mix(bend, end, along) + off;
            const double heading = random.between(0, 360), tilt = random.between(-50, 50);
            const dquat pose = turn(heading, {0, 1, 0}) * turn(tilt, {1, 0, 0});
            const double size = random.between(0.07, 0.11);
            const auto point = [&](double x, double z) {
                return Corner{.position = at + pose * (dvec3(x, x * x * 2, z) * size)};
            };
            leaves.quad(point(0, -1), point(-0.5, 0), point(0, 1), point(0.5, 0));
        }
    }
    addPiece(document, "TreeWood", wood, m.bark, false, place);
    const int mesh = document.mesh("Leaves", {{geometryOf(leaves, {.texCoords = false}), m.leaf}}, Kind::Open);
    document.node({.name = "Leaves", .translation = place, .mesh = mesh});
}

int addHangingLamp(Document& document, const CourtyardMaterials& m, const LightSpec& light, int parent,
                   const dvec3& hook, const dquat& rotation) {
    Shape body = bar({0, 0, 0}, {0, -0.13, 0}, 0.01, 6);
    body.add(lathe({{0, -0.16}, {0.15, -0.16}, {0.03, -0.1}, {0, -0.1}}, 8));
    body.add(lathe({{0, -0.48}, {0.11, -0.48}, {0.13, -0.45}, {0, -0.45}}, 8));
    for (int i = 0; i < 4; ++i) {
        const dvec3 corner{0.105 * cosDegrees(90 * i + 45), 0, 0.105 * sinDegrees(90 * i + 45)};
        body.add(bar(corner + dvec3(0, -0.46, 0), corner + dvec3(0, -0.15, 0), 0.009, 5));
    }
    // The flame stays below its light: everything opaque casts, and a light inside it would be put out.
    const Shape flame = lathe({{0, -0.45}, {0.03, -0.42}, {0.035, -0.39}, {0, -0.33}}, 8);
    const GeometryOptions plain{.texCoords = false};
    const int mesh =
        document.mesh(light.name + "Body", {{geometryOf(body, plain), m.iron}, {geometryOf(flame, plain), m.flame}});
    const int node = document.node(
        {.name = light.name + "Body", .parent = parent, .translation = hook, .rotation = rotation, .mesh = mesh});
    document.node({.name = light.name, .parent = node, .translation = {0, -0.3, 0}, .light = document.light(light)});
    return node;
}

}  // namespace generator
