// SPDX-License-Identifier: Apache-2.0
// Two rooms that are hard for shadow volumes: Kilgard's light in an open box, and an eye inside several volumes.
#include <fmt/format.h>

#include "scenes.h"
#include "stage.h"

namespace generator {
namespace {

/// Six walls seen from inside; a receiver.
void addRoom(Document& document, const dvec3& low, const dvec3& high, const dvec3& color) {
    const Shape outside = box(low, high);
    Shape inside;
    for (std::size_t i = 0; i < outside.corners().size(); i += 3)
        inside.triangle(outside.corners()[i], outside.corners()[i + 2], outside.corners()[i + 1]);
    const int material = document.material({.name = "Walls", .color = color, .roughness = 0.9});
    const int mesh = document.mesh("Room", {{geometryOf(inside, {.texCoords = false}), material}}, Kind::Receiver);
    document.node({.name = "Room", .mesh = mesh});
}

/// A box of outer half sizes `half` whose +Z side is open: one closed surface with thick walls.
Shape openBox(const dvec3& half, double wall) {
    const dvec3 inner = half - wall;
    const double floor = -half.z + wall;
    const auto ring = [](double x, double y, double z) {
        return std::array<dvec3, 4>{dvec3(-x, -y, z), dvec3(x, -y, z), dvec3(x, y, z), dvec3(-x, y, z)};
    };
    const auto back = ring(half.x, half.y, -half.z), rim = ring(half.x, half.y, half.z);
    const auto lip = ring(inner.x, inner.y, half.z), bottom = ring(inner.x, inner.y, floor);
    const auto quad = [](Shape& shape, const dvec3& a, const dvec3& b, const dvec3& c, const dvec3& d) {
        shape.quad({.position = a}, {.position = b}, {.position = c}, {.position = d});
    };
    Shape result;
    quad(result, back[3], back[2], back[1], back[0]);
    quad(result, bottom[0], bottom[1], bottom[2], bottom[3]);
    for (int i = 0; i < 4; ++i) {
        const int j = (i + 1) % 4;
        quad(result, back[i], back[j], rim[j], rim[i]);
        quad(result, rim[i], rim[j], lip[j], lip[i]);
        quad(result, lip[i], lip[j], bottom[j], bottom[i]);
    }
    return result;
}

/// Twelve closed bars along the edges of a cube; they do not touch.
Shape cage(double half, double radius) {
    Shape result;
    const double reach = half - 2.5 * radius;
    for (int axis = 0; axis < 3; ++axis)
        for (const double a : {-half, half})
            for (const double b : {-half, half}) {
                dvec3 from, to;
                from[axis] = -reach, to[axis] = reach;
                from[(axis + 1) % 3] = to[(axis + 1) % 3] = a;
                from[(axis + 2) % 3] = to[(axis + 2) % 3] = b;
                result.add(bar(from, to, radius, 8));
            }
    return result;
}

/// A thick bowl: a sphere between two radii whose polar cap of `openDegrees` about +Z is cut away; closed.
Shape bowl(double outer, double inner, double openDegrees, int segments, int rings) {
    std::vector<dvec2> profile;
    const auto add = [&](double radius, double degrees) {
        profile.push_back({radius * sinDegrees(degrees), radius * cosDegrees(degrees)});
    };
    for (int i = 0; i <= rings; ++i) add(outer, mix(180, openDegrees, static_cast<double>(i) / rings));
    for (int i = 0; i <= rings; ++i) add(inner, mix(openDegrees, 180, static_cast<double>(i) / rings));
    return lathe(profile, segments).rotated(turn(90, {1, 0, 0}));
}

}  // namespace

void lantern(Document& document) {
    addRoom(document, {-4, 0, -3}, {4, 4.5, 6}, {0.68, 0.66, 0.62});
    const int iron = document.material({.name = "Iron", .color = {0.3, 0.28, 0.26}, .roughness = 0.6});
    const int wood = document.material({.name = "Wood", .color = {0.5, 0.33, 0.2}, .roughness = 0.8});

    // The box turns a little about its hook, so that the edge of its light passes over the eye.
    const int box = document.node({.name = "Box", .translation = {-1.1, 1.9, -1}});
    swing(document, box, {0, 1, 0}, 9, [](double t) { return mix(-4, 70, t); });
    const int boxMesh =
        document.mesh("Box", {{geometryOf(openBox({0.5, 0.5, 0.45}, 0.05), {.texCoords = false}), wood}});
    document.node({.name = "BoxBody", .parent = box, .mesh = boxMesh});
    document.node({.name = "BoxLight",
                   .parent = box,
                   .translation = {0, 0, 0.05},
                   .light = document.light({.name = "BoxLight", .color = {1, 0.75, 0.45}, .intensity = 30})});

    const int cageMesh = document.mesh("Cage", {{geometryOf(cage(0.3, 0.022), {.texCoords = false}), iron}});
    const int hook = document.node({.name = "Cage", .translation = {1.6, 2.2, -0.6}, .mesh = cageMesh});
    swing(document, hook, {0.6, 0.8, 0}, 9, [](double t) { return 25 * t; });
    document.node({.name = "CageLight",
                   .parent = hook,
                   .light = document.light({.name = "CageLight", .color = {0.75, 0.85, 1}, .intensity = 14})});

    addSolid(document, "Post", bar({0.35, 0, 0.4}, {0.35, 1.5, 0.4}, 0.09, 10), wood);
    addSolid(document, "Crate", bevelledBox({-0.4, 0, -0.4}, {0.4, 0.8, 0.4}, 0.05), wood, {1.5, 0, 1});
    // The near plane lies in the box's light, then in its shadow: the cases that need capping.
    addCamera(document, "Camera", 55, 0.25, {{-0.9, 1.9, 4.6}, {-0.3, 1.95, 4.6}, {0.3, 2, 4.6}},
              {{-0.2, 1.4, -1}, {0, 1.4, -1}, {0.2, 1.4, -1}});
}

void nested(Document& document) {
    addGround(document, 14, 8, {0.6, 0.58, 0.55});
    const dvec3 centre{0, 1.2, 0};
    const dvec3 colors[] = {{0.75, 0.4, 0.3}, {0.75, 0.65, 0.35}, {0.35, 0.55, 0.7}};
    const char* names[] = {"ShellA", "ShellB", "ShellC"};
    for (int i = 0; i < 3; ++i) {
        const double outer = 0.8 + 0.35 * i;
        const int material = document.material({.name = names[i], .color = colors[i], .roughness = 0.7});
        addSolid(document, names[i], bowl(outer, outer - 0.06, 64 - 6 * i, 32, 14), material, centre);
    }
    const int stone = document.material({.name = "Stone", .color = {0.7, 0.68, 0.62}, .roughness = 0.8});
    for (int i = 0; i < 5; ++i)
        addSolid(
            document, fmt::format("Column{}", i + 1).c_str(),
            lathe({{0, 0}, {0.3, 0}, {0.3, 0.12}, {0.2, 0.2}, {0.17, 1.5}, {0.26, 1.62}, {0.26, 1.75}, {0, 1.75}}, 20),
            stone, {-3 + 1.5 * i, 0, 5.5 - (i % 2)});
    // From behind: the eye at the centre stands in the volumes of all three shells.
    addMovingLight(document, {.name = "Behind", .color = {1, 0.85, 0.65}, .intensity = 400},
                   {{-3, 6, -7}, {3, 6.5, -7}});
    addMovingLight(document, {.name = "Side", .color = {0.55, 0.7, 1}, .intensity = 90}, {{5, 3.5, 5}, {4.5, 3.2, 7}});
    addCamera(document, "Camera", 75, 0.05, {centre + dvec3(-0.15, 0, -0.6), centre + dvec3(0.15, 0, -0.45)},
              {centre + dvec3(0, -0.25, 5), centre + dvec3(0, -0.25, 5)});
    addCamera(document, "Outside", 45, 0.05, {{5.5, 3.6, 8.5}}, {{0, 1, 1.5}});
}

}  // namespace generator
