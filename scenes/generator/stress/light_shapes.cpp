// SPDX-License-Identifier: Apache-2.0
// Stress family F: where lights end, what casts, and what is shaded smoother than it is.
#include <fmt/format.h>

#include "stress/floating.h"

namespace generator::stress {
namespace {

const dvec3 kBlue{0.4, 0.5, 0.7};

/// A little light everywhere, so that what the light in question leaves out can be seen.
std::string fillLight() {
    return "{type: point, name: Fill, position: [0, 9, 6], intensity: 40}";
}

std::string ranged(const std::string& name, const dvec3& position, double intensity, double rangeMetres) {
    return fmt::format("{{type: point, name: {}, position: {}, intensity: {}, range: {}}}", name, at(position),
                       intensity, rangeMetres);
}

Case casterAcrossRange() {
    const auto fill = [](Document& document) {
        addGround(document, 9);
        const int material = paint(document, "Caster", kCasterColor);
        place(document, "Across", box({1.25, 0.5, -0.5}, {3.5, 1.25, 0.5}, 3), material);
        place(document, "Inside", oddlyPlaced(box(dvec3(-0.375), dvec3(0.375)), {-0.9, 0.8, 0.9}), material);
        place(document, "Outside", box({-4.5, 0.25, -2}, {-3.5, 1.5, -1}), material);
    };
    return {"F1-1",
            "three boxes: across the sphere in which a light ends, in it, beyond it",
            "shadows of the first two as far as the light reaches; nothing of this light beyond its sphere",
            "bounds of scissors and depth off by one; casters dropped by their centre",
            fill,
            sequence({.camera = eye(at({0, 6, 7.5}), at({0, 0.3, 0}), 42),
                      .lights = {ranged("Ranged", {0, 2, 0}, 60, 3.75), fillLight()}})};
}

Case receiverBeyondRange() {
    const auto fill = [](Document& document) {
        addGround(document, 9, 1, -2);
        const int material = paint(document, "Table", kBlue);
        int index = 0;
        for (const double below : {2.75, 2.984375, 2.9999990463256836, 3.0, 3.0000009536743164}) {
            const dvec3 middle(2 * index - 4, 3 - below, 0);
            const std::string name = std::to_string(index++);
            place(document, "Table" + name, grid(middle + dvec3(-0.9, 0, 2), {1.8, 0, 0}, {0, 0, -4}, 1, 1), material,
                  Kind::Receiver);
            place(document, "Block" + name, box(middle + dvec3(0, 0.25, -0.125), middle + dvec3(0.25, 0.5, 0.125)),
                  paint(document, "Block" + name, kCasterColor));
        }
    };
    std::vector<std::string> lights{fillLight()};
    for (int i = 0; i < 5; ++i) lights.push_back(ranged("Lamp" + std::to_string(i), dvec3(2 * i - 4, 3, 0), 4000, 3));
    return {
        "F1-2",
        "five tables 2.75, 2.984375, 3 - 2^-20, 3 and 3 + 2^-20 m below five lights that end at 3 m",
        "a disc of light, a smaller one, and none that can be seen; of its own light nothing reaches the last table",
        "a range that ends before or after the sphere",
        fill,
        sequence({.camera = eye(at({0, 6.5, 7.5}), at({0, -0.2, 0.2}), 42), .lights = lights})};
}

std::string spot(const dvec3& position, const dvec3& target, const std::string& angles) {
    return fmt::format("{{type: spot, name: Spot, position: {}, target: {}, intensity: 70, {}}}", at(position),
                       at(target), angles);
}

Case cone(const std::string& id, const std::string& what, const std::string& answer, const std::string& angles) {
    const auto fill = [](Document& document) {
        addRoom(document, {-5, 0, -4}, {5, 5, 8});
        const int material = paint(document, "Caster", kCasterColor);
        place(document, "Box", oddlyPlaced(box(dvec3(-0.6), dvec3(0.6), 2), {-1.6, 1.7, -0.5}), material);
        place(document, "Ring", oddlyPlaced(torus(1, 0.3, 24, 12), {1.3, 1.4, 0.4}), material);
    };
    return {id,
            what,
            answer,
            "bounds of a cone by a tangent that is infinite or negative",
            fill,
            sequence({.camera = eye(at({0, 3.2, 7.5}), at({0, 1.6, 0}), 55),
                      .lights = {spot({0.5, 4, 2.5}, {-0.25, 1, -0.5}, angles),
                                 "{type: point, name: Fill, position: [-4, 4.5, 6], intensity: 12}"}})};
}

Case besideCone() {
    const auto fill = [](Document& document) {
        addGround(document, 9);
        const int material = paint(document, "Caster", kCasterColor);
        place(document, "Around",
              moved(torus(1.5, 0.25, 48, 16), [](const dvec3& p) { return p + dvec3(-1.75, 2.5, 0); }), material);
        place(document, "Across", moved(torus(0.9, 0.25, 48, 16), [](const dvec3& p) { return p + dvec3(2.25, 2, 0); }),
              material);
    };
    const auto down = [](const char* name, double x) {
        return fmt::format(
            "{{type: spot, name: {}, position: [{}, 5, 0], target: [{}, 0, 0], intensity: 80, "
            "innerConeAngle: 18, outerConeAngle: 20}}",
            name, x, x);
    };
    return {"F2-4",
            "two spots downwards, each in a ring: one ring is around the cone, without a triangle in it",
            "a whole disc of light left, a ring's shadow in the disc right",
            "casters kept or dropped by their box alone",
            fill,
            sequence({.camera = eye(at({0, 5.5, 7.5}), at({0, 0.9, 0}), 45),
                      .lights = {down("Left", -1.75), down("Right", 2.25), fillLight()}})};
}

std::function<void(Document&)> casters() {
    return [](Document& document) {
        addGround(document, 9);
        const int material = paint(document, "Caster", kCasterColor);
        place(document, "Ring", oddlyPlaced(torus(1.1, 0.4, 32, 16), {-1.2, 1.7, 0}), material);
        place(document, "Box", oddlyPlaced(box(dvec3(-0.7), dvec3(0.7), 2), {1.6, 1.6, 0.2}), material);
    };
}

std::string litBy(const std::vector<std::string>& lights, const std::string& frames = "1") {
    return sequence({.camera = eye(at({0, 5.5, 7.5}), at({0, 0.6, 0}), 42), .lights = lights, .frames = frames});
}

std::string lamp(const std::string& name, const std::string& intensity, const dvec3& position = {2.6, 6.3, 2.2}) {
    return fmt::format("{{type: point, name: {}, position: {}, intensity: {}}}", name, at(position), intensity);
}

Case lightOnAnimatedNode() {
    const auto fill = [](Document& document) {
        casters()(document);
        const int arm = document.node({.name = "Arm", .translation = {0, 1, 0}});
        const int light = document.light({.name = "Lamp", .intensity = 130});
        document.node({.name = "Lamp", .parent = arm, .translation = {3, 5, 1}, .light = light});
        document.rotate(arm, {0, 1, 2}, {turn(0, {0, 1, 0}), turn(70, {0, 1, 0}), turn(140, {0, 1, 0})});
    };
    return {"F3-4",
            "a light on the child of a node that turns by 70 degrees a frame",
            "the shadows turn with it",
            "lights placed once; volumes kept from the frame before",
            fill,
            litBy({}, "0-2")};
}

Case notCasting() {
    const auto fill = [](Document& document) {
        casters()(document);
        const int glass = document.material({.name = "Glass", .color = kBlue, .alpha = 0.4, .doubleSided = true});
        place(document, "Pane", grid({-2.5, 3, 1.5}, {5, 0.25, 0}, {0, 0, -2}, 2, 2), glass, Kind::Open);
    };
    return {"F3-5",
            "a blended pane, which casts nothing, between the light and two opaque casters",
            "the shadows of the opaque casters alone; the pane is lit",
            "casters that are flagged as none but cast",
            fill,
            litBy({lamp("Key", "147")})};
}

/// A panel with a texture of 2 x 2 texels, each repeated `repeats` times.
Part panel(const dvec3& corner, const dvec3& u, const dvec3& v, double repeats, int material) {
    Part part = partOf(grid(corner, u, v, 1, 1), material);
    const auto r = static_cast<float>(repeats);
    part.geometry.texCoords = {{0, r}, {r, r}, {0, 0}, {r, 0}};
    return part;
}

Case masked() {
    const auto fill = [](Document& document) {
        addGround(document, 9);
        const Picture checker{
            .size = 2, .rgb = {230, 140, 60, 230, 140, 60, 230, 140, 60, 230, 140, 60}, .alpha = {255, 0, 0, 255}};
        const int material = document.material({.name = "Checker",
                                                .color = dvec3(1),
                                                .alphaCutoff = 0.5,
                                                .doubleSided = true,
                                                .colorTexture = document.texture("Checker", checker)});
        const Part one = panel({-1.6, 1.25, 0.5}, {3.2, 0, 0}, {0, 1.5, -1.5}, 2, material);
        document.node({.name = "Panel", .mesh = document.mesh("Panel", {one}, Kind::Open)});
        place(document, "Box", box({2.25, 0.5, -0.5}, {3, 1.25, 0.25}), paint(document, "Box", kBlue));
    };
    return {"F4-1",
            "an alpha-masked panel, a checker of 2 x 2 texels with holes",
            "masked materials cast as if opaque: the whole panel's shadow, and a panel with holes",
            "silent wrongness",
            fill,
            litBy({lamp("Key", "147"), lamp("Side", "75", {-5.3, 4.2, 1.7})})};
}

Case blended() {
    const auto fill = [](Document& document) {
        addGround(document, 9);
        place(document, "Wall", grid({-4, 0, -2}, {8, 0, 0}, {0, 5, 0}, 1, 1), paint(document, "Wall", dvec3(0.6)),
              Kind::Receiver);
        place(document, "Box", oddlyPlaced(box(dvec3(-0.7), dvec3(0.7), 2), {-1.6, 2.4, 1.5}),
              paint(document, "Box", kCasterColor));
        const int glass = document.material({.name = "Glass", .color = kBlue, .alpha = 0.5});
        place(document, "Pane", grid({-2.5, 0.25, 0.5}, {4.5, 0, 0}, {0, 2.75, 0}, 1, 1), glass, Kind::Open);
    };
    return {
        "F4-2",
        "a blended pane before an opaque wall, both in the shadow of a box",
        "the box's shadow lies on wall and ground and shows through the pane, which casts none and, as yet, gets none",
        "a mask of the opaque surface laid over the pane",
        fill,
        litBy({lamp("Key", "147", {-3.6, 4.6, 7})})};
}

/// 16 segments, 8 rings; normals of the ball that it is meant to be.
Mesh smoothBall(const dvec3& centre, double radius) {
    Mesh result;
    for (int ring = 0; ring <= 8; ++ring)
        for (int i = 0; i < 16; ++i) {
            const double out = sinDegrees(22.5 * ring);
            const dvec3 normal(out * cosDegrees(22.5 * i), cosDegrees(22.5 * ring), -out * sinDegrees(22.5 * i));
            result.positions.emplace_back(centre + radius * normal);
            result.normals.emplace_back(normal);
        }
    for (std::uint32_t ring = 0; ring < 8; ++ring)
        for (std::uint32_t i = 0; i < 16; ++i) {
            const std::uint32_t a = ring * 16 + i, b = ring * 16 + (i + 1) % 16;
            if (ring > 0) result.indices.insert(result.indices.end(), {a, b + 16, b});
            if (ring < 7) result.indices.insert(result.indices.end(), {a, a + 16, b + 16});
        }
    return result;
}

Case terminator(const std::string& id, const std::string& what, const std::string& light) {
    const auto fill = [](Document& document) {
        addGround(document, 9);
        place(document, "Wall", grid({-9, 0, -3}, {18, 0, 0}, {0, 9, 0}, 1, 1), paint(document, "Wall", dvec3(0.6)),
              Kind::Receiver);
        place(document, "Ball", smoothBall({0, 2, 0}, 1.5), paint(document, "Ball", kCasterColor));
    };
    return {id,
            what,
            "as with rays where a point counts as lit only if its triangle faces the light: a jagged terminator",
            "light or shadow beyond the terminator by shading normals",
            fill,
            sequence({.camera = eye(at({0.5, 2.6, 7}), at({0, 1.9, 0}), 42), .lights = {light}})};
}

}  // namespace

std::vector<Case> lightShapeCases() {
    const std::string key = "147", side = lamp("Side", "75", {-5.3, 4.2, 1.7});
    return {
        casterAcrossRange(),
        receiverBeyondRange(),
        cone("F2-1", "a spot with an outer cone of 90 degrees", "half of the room is lit, up to the plane of the spot",
             "innerConeAngle: 60, outerConeAngle: 90"),
        cone("F2-2", "a spot with an outer cone a little below 90 degrees", "as F2-1",
             "innerConeAngle: 60, outerConeAngle: 89.9999"),
        cone("F2-3",
             "a spot whose inner cone is as wide as its outer one, up to a float: equal ones are not valid glTF",
             "a disc of light with a hard border", "innerConeAngle: 32.99999, outerConeAngle: 33"),
        besideCone(),
        {"F3-1", "a light of intensity 0, one that is 0 in frames 0 and 2, and one that shines",
         "frames 0 and 2 alike, lit by one light; frame 1 by two", "skips that outlast their reason, or divide by 0",
         casters(), litBy({lamp("Off", "0", {1, 5, -3}), lamp("Flash", "{0: 0, 1: 147, 2: 0}"), side}, "0-2")},
        {"F3-2", "two identical lights", "the picture of F3-3", "lights told apart by their place", casters(),
         litBy({lamp("One", key), lamp("Two", key)})},
        {"F3-3", "one light of twice the intensity: what F3-2 must look like", kAsWithRays, "nothing; for comparison",
         casters(), litBy({lamp("Both", "294")})},
        lightOnAnimatedNode(),
        notCasting(),
        masked(),
        blended(),
        terminator("F5-1", "a coarse ball, 16 x 8, with smooth normals; the light at its horizon",
                   pointLight("Lamp", at({-6, 2.25, 1.5}), 7)),
        terminator("F5-2", "the ball of F5-1, the sun at the horizon",
                   sun("Sun", at({-2, 0.03125, 1.25}), at({0, 0, 0})))};
}

}  // namespace generator::stress
