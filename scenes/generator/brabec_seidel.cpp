// SPDX-License-Identifier: Apache-2.0
// Two scenes of the size of Brabec and Seidel's Figure 4: chess men (9,326 vertices and, in 58 closed pieces, 27,630
// edges) and a still life of a knot, a star and a chain (3,298 vertices). Three lights each.
#include <fmt/format.h>

#include "scenes.h"
#include "stage.h"

namespace generator {
namespace {

constexpr double kSquare = 1.0;  // a square of the board; the men are as large as chess men on a metre's square

/// A turned piece of exactly segments * rings + 2 points.
Shape turned(const std::vector<dvec2>& outline, int segments, int rings) {
    std::vector<dvec2> profile = resampled({outline.begin() + 1, outline.end() - 1}, rings);
    profile.insert(profile.begin(), outline.front());
    profile.push_back(outline.back());
    return lathe(profile, segments);
}

Shape pawn() {
    return turned({{0, 0},
                   {0.3, 0},
                   {0.3, 0.08},
                   {0.24, 0.14},
                   {0.13, 0.25},
                   {0.1, 0.55},
                   {0.18, 0.62},
                   {0.1, 0.66},
                   {0.15, 0.74},
                   {0.16, 0.82},
                   {0.12, 0.92},
                   {0.04, 0.97},
                   {0, 0.98}},
                  16, 17);
}

Shape rook() {
    Shape result = turned({{0, 0},
                           {0.34, 0},
                           {0.34, 0.1},
                           {0.26, 0.18},
                           {0.18, 0.35},
                           {0.17, 0.75},
                           {0.26, 0.85},
                           {0.27, 1.02},
                           {0.18, 1.02},
                           {0.18, 0.95},
                           {0, 0.95}},
                          16, 16);
    for (int i = 0; i < 4; ++i)
        result.add(box({-0.07, 1.0, 0.17}, {0.07, 1.14, 0.26}).rotated(turn(90 * i, {0, 1, 0})));
    return result;
}

Shape horse() {
    Shape result = turned({{0, 0}, {0.34, 0}, {0.34, 0.1}, {0.26, 0.18}, {0.2, 0.3}, {0.22, 0.4}, {0, 0.42}}, 16, 11);
    const auto path = splineThrough(
        {{0, 0.36, -0.04}, {0, 0.65, -0.1}, {0, 0.95, -0.03}, {0, 1.08, 0.14}, {0, 0.96, 0.3}, {0, 0.84, 0.38}}, 12);
    std::vector<double> radii{0, 0.2, 0.2, 0.19, 0.18, 0.17, 0.16, 0.15, 0.14, 0.12, 0.1, 0};
    result.add(tube(ringsAlong(path, radii), 12).scaled({0.65, 1, 1}));
    return result;
}

Shape bishop() {
    Shape result = turned({{0, 0},
                           {0.33, 0},
                           {0.33, 0.1},
                           {0.24, 0.18},
                           {0.13, 0.35},
                           {0.1, 0.8},
                           {0.2, 0.88},
                           {0.1, 0.94},
                           {0.17, 1.05},
                           {0.17, 1.15},
                           {0.08, 1.32},
                           {0, 1.36}},
                          16, 18);
    return result.add(sphere(0.055, 6, 4).moved({0, 1.4, 0}));
}

Shape queen() {
    Shape result = turned({{0, 0},
                           {0.37, 0},
                           {0.37, 0.1},
                           {0.27, 0.2},
                           {0.15, 0.4},
                           {0.11, 1.0},
                           {0.23, 1.1},
                           {0.12, 1.16},
                           {0.2, 1.42},
                           {0.24, 1.52},
                           {0.17, 1.5},
                           {0.1, 1.58},
                           {0, 1.6}},
                          15, 33);
    return result.add(sphere(0.07, 6, 4).moved({0, 1.64, 0}));
}

/// A prism over a polygon that its centre sees whole.
Shape star(const std::vector<dvec2>& outline, double back, double front) {
    Shape result;
    const auto at = [](const dvec2& p, double z) { return Corner{.position = {p, z}}; };
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const dvec2 p = outline[i], q = outline[(i + 1) % outline.size()];
        result.triangle(at({0, 0}, front), at(p, front), at(q, front));
        result.triangle(at({0, 0}, back), at(q, back), at(p, back));
        result.quad(at(p, back), at(q, back), at(q, front), at(p, front));
    }
    return result;
}

Shape king() {
    Shape result = turned({{0, 0},
                           {0.38, 0},
                           {0.38, 0.1},
                           {0.28, 0.2},
                           {0.16, 0.4},
                           {0.12, 1.08},
                           {0.24, 1.18},
                           {0.13, 1.24},
                           {0.2, 1.5},
                           {0.22, 1.6},
                           {0.1, 1.68},
                           {0, 1.7}},
                          16, 25);
    const double a = 0.035, b = 0.11;
    return result.add(star({{a, a},
                            {a, b},
                            {-a, b},
                            {-a, a},
                            {-b, a},
                            {-b, -a},
                            {-a, -a},
                            {-a, -b},
                            {a, -b},
                            {a, -a},
                            {b, -a},
                            {b, a}},
                           -0.035, 0.035)
                          .moved({0, 1.77, 0}));
}

void addBoard(Document& document) {
    const int dark = document.material({.name = "Dark", .color = {0.16, 0.11, 0.08}, .roughness = 0.5});
    const int light = document.material({.name = "Light", .color = {0.75, 0.66, 0.5}, .roughness = 0.5});
    Shape squares[2];
    for (int x = 0; x < 8; ++x)
        for (int z = 0; z < 8; ++z) {
            const dvec3 p{(x - 4) * kSquare, 0, (z - 4) * kSquare};
            squares[(x + z) % 2].quad({.position = p}, {.position = p + dvec3(0, 0, kSquare)},
                                      {.position = p + dvec3(kSquare, 0, kSquare)},
                                      {.position = p + dvec3(kSquare, 0, 0)});
        }
    const GeometryOptions plain{.texCoords = false};
    const int mesh = document.mesh(
        "Board", {{geometryOf(squares[0], plain), light}, {geometryOf(squares[1], plain), dark}}, Kind::Receiver);
    document.node({.name = "Board", .translation = {0, 0.01, 0}, .mesh = mesh});
}

void addThreeLights(Document& document, double intensity) {
    addMovingLight(document, {.name = "Key", .color = {1, 0.88, 0.7}, .intensity = intensity},
                   {{-5, 6.5, 4}, {-3, 7, 5}});
    addMovingLight(document, {.name = "Fill", .color = {0.55, 0.7, 1}, .intensity = 0.6 * intensity},
                   {{6, 5.5, 2}, {6, 5.5, -1}});
    addMovingLight(document, {.name = "Rear", .color = {1, 0.6, 0.45}, .intensity = 0.6 * intensity},
                   {{1, 5, -7}, {-2, 5, -7}});
}

}  // namespace

