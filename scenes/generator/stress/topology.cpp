// SPDX-License-Identifier: Apache-2.0
// Stress family C, first half: which triangles meet. Open, doubled, fins, without orientation, torn, loose.
#include "stress/floating.h"

namespace generator::stress {
namespace {

/// Eight by eight cells, waves in both directions, facing up.
Mesh sheet() {
    return moved(grid({-1.6, 0, 1.3}, {3.2, 0, 0}, {0, 0, -2.6}, 8, 8), [](const dvec3& p) {
        return dvec3(p.x, 1.6 + 0.3 * sinDegrees(140 * p.x) + 0.22 * cosDegrees(170 * p.z), p.z);
    });
}

Case oneTriangle() {
    const auto fill = [](Document& document) {
        addGround(document, 9);
        const Mesh triangle = Mesh().triangle({-1, 1, 0.4f}, {1, 1.2f, 0.1f}, {0.2f, 2.6f, -0.5f});
        const auto beside = [&](double x) { return [x](const dvec3& p) { return p + dvec3(x, 0, 0); }; };
        place(document, "Front", moved(triangle, beside(-2.6)), paint(document, "Front", kCasterColor), Kind::Open);
        place(document, "Back", flipped(triangle), paint(document, "Back", {0.3, 0.6, 0.3}), Kind::Open);
        place(document, "Both", moved(flipped(triangle), beside(2.6)), paint(document, "Both", {0.3, 0.4, 0.7}, true),
              Kind::Open);
    };
    const std::string shot = sequence(
        {.camera = eye(at({0, 5.5, 8.5}), at({0, 0.8, 0}), 42),
         .lights = {pointLight("Before", at({1.7, 5.1, 5.3}), 7), pointLight("Behind", at({-1.1, 4.6, -4.4}), 6)}});
    return {"C1-1",
            "three single triangles: seen from the front, from the back (not drawn), and of a two-sided material",
            "each throws a shadow away from both lights; the side turned away from a light is dark",
            "casters taken for closed; one-sided counting; shadows lost with culled faces",
            fill,
            shot};
}

Case darkSide() {
    const auto fill = [](Document& document) {
        addRoom(document, {-4, 0, -3}, {4, 5, 7});
        const Mesh raised = moved(sheet(), [](const dvec3& p) { return p + dvec3(0, 1.4, 0); });
        place(document, "Sheet", raised, paint(document, "Sheet", kCasterColor, true), Kind::Open);
    };
    const std::string shot = sequence({.camera = eye(at({0.4, 1.1, 5.6}), at({0, 2.2, 0}), 55),
                                       .lights = {pointLight("Key", at({0.3, 4.7, 0.9}), 4)}});
    return {"C1-3",
            "the sheet of C1-2 seen from below, with the light above it",
            "its underside is dark without a speck; the shadow on floor and walls is that of the sheet",
            "the sheet's own shadow judged by the wrong side of a triangle",
            fill,
            shot};
}

/// A sheet, and a box of which one face is there more than once.
Mesh withCopies(int copies, int flippedCopies) {
    Mesh result;
    const Mesh once = moved(sheet(), [](const dvec3& p) { return p + dvec3(-1.9, 0, 0); });
    const Mesh solid = box({1, 0.7, -0.8}, {2.6, 2.3, 0.8}, 2);
    Mesh top;
    const auto y = static_cast<float>(2.3);
    for (std::size_t i = 0; i < solid.indices.size(); i += 3) {
        const vec3 &a = solid.positions[solid.indices[i]], &b = solid.positions[solid.indices[i + 1]],
                   &c = solid.positions[solid.indices[i + 2]];
        if (a.y == y && b.y == y && c.y == y) top.triangle(a, b, c);
    }
    result.add(once).add(solid);
    for (int i = 0; i < copies; ++i) result.add(once).add(top);
    for (int i = 0; i < flippedCopies; ++i) result.add(flipped(once)).add(flipped(top));
    return result;
}

/// `count` triangles around one upright edge; bit i of `windings` turns triangle i round.
Mesh fins(int count, unsigned windings, const dvec3& foot) {
    const auto put = [&](const dvec3& p) { return vec3(foot + oddRotation() * p); };
    Mesh result;
    for (int i = 0; i < count; ++i) {
        const double turnDegrees = 17 + 360.0 * i / count;
        const vec3 low = put({0, -0.5, 0}), high = put({0, 0.5, 0});
        const vec3 out = put({0.5 * cosDegrees(turnDegrees), 0.15 * i - 0.3, -0.5 * sinDegrees(turnDegrees)});
        (windings >> static_cast<unsigned>(i) & 1u) != 0 ? result.triangle(high, low, out)
                                                         : result.triangle(low, high, out);
    }
    return result;
}

Case finsOf(int count) {
    const int columns = count == 5 ? 8 : 4, rows = (1 << count) / columns;
    const auto fill = [=](Document& document) {
        addGround(document, 12);
        const int material = paint(document, "Fin", kCasterColor, true);
        for (int i = 0; i < columns * rows; ++i) {
            const dvec3 foot(1.5 * (i % columns - 0.5 * (columns - 1)), 0.9, 1.5 * (i / columns - 0.5 * (rows - 1)));
            place(document, "Fins" + std::to_string(i), fins(count, static_cast<unsigned>(i), foot), material,
                  Kind::Open);
        }
    };
    const double away = columns == 8 ? 1.75 : 1;
    const std::string shot =
        sequence({.camera = eye(at(away * dvec3(0, 6.5, 5.5)), at({0, 0.2, 0.3}), 42),
                  .lights = {pointLight("Key", at({2.7, 7.9, 1.3}), 8), pointLight("Side", at({-7.1, 5.2, 2.9}), 7)}});
    return {"C3-" + std::to_string(count - 2),
            std::to_string(count) + " triangles on one edge, each pattern of windings a mesh of its own",
            kAsWithRays + "; the shadows do not depend on the windings",
            "an edge taken to have two triangles",
            fill,
            shot};
}

Mesh moebius() {
    constexpr int segments = 64, across = 2;
    Mesh result;
    for (int i = 0; i < segments; ++i)
        for (int j = 0; j <= across; ++j) {
            const double u = 360.0 * i / segments, v = 0.6 * (2.0 * j / across - 1);
            const double out = 1.5 + v * cosDegrees(u / 2);
            result.positions.emplace_back(out * cosDegrees(u), v * sinDegrees(u / 2), out * sinDegrees(u));
        }
    const auto index = [&](int i, int j) {
        return static_cast<std::uint32_t>(i < segments ? i * (across + 1) + j : across - j);
    };
    for (int i = 0; i < segments; ++i)
        for (int j = 0; j < across; ++j)
            result.indices.insert(result.indices.end(), {index(i, j), index(i + 1, j), index(i + 1, j + 1),  //
                                                         index(i, j), index(i + 1, j + 1), index(i, j + 1)});
    return oddlyPlaced(result, {0, 2.1, 0});
}

/// The bottle whose section is a figure of eight that turns half around.
Mesh klein() {
    constexpr int around = 48, sides = 24;
    Mesh result;
    for (int i = 0; i < around; ++i)
        for (int j = 0; j < sides; ++j) {
            const double u = 360.0 * i / around, v = 360.0 * j / sides;
            const double a = 0.7 * sinDegrees(v), b = 0.7 * sinDegrees(2 * v);
            const double out = 1.4 + cosDegrees(u / 2) * a - sinDegrees(u / 2) * b;
            result.positions.emplace_back(out * cosDegrees(u), sinDegrees(u / 2) * a + cosDegrees(u / 2) * b,
                                          out * sinDegrees(u));
        }
    const auto index = [&](int i, int j) {
        const int side = i < around ? j % sides : (sides - j) % sides;
        return static_cast<std::uint32_t>(i % around * sides + side);
    };
    for (int i = 0; i < around; ++i)
        for (int j = 0; j < sides; ++j)
            result.indices.insert(result.indices.end(), {index(i, j), index(i + 1, j), index(i + 1, j + 1),  //
                                                         index(i, j), index(i + 1, j + 1), index(i, j + 1)});
    return oddlyPlaced(result, {0, 2.1, 0});
}

/// A torus of which each triangle is turned round, or kept at all, by chance.
Mesh chanceTorus(double turned, double kept) {
    Random random(7);
    Mesh result = oddlyPlaced(torus(1.5, 0.6, 64, 32), {0, 2.1, 0});
    std::vector<std::uint32_t> indices;
    for (std::size_t i = 0; i < result.indices.size(); i += 3) {
        const bool turn = random.between(0, 1) < turned;
        const bool keep = random.between(0, 1) < kept;
        const std::uint32_t a = result.indices[i], b = result.indices[i + 1], c = result.indices[i + 2];
        if (keep) indices.insert(indices.end(), {a, turn ? c : b, turn ? b : c});
    }
    result.indices = std::move(indices);
    return result;
}

Mesh soup(int triangles) {
    Random random(11);
    Mesh result;
    for (int i = 0; i < triangles; ++i) {
        const dvec3 centre = dvec3(0, 2.2, 0) + 1.9 * inBall(random);
        const dvec3 a = centre + 0.09 * inBall(random), b = centre + 0.09 * inBall(random);
        result.triangle(a, b, centre + 0.09 * inBall(random));
    }
    return result;
}

}  // namespace

std::vector<Case> topologyCases() {
    std::vector<Case> cases{
        oneTriangle(),
        floating("C1-2", "an open, wavy sheet of 8 x 8 cells, lit on its front", kAsWithRays,
                 "casters taken for closed", sheet),
        darkSide(),
        floating("C2-1", "a sheet twice in one mesh, and a box with one face twice", "as without the copies",
                 "copies that open an edge", [] { return withCopies(1, 0); }),
        floating("C2-2", "as C2-1, the copies turned round", "as without the copies", "copies that cancel each other",
                 [] { return withCopies(0, 1); }),
        floating("C2-3", "a sheet three times in one mesh, one of them turned round, and a box with one face thrice",
                 "as without the copies", "multiplicities beyond 2", [] { return withCopies(1, 1); }),
        finsOf(3),
        finsOf(4),
        finsOf(5),
        floating("C4-1", "a Moebius strip of 64 segments", kAsWithRays, "a winding that is taken to be consistent",
                 moebius),
        floating("C4-2", "a Klein bottle that goes through itself", kAsWithRays,
                 "a closed mesh taken to have an inside", klein),
        floating("C4-3", "a closed torus of which half the triangles, by chance, are turned round",
                 "the shadow of the torus", "a winding that is taken to be consistent",
                 [] { return chanceTorus(0.5, 1); }),
        floating("C5-1", "10,000 triangles by chance in a ball, none with a neighbour", kAsWithRays,
                 "silhouettes of pairs of triangles", [] { return soup(10'000); })};
    for (const int removed : {10, 50, 90, 97})
        cases.push_back(floating("C5-" + std::to_string(cases.size() - 11),
                                 "a torus without " + std::to_string(removed) + " % of its triangles", kAsWithRays,
                                 "edges that count twice next to edges that count once",
                                 [removed] { return chanceTorus(0, 1 - removed / 100.0); }));
    return cases;
}

}  // namespace generator::stress
