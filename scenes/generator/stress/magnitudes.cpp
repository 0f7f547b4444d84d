// SPDX-License-Identifier: Apache-2.0
// Stress family D: how large, how far. One scene moved and scaled, and scenes that are small and large at once.
#include "stress/floating.h"

namespace generator::stress {
namespace {

Mesh ground() {
    return grid({-9, 0, 9}, {18, 0, 0}, {0, 0, -18}, 3, 3);
}

Mesh casters() {
    Mesh result = oddlyPlaced(torus(1.3, 0.5, 32, 16), {-1.3, 2.1, 0.2});
    return result.add(oddlyPlaced(box(dvec3(-0.8), dvec3(0.8), 4), {1.7, 1.8, -0.4}))
        .add(icosphere({0.6, 0.9, 1.9}, 0.6, 2));
}

using Place = std::function<dvec3(const dvec3&)>;

/// The look down of family C at a scene that is scaled, then moved.
std::string shot(double scale, const dvec3& by) {
    const auto put = [&](const dvec3& p) { return at(by + scale * p); };
    return sequence({.camera = eye(put({0, 5.5, 7.5}), put({0, 0.6, 0}), 42, 0.0625 * scale),
                     .lights = {pointLight("Key", put({2.625, 6.25, 2.25}), 7 * scale),
                                pointLight("Side", put({-5.25, 4.25, 1.75}), 5 * scale)}});
}

/// Ground and casters whose vertices went through `put`, under `parent`.
void fill(Document& document, const Place& put, int parent = kNone) {
    const auto add = [&](const char* name, const Mesh& mesh, const dvec3& color, Kind kind) {
        const int index = document.mesh(name, {partOf(moved(mesh, put), paint(document, name, color, true))}, kind);
        document.node({.name = name, .parent = parent, .mesh = index});
    };
    add("Ground", ground(), dvec3(0.6), Kind::Receiver);
    add("Casters", casters(), kCasterColor, Kind::Open);
}

Case inVertices(const std::string& id, const std::string& what, double scale, const dvec3& by) {
    const auto put = [=](const dvec3& p) { return by + scale * p; };
    return {id,
            what,
            kAsWithRays + ", of the same floats",
            "shadows computed with world-space floats; fixed epsilons",
            [=](Document& document) { fill(document, put); },
            shot(scale, by)};
}

Case inNode(const std::string& id, const std::string& what, double scale, const dvec3& by) {
    const auto make = [=](Document& document) {
        const int root = document.node({.name = "Root", .translation = by, .scale = dvec3(scale)});
        fill(
            document, [](const dvec3& p) { return p; }, root);
    };
    return {id,   what,           "the picture of the scene at the origin", "world-space floats; fixed epsilons",
            make, shot(scale, by)};
}

dvec3 far(double metres) {
    return metres * dvec3(1, 0.25, -1);
}

/// A bolt of `metres` that stands on the ground: a shaft, a disc, and a six-sided head.
Mesh screw(double metres) {
    Mesh result;
    const auto prism = [&](double radius, double low, double high, int sides) {
        const auto rim = [&](int i, double y) {
            const double turnDegrees = 360.0 * (i % sides) / sides;
            return vec3(metres * dvec3(radius * cosDegrees(turnDegrees), y, -radius * sinDegrees(turnDegrees)));
        };
        const vec3 foot(0, metres * low, 0), top(0, metres * high, 0);
        for (int i = 0; i < sides; ++i)
            result.quad(rim(i, low), rim(i + 1, low), rim(i + 1, high), rim(i, high))
                .triangle(top, rim(i, high), rim(i + 1, high))
                .triangle(foot, rim(i + 1, low), rim(i, low));
    };
    prism(0.14, 0, 0.75, 20);
    prism(0.4, 0.05, 0.1, 24);
    prism(0.35, 0.75, 1, 6);
    return result;
}

Case screwOnTerrain() {
    const auto make = [](Document& document) {
        Random random(5);
        Mesh terrain = grid({-1e4, 0, 1e4}, {2e4, 0, 0}, {0, 0, -2e4}, 17, 17);
        for (vec3& p : terrain.positions) {
            const double height = random.between(0, 900);
            if (std::abs(p.x) > 1500 || std::abs(p.z) > 1500) p.y = static_cast<float>(height);
        }
        place(document, "Terrain", terrain, paint(document, "Terrain", {0.5, 0.55, 0.45}), Kind::Open);
        place(document, "Screw", screw(1e-3), paint(document, "Screw", kCasterColor));
    };
    return {"D3",
            "a screw 1 mm high on a terrain 20 km wide, whose cell below it is one flat quad of 1.2 km",
            "the screw's two shadows begin at its foot; the hills behind throw theirs",
            "epsilons; depths and positions interpolated over a huge triangle",
            make,
            sequence({.camera = eye(at({0.0011, 0.0014, 0.0027}), at({-0.0002, 0.0005, 0}), 50, 1e-5),
                      .lights = {pointLight("Lamp", at({-0.0025, 0.0032, 0.0017}), 0.004),
                                 sun("Sun", at({4, 3, 1}), at({0, 0, 0}))}})};
}

Case nearAndFar() {
    const auto make = [](Document& document) {
        place(document, "Wall", grid({-2e6, -2e6, -1.4e6}, {4e6, 0, 0}, {0, 4e6, 0}, 1, 1),
              paint(document, "Wall", dvec3(0.6)), Kind::Receiver);
        const int material = paint(document, "Caster", kCasterColor);
        place(document, "Far",
              moved(torus(2e5, 8e4, 48, 24), [](const dvec3& p) { return dvec3(1e5, 0, -1e6) + oddRotation() * p; }),
              material);
        place(document, "Near",
              moved(box(dvec3(-1e-4), dvec3(1e-4), 2),
                    [](const dvec3& p) { return dvec3(-5e-4, 0, -1.5e-3) + oddRotation() * p; }),
              material);
    };
    return {"D4",
            "the near plane at 1e-4 m, a box of 0.2 mm just behind it, a torus of 400 km before a wall at 1.4e6 m",
            "the torus throws two shadows on the wall, the box one, thrown by the lamp beside the eye",
            "depths that run out of bits; extrusion by a length",
            make,
            sequence({.camera = eye(at({0, 0, 0}), at({0, 0, -1}), 45, 1e-4),
                      .lights = {pointLight("FarLamp", at({7e5, 4e5, -3e5}), 1.2e6),
                                 pointLight("NearLamp", at({-7e-4, 2e-4, -1e-3}), 1.4e6),
                                 sun("Sun", at({-2, 3, 5}), at({0, 0, 0}))}})};
}

/// Numbers too small for a normal float beside every zero: what should meet in a point or lie in a plane no longer
/// does.
Mesh withSubnormals(Mesh mesh) {
    Random random(19);
    for (vec3& position : mesh.positions)
        for (int axis = 0; axis < 3; ++axis) {
            const auto tiny = static_cast<float>(random.between(-1e-38, 1e-38));
            if (position[axis] == 0) position[axis] = tiny;
        }
    return mesh;
}

std::vector<Case> subnormal() {
    const auto mixed = [](Document& document) {
        addGround(document, 9, 1, -2);
        const int material = paint(document, "Caster", kCasterColor, true);
        place(document, "Torus", withSubnormals(torus(1.5, 0.5, 32, 16)), material, Kind::Open);
        place(document, "Box", withSubnormals(unshared(box({0, 0, 0}, {1, 1.5, 1}, 2))), material, Kind::Open);
        place(document, "Speck", withSubnormals(unshared(box(dvec3(-1e-39), dvec3(1e-39)))), material, Kind::Open);
    };
    const auto plate = [](Document& document) {
        addRoom(document, {-3, -2, -3}, {3, 3, 5});
        place(document, "Plate", withSubnormals(grid({-1, 0, 1}, {2, 0, 0}, {0, 0, -2}, 5, 5)),
              paint(document, "Plate", kCasterColor, true), Kind::Open);
        place(document, "Box", box({-1.75, -1.5, -1.5}, {-1, 0.75, -0.75}),
              paint(document, "Box", dvec3(0.4, 0.5, 0.7)));
    };
    return {{"D5-1", "a torus and a box whose zeros became subnormal numbers, and a box of 1e-39 m",
             "the shadows of torus and box, but for single pixels at tears of 1e-38 m; the small box throws none",
             "denormals flushed in one place and kept in another", mixed,
             sequence(
                 {.camera = eye(at({0, 4, 7}), at({0, -0.8, 0}), 45),
                  .lights = {pointLight("Key", at({2.6, 4.8, 2.2}), 7), pointLight("Side", at({-5.3, 2.2, 1.7}), 5)}})},
            {"D5-2", "a light 2.5 m above a plate whose heights are subnormal, and a light in its plane",
             "the plate's shadow of the upper light is whole; of the light in its plane it has none that can be seen",
             "facings decided with flushed denormals", plate,
             sequence({.camera = eye(at({0.3, 1.4, 4.6}), at({0, -0.4, 0}), 60),
                       .lights = {pointLight("Above", at({0.25, 2.5, 0.125}), 3),
                                  pointLight("InPlane", at({2.5, 0, 0.375}), 3)}})}};
}

}  // namespace

std::vector<Case> magnitudeCases() {
    std::vector<Case> cases{
        inVertices("D1-1", "the scene 1e5 m away, in its vertices: 8 mm apart at least", 1, far(1e5)),
        inVertices("D1-2", "the scene, twice as large, 1e6 m away, in its vertices: 6 cm apart", 2, far(1e6)),
        inVertices("D1-3", "the scene, eight times as large, 1e7 m away, in its vertices: 1 m apart", 8, far(1e7)),
        inNode("D1-4", "the scene 1e5 m away, by its node", 1, far(1e5)),
        inNode("D1-5", "the scene 1e6 m away, by its node", 1, far(1e6)),
        inNode("D1-6", "the scene 1e7 m away, by its node", 1, far(1e7)),
        inVertices("D2-1", "the scene scaled by 1e-6, in its vertices", 1e-6, {}),
        inVertices("D2-2", "the scene scaled by 1e6, in its vertices", 1e6, {}),
        inNode("D2-3", "the scene scaled by 1e-6, by its node", 1e-6, {}),
        inNode("D2-4", "the scene scaled by 1e6, by its node", 1e6, {}),
        screwOnTerrain(),
        nearAndFar()};
    for (Case& one : subnormal()) cases.push_back(std::move(one));
    return cases;
}

}  // namespace generator::stress