void brabecSeidelA(Document& document) {
    addGround(document, 14, 8, {0.42, 0.4, 0.38});
    addBoard(document);
    const int ivory = document.material({.name = "Ivory", .color = {0.82, 0.74, 0.58}, .roughness = 0.4});
    const int ebony = document.material({.name = "Ebony", .color = {0.2, 0.13, 0.1}, .roughness = 0.4});
    const std::pair<const char*, Shape> men[] = {{"Rook", rook()},   {"Horse", horse()}, {"Bishop", bishop()},
                                                 {"Queen", queen()}, {"King", king()},   {"Pawn", pawn()}};
    // A game under way, each side one pawn short: letters of the men, from black's first rank.
    const char* ranks[] = {"rhb.kb.r", "pp..qpp.", "...p.h.p", "..p.....",
                           "...PP.B.", "..H..H.P", "PP...PP.", "R..QKB.R"};
    const std::string letters = "rhbqkp";
    for (const int side : {0, 1}) {
        int meshes[6];
        for (int m = 0; m < 6; ++m)
            meshes[m] = document.mesh(
                fmt::format("{}{}", side ? "White" : "Black", men[m].first),
                {{geometryOf(men[m].second, {.creaseDegrees = 35, .texCoords = false}), side ? ivory : ebony}});
        int count = 0;
        for (int rank = 0; rank < 8; ++rank)
            for (int file = 0; file < 8; ++file) {
                const char letter = ranks[rank][file];
                const auto m = letters.find(side ? static_cast<char>(letter | 0x20) : letter);
                if (letter == '.' || m == std::string::npos || (letter < 'a') != (side == 1)) continue;
                document.node({.name = fmt::format("{}{}", side ? "White" : "Black", ++count),
                               .translation = {file - 3.5, 0.01, rank - 3.5},
                               .rotation = turn(side ? 180 : 0, {0, 1, 0}),
                               .mesh = meshes[m]});
            }
    }
    const Topology t = document.casters();
    document.promise("vertices", t.vertices, 9326, 0.01);
    document.promise("edges", t.edges, 27627, 0.01);
    document.promise("Euler characteristic", t.vertices - t.edges + t.triangles, 117, 0.01);
    addThreeLights(document, 160);
    addCamera(document, "Camera", 40, 0.1, {{5, 6.2, 9.5}, {6.2, 5.6, 8.6}}, {{0, 0.3, 0.3}, {0, 0.3, 0.3}});
}

