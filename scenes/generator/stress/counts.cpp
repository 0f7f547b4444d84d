// SPDX-License-Identifier: Apache-2.0
// Stress family E: how many layers, triangles, lights.
#include "stress/floating.h"

namespace generator::stress {
namespace {

const std::string kWrap = "a stencil of 8 bits that wraps to 0";

/// Plates of 2 m x 2 m between two heights, a node each.
void addPlates(Document& document, const std::string& name, int count, double low, double high, bool closed = false) {
    const int material = paint(document, name, kCasterColor, true);
    const Mesh plate = closed ? box({-1, 0, -1}, {1, 0.0009765625, 1}) : grid({-1, 0, 1}, {2, 0, 0}, {0, 0, -2}, 1, 1);
    const int mesh = document.mesh(name, {partOf(plate, material)}, closed ? Kind::Closed : Kind::Open);
    for (int i = 0; i < count; ++i)
        document.node(
            {.name = name + std::to_string(i), .translation = {0, mix(low, high, 1.0 * i / count), 0}, .mesh = mesh});
}

std::string lookAtStack() {
    return sequence({.camera = eye(at({1.2, 4.2, 6.2}), at({-0.6, 0.7, -0.2}), 46),
                     .lights = {pointLight("Lamp", at({3, 6, 1}), 7)}});
}

Case stacked(const std::string& id, int plates) {
    const auto fill = [=](Document& document) {
        addGround(document, 9);
        addPlates(document, "Plate", plates, 2, 2.25);
    };
    return {id,
            std::to_string(plates) + " plates, a triangle pair each, between the light and the ground",
            "the ground below is dark",
            kWrap,
            fill,
            lookAtStack()};
}

Case coincident() {
    const auto fill = [](Document& document) {
        addGround(document, 9);
        Mesh mesh;
        for (int i = 0; i < 256; ++i) mesh.add(grid({-1, 2, 1}, {2, 0, 0}, {0, 0, -2}, 1, 1));
        place(document, "Plates", mesh, paint(document, "Plates", kCasterColor, true), Kind::Open);
    };
    return {"E1-5",
            "256 plates in the same place, in one mesh",
            "the ground below is dark",
            "multiplicities cut to 8 bits, or drawn as often",
            fill,
            lookAtStack()};
}

Case closedPlates() {
    const auto fill = [](Document& document) {
        addGround(document, 9);
        addPlates(document, "Plate", 128, 2, 2.25, true);
    };
    return {"E1-6",
            "128 closed plates: 256 layers where every triangle counts",
            "the ground below is dark",
            kWrap,
            fill,
            lookAtStack()};
}

Case underPlates() {
    const auto fill = [](Document& document) {
        addGround(document, 9);
        addPlates(document, "Above", 256, 2.5, 4.5);
        addPlates(document, "Below", 44, 0.125, 0.5);
        place(document, "Ball", icosphere({1.6, 0.7, -1.8}, 0.7, 2), paint(document, "Ball", dvec3(0.4, 0.5, 0.7)));
    };
    return {"E2",
            "the eye under 256 of 300 plates, the other 44 below it",
            "the shadow of plates and ball on the ground, as with rays; lit ground around it",
            "a count at the eye taken modulo 256 as one in the light",
            fill,
            sequence({.camera = eye(at({0.2, 1.9, 0.9}), at({0.6, 0.3, -2}), 75),
                      .lights = {pointLight("Lamp", at({0.5, 7, 0.25}), 7)}})};
}

/// A crown of 40 boughs with 1,000 loose leaves each over a trunk.
Case leaves() {
    const auto fill = [](Document& document) {
        addGround(document, 12);
        Random random(23);
        Mesh bough;
        for (int i = 0; i < 1000; ++i) {
            const dvec3 centre = inBall(random), along = 0.045 * glm::normalize(inBall(random));
            const dvec3 across = 0.6 * glm::cross(glm::normalize(inBall(random)), along);
            bough.quad(vec3(centre - along - across), vec3(centre + along - across), vec3(centre + along + across),
                       vec3(centre - along + across));
        }
        const int mesh =
            document.mesh("Bough", {partOf(bough, paint(document, "Leaf", {0.35, 0.6, 0.2}, true))}, Kind::Open);
        for (int i = 0; i < 40; ++i) {
            const dvec3 place = inBall(random);
            const dquat rotation = turn(random.between(0, 360), glm::normalize(inBall(random)));
            document.node({.name = "Bough" + std::to_string(i),
                           .translation = dvec3(0, 3.4, 0) + dvec3(1.7, 1.1, 1.7) * place,
                           .rotation = rotation,
                           .mesh = mesh});
        }
        place(document, "Trunk", box({-0.2, 0, -0.2}, {0.2, 3, 0.2}), paint(document, "Trunk", {0.4, 0.28, 0.2}));
    };
    return {"E3-1",
            "a crown of 40,000 loose leaf quads: 40 instances of 1,000",
            kAsWithRays + "; seconds, not minutes",
            "fill and silhouettes that grow with every leaf",
            fill,
            sequence({.camera = eye(at({0.5, 6.5, 9.5}), at({0, 1.6, 0.4}), 45),
                      .lights = {pointLight("Lamp", at({3.5, 9, 2.5}), 9)}})};
}

Case manyLights() {
    const auto fill = [](Document& document) {
        addGround(document, 9, 4);
        Random random(29);
        const int material = paint(document, "Block", kCasterColor);
        const int block =
            document.mesh("Block", {partOf(box({-0.1875, 0, -0.125}, {0.1875, 0.4375, 0.125}), material)});
        for (int i = 0; i < 256; ++i) {
            const dvec3 cell(i % 16 - 7.5, 0, i / 16 - 7.5);
            const dvec3 hue(0.5 + 0.5 * cosDegrees(i * 23), 0.5 + 0.5 * cosDegrees(i * 23 - 120),
                            0.5 + 0.5 * cosDegrees(i * 23 + 120));
            const double x = random.between(-0.3, 0.3), z = random.between(-0.3, 0.3);
            const int light = document.light(
                {.name = "Lamp" + std::to_string(i), .color = hue, .intensity = 1.5, .rangeMetres = 1.25});
            document.node(
                {.name = "Lamp" + std::to_string(i), .translation = cell + dvec3(x, 0.75, z), .light = light});
            document.node(
                {.name = "Block" + std::to_string(i), .translation = cell + dvec3(0.5, 0, 0.5), .mesh = block});
        }
    };
    return {"E3-2",
            "256 small lights with a range of 1.25 m over 256 blocks",
            kAsWithRays + ", of each light; seconds, not minutes",
            "the cost of lights that reach little; light indices",
            fill,
            sequence({.camera = eye(at({0, 8, 10}), at({0, 0, 1}), 44)})};
}

}  // namespace

std::vector<Case> countCases() {
    return {stacked("E1-1", 255), stacked("E1-2", 256), stacked("E1-3", 257), stacked("E1-4", 512),
            coincident(),         closedPlates(),       underPlates(),        leaves(),
            manyLights()};
}

}  // namespace generator::stress
