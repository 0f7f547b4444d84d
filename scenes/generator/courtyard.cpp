// SPDX-License-Identifier: Apache-2.0
// The demo: a courtyard at dusk, cool moon against warm lamps. Lights move here; the sequence changes their
// intensities, colours, ranges and cones, and adds one of its own.
#include "courtyard.h"

#include "scenes.h"
#include "stage.h"
#include "textures.h"

namespace generator {

CourtyardMaterials courtyardMaterials(Document& document) {
    const auto textured = [&](const char* name, const Surface& surface) {
        const std::string prefix = name;
        return document.material({.name = name,
                                  .color = dvec3(1),
                                  .roughness = 1,
                                  .colorTexture = document.texture(prefix + "Color", surface.color),
                                  .normalTexture = document.texture(prefix + "Normal", surface.normal),
                                  .roughnessTexture = document.texture(prefix + "Roughness", surface.roughness)});
    };
    const auto plain = [&](const char* name, const dvec3& color, double roughness) {
        return document.material({.name = name, .color = color, .roughness = roughness});
    };
    const auto cloth = [&](const char* name, const dvec3& color) {
        return document.material({.name = name, .color = color, .roughness = 0.9, .doubleSided = true});
    };
    return {
        .paving = textured("Paving", pavingStones(512)),
        .brick = textured("Brick", bricks(512)),
        .wood = textured("Wood", planks(256)),
        .stone = plain("Stone", {0.56, 0.52, 0.45}, 0.8),
        .iron = plain("Iron", {0.07, 0.07, 0.075}, 0.5),
        .bronze =
            document.material({.name = "Bronze", .color = {0.72, 0.45, 0.2}, .roughness = 0.32, .metallic = 0.35}),
        .water = plain("Water", {0.03, 0.06, 0.07}, 0.12),
        .glass = document.material(
            {.name = "Glass", .color = {0.25, 0.55, 0.5}, .roughness = 0.15, .alpha = 0.3, .doubleSided = true}),
        .flame = document.material({.name = "Flame", .color = dvec3(0.1), .roughness = 1, .emissive = {6, 2.6, 0.6}}),
        .leaf = cloth("Leaf", {0.2, 0.38, 0.1}),
        .bark = plain("Bark", {0.24, 0.17, 0.12}, 0.9),
        .redCloth = cloth("RedCloth", {0.55, 0.07, 0.06}),
        .blueCloth = cloth("BlueCloth", {0.08, 0.16, 0.48}),
        .ochreCloth = cloth("OchreCloth", {0.7, 0.5, 0.22}),
        .tunic = plain("Tunic", {0.42, 0.1, 0.12}, 0.85),
        .skin = plain("Skin", {0.7, 0.48, 0.36}, 0.6),
        .leather = plain("Leather", {0.2, 0.13, 0.08}, 0.7)};
}

namespace {

/// A bowl of fire on a bracket or a foot; the light stands just above the flame.
void addFire(Document& document, const CourtyardMaterials& m, const LightSpec& light, const dvec3& at, double size) {
    const GeometryOptions plain{.texCoords = false};
    const Shape bowl =
        lathe({{0, -0.3}, {0.03, -0.28}, {0.04, -0.12}, {0.12, -0.02}, {0.13, 0.02}, {0.1, 0.02}, {0, -0.04}}, 12)
            .scaled(dvec3(size));
    const Shape flame = lathe({{0, -0.02}, {0.07, 0.02}, {0.06, 0.08}, {0, 0.2}}, 10).scaled(dvec3(size));
    const int mesh =
        document.mesh(light.name + "Fire", {{geometryOf(bowl, plain), m.iron}, {geometryOf(flame, plain), m.flame}});
    document.node({.name = light.name + "Fire", .translation = at, .mesh = mesh});
    addMovingLight(document, light, {at + dvec3(0, 0.26 * size, 0)});
}

void addLights(Document& document, const CourtyardMaterials& m) {
    // Low, over the viewer's left shoulder, and rising: long cool shadows that shorten.
    addAimedLight(document, {.name = "Moon", .type = "directional", .color = {0.5, 0.66, 1}, .intensity = 2},
                  {-9, 10, 8}, {{0, 3.2, -1}, {0, 2.4, -2.2}, {0, 1.6, -3.2}});

    const LightSpec swinging{.name = "SwingLamp", .color = {1, 0.72, 0.4}, .intensity = 34};
    const int lamp = addHangingLamp(document, m, swinging, kNone, {-2.85, 2.86, -1.6}, {1, 0, 0, 0});
    swing(document, lamp, {0.8, 0, 0.6}, 25, [](double t) { return 24 * sinDegrees(360 * t); });

    addFire(document, m, {.name = "TorchWest", .color = {1, 0.5, 0.2}, .intensity = 20, .rangeMetres = 9},
            {-6.75, 2.1, -0.6}, 1);
    addFire(document, m, {.name = "TorchNorth", .color = {1, 0.5, 0.2}, .intensity = 18, .rangeMetres = 9},
            {4.3, 2.2, -6.45}, 1);
    // Behind the gate: its light falls through the grille towards the viewer.
    addFire(document, m, {.name = "GateFire", .color = {1, 0.42, 0.14}, .intensity = 240}, {1.0, 1.95, -10.4}, 2.2);
    addPiece(document, "FirePillar",
             lathe({{0, 0}, {0.3, 0}, {0.3, 0.12}, {0.16, 0.2}, {0.13, 1.2}, {0.2, 1.32}, {0, 1.32}}, 16), m.stone,
             false, {1.0, 0, -10.4});

    const LightSpec arcade{.name = "ArcadeLamp", .color = {1, 0.8, 0.52}, .intensity = 75, .rangeMetres = 14};
    const int walking = addHangingLamp(document, m, arcade, kNone, {6.5, 2.1, -3.6}, {1, 0, 0, 0});
    document.translate(walking, evenly(kSequenceSeconds, 5),
                       {{6.5, 2.1, -3.6}, {6.5, 2.16, -2.4}, {6.5, 2.1, -1.2}, {6.5, 2.16, 0}, {6.5, 2.1, 1.2}});

    addPiece(document, "WatchBox", bevelledBox({-0.5, 0, -0.5}, {0.5, 0.5, 0.5}, 0.05).boxMapped(1), m.wood, true,
             {-6.6, 4.7, -7});
    addAimedLight(document,
                  {.name = "Searchlight",
                   .type = "spot",
                   .color = {0.6, 0.8, 1},
                   .intensity = 420,
                   .rangeMetres = 30,
                   .innerConeDegrees = 7,
                   .outerConeDegrees = 11},
                  {-6.2, 5.6, -6.4}, {{-3.5, 0, 3.2}, {-1.2, 0, 3.4}, {1.2, 0, 2.6}, {3.0, 0, 0.6}});
}

}  // namespace

void courtyard(Document& document) {
    const CourtyardMaterials materials = courtyardMaterials(document);
    addWalls(document, materials);
    addArcade(document, materials);
    addFountain(document, materials);
    addCloths(document, materials);
    addFurniture(document, materials);
    addPlantedTree(document, materials);
    addWalker(document, materials, {-1.35, 0, 3.2});
    addLights(document, materials);
    addCamera(document, "Dolly", 44, 0.1, {{-2.6, 2.3, 9.1}, {-1.6, 2.15, 8.9}, {-0.6, 2.05, 8.6}, {0.3, 2.0, 8.3}},
              {{-0.2, 1.35, 0}, {-0.25, 1.35, 0}, {-0.3, 1.35, 0}, {-0.35, 1.4, 0}});
    addCamera(document, "Overview", 50, 0.1, {{-6.4, 7.5, 9}}, {{0.4, 0.6, -1.4}});
}

}  // namespace generator