void brabecSeidelB(Document& document) {
    addGround(document, 14, 8, {0.6, 0.57, 0.52});
    const int copper = document.material({.name = "Copper", .color = {0.75, 0.4, 0.25}, .roughness = 0.4});
    const int jade = document.material({.name = "Jade", .color = {0.25, 0.55, 0.4}, .roughness = 0.45});
    const int iron = document.material({.name = "Iron", .color = {0.4, 0.42, 0.46}, .roughness = 0.5});

    // A (2, 3) torus knot; rings take the torus's normal as their x, so the last meets the first.
    std::vector<Ring> rings;
    const auto knotAt = [](double degrees) {
        const double wide = 1 + 0.42 * cosDegrees(3 * degrees);
        return dvec3(wide * cosDegrees(2 * degrees), 0.42 * sinDegrees(3 * degrees), wide * sinDegrees(2 * degrees));
    };
    for (int i = 0; i < 160; ++i) {
        const double degrees = 360.0 * i / 160;
        const dvec3 along = glm::normalize(knotAt(degrees + 0.5) - knotAt(degrees - 0.5));
        const dvec3 core{cosDegrees(2 * degrees), 0, sinDegrees(2 * degrees)};
        dvec3 x = knotAt(degrees) - core;
        x = glm::normalize(x - along * glm::dot(x, along));
        rings.push_back({knotAt(degrees), x * 0.17, glm::cross(along, x) * 0.17});
    }
    addSolid(document, "Knot", tube(rings, 12, Ends::Joined).rotated(turn(78, {1, 0, 0})), copper, {-1.9, 1.65, 0},
             180);

    const Shape burr = icosphere(3).bent([](const dvec3& p) {
        double spike = 0;  // long along the icosahedron's own corners, which are the directions of a golden rectangle
        const double golden = (1 + std::sqrt(5.0)) / 2, length = std::sqrt(1 + golden * golden);
        for (const dvec3& d : {dvec3(0, 1, golden), dvec3(1, golden, 0), dvec3(golden, 0, 1), dvec3(0, 1, -golden),
                               dvec3(1, -golden, 0), dvec3(-golden, 0, 1)}) {
            const double near = std::abs(glm::dot(p, d)) / length;
            spike = std::max(spike, near * near * near * near * near * near * near * near);
        }
        return p * (0.55 + 0.75 * spike * spike);
    });
    addSolid(document, "Star", burr, jade, {1.7, 1.25, -0.5}, 180);

    for (int link = 0; link < 4; ++link) {
        const Shape loop = torus({0.55, 0.34}, 0.11, 0.11, 23, 8).rotated(turn(link % 2 ? 80 : -8, {1, 0, 0}));
        addSolid(document, fmt::format("Link{}", link + 1).c_str(), loop, iron,
                 {-1.2 + 0.78 * link, 0.48, 2.1 - 0.12 * link}, 180);
    }
    document.promise("vertices", document.casters().vertices, 3298, 0.01);
    addThreeLights(document, 130);
    addCamera(document, "Camera", 40, 0.1, {{-0.8, 3.6, 7.4}, {0.8, 3.4, 7.4}}, {{0, 0.9, 0}, {0, 0.9, 0}});
}

}  // namespace generator
