// SPDX-License-Identifier: Apache-2.0
// Laine's KNIGHT and 16KNIGHTS: figures of 634 triangles, closed pieces on jointed nodes, fighting in pairs.
#include <fmt/format.h>

#include "scenes.h"
#include "stage.h"

namespace generator {
namespace {

constexpr std::size_t kTriangles = 634;

struct Colors {
    int steel, cloth, leather;
};

/// Meshes of the limbs in the space of their joint; the figure looks along +Z and is 1.85 m tall.
struct Limbs {
    int hips, torso, head, upperArm, swordArm, shieldArm, thigh, shin;
};

Shape limb(double topRadius, double bottomRadius, double length, int rings) {
    std::vector<dvec3> path;
    std::vector<double> radii;
    for (int i = 0; i < rings; ++i) {
        const double t = static_cast<double>(i) / (rings - 1);
        path.push_back({0, -length * t, 0});
        radii.push_back(mix(topRadius, bottomRadius, t) * (i > 0 && i + 1 < rings ? 1.18 : 1));
    }
    return tube(ringsAlong(path, radii), 6);
}

Shape sword() {
    Shape result =
        tube(ringsAlong({{0, 0.12, 0}, {0, 0.8, 0}, {0, 0.95, 0}}, {0.036, 0.03, 0}), 4).scaled({1, 1, 0.35});
    result.add(box({-0.11, 0.085, -0.02}, {0.11, 0.125, 0.02}));
    result.add(bar({0, -0.08, 0}, {0, 0.1, 0}, 0.018, 4));
    result.add(lathe({{0, -0.15}, {0.035, -0.11}, {0, -0.07}}, 4));
    return result.rotated(turn(68, {1, 0, 0}));
}

Shape shield() {
    const Shape flat = plate({{-0.27, -0.08}, {-0.15, -0.38}, {0, -0.52}, {0.15, -0.38}, {0.27, -0.08}},
                             {{-0.27, 0.3}, {-0.15, 0.33}, {0, 0.34}, {0.15, 0.33}, {0.27, 0.3}}, 0, 0.03);
    return flat.bent([](const dvec3& p) { return dvec3(p.x, p.y, p.z - 1.2 * p.x * p.x); })
        .rotated(turn(90, {1, 0, 0}))  // the forearm is held level: its -Y looks forward, its +Z up
        .moved({0, -0.1, 0});
}

Limbs makeLimbs(Document& document, const Colors& colors) {
    const auto mesh = [&](const char* name, const std::vector<std::pair<Shape, int>>& shapes) {
        std::vector<Part> parts;
        for (const auto& [shape, material] : shapes)
            parts.push_back({geometryOf(shape, {.creaseDegrees = 50, .texCoords = false}), material});
        return document.mesh(name, parts);
    };
    const auto [steel, cloth, leather] = colors;

    const Shape skirt = lathe({{0, -0.28}, {0.24, -0.3}, {0.2, -0.05}, {0.16, 0.1}, {0, 0.12}}, 8).scaled({1, 1, 0.8});
    const Shape scabbard = tube(ringsAlong({{0, 0, 0}, {0, -0.6, 0}, {0, -0.72, 0}}, {0.04, 0.032, 0}), 4)
                               .scaled({0.5, 1, 1})
                               .rotated(turn(28, {1, 0, 0}))
                               .moved({0.2, 0.02, 0.02});
    const Shape chest =
        lathe({{0, 0.02}, {0.165, 0.02}, {0.18, 0.2}, {0.235, 0.38}, {0.2, 0.5}, {0.08, 0.56}, {0, 0.57}}, 10)
            .scaled({1, 1, 0.68});
    const Shape pauldron = lathe({{0, -0.1}, {0.1, -0.07}, {0.095, 0.03}, {0, 0.08}}, 6).moved({0.27, 0.46, 0});
    Shape pauldrons = pauldron;
    pauldrons.add(pauldron.mirrored());
    const Shape helmet = lathe({{0, 0}, {0.085, -0.02}, {0.125, 0.06}, {0.12, 0.2}, {0.07, 0.29}, {0, 0.33}}, 10)
                             .bent([](const dvec3& p) { return dvec3(p.x * 0.92, p.y, p.z > 0 ? p.z * 1.18 : p.z); });
    const Shape plume =
        tube(ringsAlong({{0, 0.27, 0.05}, {0, 0.4, -0.02}, {0, 0.39, -0.16}, {0, 0.25, -0.25}, {0, 0.02, -0.24}},
                        {0.02, 0.045, 0.055, 0.045, 0}),
             4);
    const Shape arm = limb(0.06, 0.05, 0.29, 2), forearm = limb(0.055, 0.05, 0.25, 2);
    const Shape hand = box({-0.04, -0.33, -0.045}, {0.04, -0.25, 0.045});
    const Shape foot = box({-0.05, -0.46, -0.08}, {0.05, -0.37, 0.19}).bent([](const dvec3& p) {
        return p.z > 0 ? dvec3(p.x, std::min(p.y, -0.42), p.z) : p;
    });
    Shape swordHand = hand, shieldHand = hand;
    const dvec3 grip{0, -0.29, 0};

    return {.hips = mesh("Hips", {{skirt, cloth}, {scabbard, leather}}),
            .torso = mesh("Torso", {{chest, cloth}, {pauldrons, steel}}),
            .head = mesh("Head", {{helmet, steel}, {plume, cloth}}),
            .upperArm = mesh("UpperArm", {{arm, steel}}),
            .swordArm = mesh("SwordArm", {{swordHand.add(forearm).add(sword().moved(grip)), steel}}),
            .shieldArm = mesh("ShieldArm", {{shieldHand.add(forearm), steel}, {shield().moved(grip), cloth}}),
            .thigh = mesh("Thigh", {{limb(0.085, 0.065, 0.44, 2), steel}}),
            .shin = mesh("Shin", {{Shape(limb(0.062, 0.05, 0.42, 3)).add(foot), steel}})};
}

/// The same limbs in other colours; the geometry's bytes are shared.
Limbs recolour(Document& document, const Limbs& l, const Colors& c) {
    const auto copy = [&](const char* name, int mesh, const std::vector<int>& materials) {
        return document.recoloured(name, mesh, materials);
    };
    Limbs result = l;  // arms and legs of steel alone stay as they are
    result.hips = copy("Hips2", l.hips, {c.cloth, c.leather});
    result.torso = copy("Torso2", l.torso, {c.cloth, c.steel});
    result.head = copy("Head2", l.head, {c.steel, c.cloth});
    result.shieldArm = copy("ShieldArm2", l.shieldArm, {c.steel, c.cloth});
    return result;
}

/// One figure that strikes and steps; `phase` in [0, 1) shifts it in time.
int addFigure(Document& document, const std::string& name, const Limbs& limbs, int parent, const dvec3& place,
              double headingDegrees, double phase) {
    const int root = document.node(
        {.name = name, .parent = parent, .translation = place, .rotation = turn(headingDegrees, {0, 1, 0})});
    const auto joint = [&](const char* part, int above, const dvec3& at, int mesh) {
        return document.node({.name = name + part, .parent = above, .translation = at, .mesh = mesh});
    };
    const int hips = joint("Hips", root, {0, 0.9, 0}, limbs.hips);
    const int torso = joint("Torso", hips, {0, 0.08, 0}, limbs.torso);
    const int head = joint("Head", torso, {0, 0.58, 0}, limbs.head);
    const int armR = joint("ArmR", torso, {-0.27, 0.44, 0}, limbs.upperArm);
    const int foreR = joint("ForearmR", armR, {0, -0.28, 0}, limbs.swordArm);
    const int armL = joint("ArmL", torso, {0.27, 0.44, 0}, limbs.upperArm);
    const int foreL = joint("ForearmL", armL, {0, -0.28, 0}, limbs.shieldArm);
    const int thighR = joint("ThighR", hips, {-0.11, -0.04, 0}, limbs.thigh);
    const int shinR = joint("ShinR", thighR, {0, -0.42, 0}, limbs.shin);
    const int thighL = joint("ThighL", hips, {0.11, -0.04, 0}, limbs.thigh);
    const int shinL = joint("ShinL", thighL, {0, -0.42, 0}, limbs.shin);

    constexpr int kKeys = 9;
    const dvec3 x{1, 0, 0}, y{0, 1, 0};
    const auto wave = [phase](double t, double lag) { return sinDegrees(360 * (t + phase - lag)); };
    const auto swingBy = [&](int node, const dvec3& axis, double rest, double amount, double lag) {
        swing(document, node, axis, kKeys, [&](double t) { return rest + amount * wave(t, lag); });
    };
    swingBy(torso, y, -6, 22, 0);
    swingBy(head, y, 6, -14, 0);
    swingBy(armR, x, -75, 55, 0.05);
    swingBy(foreR, x, -50, 35, 0.15);
    swingBy(armL, x, -34, 10, 0.5);
    swingBy(foreL, x, -58, 8, 0.6);
    swingBy(thighR, x, 4, 24, 0.25);
    swingBy(shinR, x, 16, 14, 0.4);
    swingBy(thighL, x, -10, -20, 0.25);
    swingBy(shinL, x, 18, -14, 0.4);
    std::vector<dvec3> steps;
    for (const double time : evenly(kSequenceSeconds, kKeys)) {
        const double t = time / kSequenceSeconds;
        const dvec3 forward{sinDegrees(headingDegrees), 0, cosDegrees(headingDegrees)};
        steps.push_back(place + forward * (0.14 * wave(t, 0.1)) + dvec3(0, 0.015 * (1 + wave(2 * t, 0)), 0));
    }
    document.translate(root, evenly(kSequenceSeconds, kKeys), steps);
    document.promise(name + "'s triangles", document.castersUnder(root).triangles, kTriangles);
    return root;
}

Colors makeColors(Document& document, const char* name, const dvec3& cloth) {
    return {document.material({.name = "Steel", .color = {0.62, 0.63, 0.66}, .roughness = 0.38, .metallic = 0.25}),
            document.material({.name = name, .color = cloth, .roughness = 0.75}),
            document.material({.name = "Leather", .color = {0.3, 0.19, 0.11}, .roughness = 0.7})};
}

}  // namespace

void knight(Document& document) {
    const Limbs limbs = makeLimbs(document, makeColors(document, "Crimson", {0.6, 0.1, 0.08}));
    addGround(document, 10, 8, {0.56, 0.54, 0.48});
    addFigure(document, "Knight", limbs, kNone, dvec3(0), 20, 0);
    addMovingLight(document, {.name = "Lamp", .color = {1, 0.9, 0.75}, .intensity = 70},
                   {{-2.6, 3, 2}, {-1, 3.4, 2.8}, {1.2, 3.4, 2.6}, {2.8, 3, 1.8}});
    addCamera(document, "Camera", 42, 0.05, {{2.2, 1.8, 3.6}, {0.2, 2, 4.2}, {-2.2, 1.8, 3.6}},
              {{0, 0.9, 0}, {0, 0.9, 0}, {0, 0.9, 0}});
}

void knights(Document& document) {
    const Limbs red = makeLimbs(document, makeColors(document, "Crimson", {0.6, 0.1, 0.08}));
    const Limbs blue = recolour(document, red, makeColors(document, "Azure", {0.1, 0.2, 0.55}));
    addGround(document, 16, 8, {0.56, 0.54, 0.48});
    Random random(16);
    for (int i = 0; i < 8; ++i) {
        const dvec3 centre{(i % 4 - 1.5) * 2.1 + random.between(-0.25, 0.25), 0,
                           (i / 4 - 0.5) * 3 + random.between(-0.3, 0.3)};
        const double heading = random.between(0, 360);
        const int pair = document.node({.name = fmt::format("Pair{}", i + 1), .translation = centre});
        swing(document, pair, {0, 1, 0}, 5, [&](double t) { return heading + 50 * t; });
        const double phase = random.between(0, 1);
        addFigure(document, fmt::format("Red{}", i + 1), red, pair, {0, 0, -0.72}, 0, phase);
        addFigure(document, fmt::format("Blue{}", i + 1), blue, pair, {0, 0, 0.72}, 180, phase + 0.5);
    }
    document.promise("triangles of all figures", document.casters().triangles, 16 * kTriangles);
    addMovingLight(document, {.name = "Lamp", .color = {1, 0.9, 0.75}, .intensity = 260},
                   {{-6, 4.6, 3}, {-2, 5.4, 4.2}, {2.5, 5.2, 3.8}, {6, 4.4, 1}});
    addCamera(document, "Camera", 45, 0.1, {{5, 4, 8.2}, {0.5, 4.6, 9.2}, {-4.5, 3.6, 8}},
              {{0, 0.5, 0}, {0, 0.5, 0}, {0, 0.5, 0}});
}

}  // namespace generator
