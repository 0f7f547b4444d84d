// SPDX-License-Identifier: Apache-2.0
// Stress family C, second half: how triangles are stored. T-junctions, contacts, no area, slivers, seams, strips.
#include "stress/floating.h"

namespace generator::stress {
namespace {

/// A box whose upper face has a point more on each side, at a third: beside the edge, by rounding. The upright faces
/// know these points only when repaired.
Mesh splitBox(bool repaired) {
    const auto put = [](double x, double y, double z) { return rounded(oddRotation() * dvec3(x, y, z)); };
    const dvec3 top[] = {put(-1, 1, 1), put(1, 1, 1), put(1, 1, -1), put(-1, 1, -1)};
    const dvec3 bottom[] = {put(-1, -1, 1), put(1, -1, 1), put(1, -1, -1), put(-1, -1, -1)};
    const dvec3 middle = (top[0] + top[1] + top[2] + top[3]) / 4.0;
    Mesh result;
    for (int i = 0; i < 4; ++i) {
        const int next = (i + 1) % 4;
        const dvec3 third = top[i] + (top[next] - top[i]) / 3.0;
        result.triangle(middle, top[i], third).triangle(middle, third, top[next]);
        result.triangle(bottom[i], bottom[next], top[next]);
        if (repaired)
            result.triangle(bottom[i], top[next], third).triangle(bottom[i], third, top[i]);
        else
            result.triangle(bottom[i], top[next], top[i]);
    }
    result.quad(bottom[3], bottom[2], bottom[1], bottom[0]);
    return moved(result, [](const dvec3& p) { return p + dvec3(0, 2.1, 0); });
}

Mesh crossedTori() {
    Mesh result = oddlyPlaced(torus(1.3, 0.5, 40, 20), {-0.5, 2.1, 0});
    return result.add(moved(torus(1.2, 0.45, 36, 18), [](const dvec3& p) {
        return dvec3(0.7, 2.2, 0.1) + oddRotation() * dvec3(p.x, -p.z, p.y);
    }));
}

Case contact() {
    const auto fill = [](Document& document) {
        addGround(document, 8);
        const int material = paint(document, "Caster", kCasterColor);
        place(document, "Box", box({-1.5, 0, -0.5}, {-0.25, 1, 0.75}), material);
        const dmat3 odd = glm::mat3_cast(turn(33, {0, 1, 0}));
        place(document, "Turned",
              moved(box({-0.5, 0, -0.5}, {0.5, 0.75, 0.5}), [&](const dvec3& p) { return odd * p + dvec3(1, 0, 0); }),
              material);
    };
    const std::string shot = sequence(
        {.camera = eye(at({0.3, 1.6, 4.1}), at({0, 0.3, 0}), 42),
         .lights = {pointLight("Behind", at({1.9, 2.6, -3.1}), 4), pointLight("Side", at({-4.3, 1.7, 2.2}), 4)}});
    return {"C7-3",
            "two boxes that stand exactly on the ground: their lowest coordinate is 0, as the ground's",
            "each shadow begins at the foot of the box: no line of light at the contact",
            "offsets and biases that lift a shadow off its caster",
            fill,
            shot};
}

/// Triangles without area, of each kind: equal indices, equal positions, points in a line on dyadic coordinates.
Mesh degenerates(const Mesh& body) {
    Mesh result = body;
    for (std::size_t i = 0; i + 2 < body.indices.size(); i += 15) {
        const std::uint32_t a = body.indices[i], b = body.indices[i + 1], c = body.indices[i + 2];
        result.indices.insert(result.indices.end(), {a, a, b, c, b, c, b, b, b});
        result.triangle(body.positions[a], body.positions[b], body.positions[a]);
        result.triangle(body.positions[c], body.positions[c], body.positions[c]);
    }
    const vec3 corner(1.5, 0.75, 1), end(2.5, 0.75, 1);  // an edge of the box
    result.triangle(corner, 0.5f * (corner + end), end).triangle(end, 0.75f * end + 0.25f * corner, corner);
    for (int i = 0; i < 12; ++i) {
        const vec3 from(-4 + 0.5 * i, 1.5, -3), step(0.25, 0.125, 0.5);
        result.triangle(from, from + 4.0f * step, from + 8.0f * step);
        result.triangle(from + 8.0f * step, from, from + step);
    }
    return result;
}

Mesh degenerateFree() {
    Mesh result = oddlyPlaced(torus(1.1, 0.45, 24, 12), {-1.2, 1.8, 0});
    return result.add(box({1.5, 0.75, -0.25}, {2.5, 2, 1}));
}

/// A box whose faces are cut, one way, into wide strips and strips 2e-6 wide: a millionth of their length.
Mesh sliverBox() {
    std::vector<double> cuts;
    for (int i = 0; i < 8; ++i) cuts.insert(cuts.end(), {-1 + 0.25 * i, -1 + 0.25 * i + 2e-6});
    cuts.push_back(1);
    const auto put = [](double x, double y, double z) { return vec3(dvec3(0, 2, 0) + oddRotation() * dvec3(x, y, z)); };
    Mesh result;
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
        const double l = cuts[i], r = cuts[i + 1];
        result.quad(put(l, 1, 1), put(r, 1, 1), put(r, 1, -1), put(l, 1, -1));
        result.quad(put(l, -1, -1), put(r, -1, -1), put(r, -1, 1), put(l, -1, 1));
        result.quad(put(l, -1, 1), put(r, -1, 1), put(r, 1, 1), put(l, 1, 1));
        result.quad(put(r, -1, -1), put(l, -1, -1), put(l, 1, -1), put(r, 1, -1));
    }
    result.quad(put(-1, -1, -1), put(-1, -1, 1), put(-1, 1, 1), put(-1, 1, -1));
    return result.quad(put(1, -1, 1), put(1, -1, -1), put(1, 1, -1), put(1, 1, 1));
}

Mesh looseSlivers() {
    Random random(13);
    Mesh result;
    for (int i = 0; i < 300; ++i) {
        const dvec3 from = dvec3(0, 2.2, 0) + 1.7 * inBall(random);
        const dvec3 along = glm::normalize(inBall(random));
        const dvec3 across = glm::normalize(glm::cross(along, inBall(random)));
        result.triangle(from, from + 2.0 * along, from + along + 2e-6 * across);
    }
    return result.add(moved(icosphere({0, 0, 0}, 0.7, 2), [](const dvec3& p) { return p + dvec3(0, 2.2, 0); }));
}

/// Boxes with a corner at 0, whose zeros have another sign on every other triangle.
Case signedZeros() {
    const auto fill = [](Document& document) {
        addGround(document, 9, 1, -1);
        Mesh solid = unshared(box({0, 0, 0}, {1.5, 1.5, 1.5}, 3).add(box({-1.75, -0.75, -1.75}, {0, 0, 0}, 3)));
        for (std::size_t i = 0; i < solid.positions.size(); ++i)
            for (int axis = 0; axis < 3; ++axis)
                if (solid.positions[i][axis] == 0) solid.positions[i][axis] = i / 3 % 2 == 0 ? -0.0f : 0.0f;
        document.node({.name = "Boxes",
                       .mesh = document.mesh(
                           "Boxes", {partOf(solid, paint(document, "Boxes", kCasterColor), Mode::Triangles, false)},
                           Kind::Open)});
    };
    return {"C10-2",
            "two boxes that meet in the point 0; their zeros are +0 in one triangle and -0 in the next",
            "as with one kind of zero: after welding no edge is open",
            "false borders, and with them twice the fill",
            fill,
            lookDown()};
}

/// A closed cylinder about y: a strip around, two fans.
std::vector<Part> cylinder(const dvec3& foot, int material) {
    constexpr int sides = 24;
    Mesh around, upper, lower;
    const auto rim = [&](int i, double y) {
        return vec3(foot + dvec3(0.8 * cosDegrees(360.0 * (i % sides) / sides), y,
                                 -0.8 * sinDegrees(360.0 * (i % sides) / sides)));
    };
    upper.positions.emplace_back(foot + dvec3(0, 1.4, 0)), lower.positions.emplace_back(foot);
    for (int i = 0; i <= sides; ++i) {
        around.positions.insert(around.positions.end(), {rim(i, 1.4), rim(i, 0)});
        upper.positions.push_back(rim(i, 1.4)), lower.positions.push_back(rim(sides - i, 0));
    }
    for (Mesh* mesh : {&around, &lower})
        for (std::uint32_t i = 0; i < mesh->positions.size(); ++i) mesh->indices.push_back(i);
    return {partOf(around, material, Mode::Strip), partOf(upper, material, Mode::Fan, false),
            partOf(lower, material, Mode::Fan)};
}

Case modes() {
    const auto fill = [](Document& document) {
        addGround(document, 9);
        const int material = paint(document, "Caster", kCasterColor);
        document.node(
            {.name = "Cylinder", .mesh = document.mesh("Cylinder", cylinder({-2.2, 0.9, 0}, material), Kind::Open)});
        const Part loose = partOf(unshared(box({-0.7, 0.8, -0.7}, {0.7, 2, 0.7}, 2)), material, Mode::Triangles, false);
        document.node({.name = "Box", .mesh = document.mesh("Box", {loose})});
        place(document, "Ball", icosphere({2.3, 1.7, 0}, 0.8, 2), material);
    };
    return {"C12-1",
            "a cylinder of a strip and two fans, a box without indices, a ball of indexed triangles",
            "three closed casters with three whole shadows",
            "strips and fans wound or read in a wrong way",
            fill,
            lookDown()};
}

Case pointsAndLines() {
    const auto fill = [](Document& document) {
        addGround(document, 9);
        const int material = paint(document, "Caster", kCasterColor);
        Mesh points, lines;
        Random random(17);
        for (std::uint32_t i = 0; i < 400; ++i) {
            points.positions.emplace_back(dvec3(-1.5, 2, 0) + inBall(random));
            lines.positions.emplace_back(dvec3(1.5, 2, 0) + inBall(random));
            points.indices.push_back(i), lines.indices.push_back(i);
        }
        const Part parts[] = {partOf(points, material, Mode::Points, false), partOf(lines, material, Mode::Lines),
                              partOf(icosphere({0, 1.2, 0}, 0.5, 2), material)};
        document.node({.name = "Mixed", .mesh = document.mesh("Mixed", {parts[0], parts[1], parts[2]})});
    };
    return {"C12-2",
            "one mesh of 400 points, 200 lines and a ball",
            "only the ball throws a shadow",
            "points and lines read as triangles",
            fill,
            lookDown()};
}

/// A closed tube along x whose halves follow a joint each; both have the ring in the middle.
Case skinSeam() {
    const auto fill = [](Document& document) {
        addGround(document, 9);
        constexpr int sides = 24;
        Part part{.geometry = {}, .material = paint(document, "Tube", kCasterColor, true)};
        Mesh tube;
        for (const bool right : {false, true}) {
            const double end = right ? 2 : -2;
            const auto ring = [&](double x, int i) {
                return vec3(x, 1.7 + 0.6 * cosDegrees(360.0 * (i % sides) / sides),
                            0.6 * sinDegrees(360.0 * (i % sides) / sides));
            };
            for (int i = 0; i < sides; ++i) {
                const vec3 a = ring(0, i), b = ring(0, i + 1), c = ring(end, i + 1), d = ring(end, i), cap(end, 1.7, 0);
                Mesh strip;
                strip.quad(a, d, c, b).triangle(d, cap, c);
                tube.add(right ? flipped(strip) : strip);
            }
            part.geometry.joints.resize(tube.positions.size(), {right ? 1 : 0, 0, 0, 0});
            part.geometry.weights.resize(tube.positions.size(), {1, 0, 0, 0});
        }
        part.geometry.positions = tube.positions, part.geometry.indices = tube.indices;
        const int joints[] = {document.node({.name = "LeftJoint"}), document.node({.name = "RightJoint"})};
        const int skin = document.skin("Skin", {joints[0], joints[1]}, {{0, 0, 0}, {0, 0, 0}});
        document.node({.name = "Tube", .mesh = document.mesh("Tube", {part}, Kind::Open), .skin = skin});
        document.translate(joints[1], {0, 1, 2}, {{0, 0, 0}, {0.001, 0, 0}, {0.4, 0, 0}});
    };
    return {"C13",
            "a skinned tube whose halves share a ring of positions but not their joints; they part in frame 2",
            "frame 0: one closed shadow. Frames 1 and 2: light falls through the gap of 1 mm and 40 cm",
            "vertices welded by position alone",
            fill,
            lookDown("0-2")};
}

}  // namespace

std::vector<Case> storageCases() {
    return {
        floating("C6-1", "a box, turned oddly, whose upper face alone has a point at a third of each edge",
                 "the exact answer has cracks far thinner than a pixel, and a picture shows at most single "
                 "pixels of them",
                 "silent cracks at T-junctions", [] { return splitBox(false); }),
        floating("C6-2", "as C6-1, repaired: both faces at each edge have the point",
                 "a whole shadow without a lit pixel", "cracks where there are none", [] { return splitBox(true); }),

        floating("C7-1", "two tori through each other in one mesh", kAsWithRays, "counts taken for 0 or 1",
                 crossedTori),
        floating("C7-2", "two boxes in one mesh that overlap and share the planes of three faces",
                 "the shadow of both together; no speckle where their faces coincide",
                 "coplanar faces that shadow each other",
                 [] {
                     return box({-1.5, 1, -1}, {0.5, 2, 0.75}).add(box({-0.5, 1, -0.5}, {1.5, 2, 0.75}));
                 }),
        contact(),
        floating("C8-1", "a torus and a box: what C8-2 must look like", kAsWithRays, "nothing; for comparison",
                 degenerateFree),
        floating("C8-2", "C8-1 with triangles without area: equal indices, equal positions, in a line",
                 "bit for bit the picture and the masks of C8-1", "silhouettes of triangles without area",
                 [] { return degenerates(degenerateFree()); }),
        floating("C9-1", "a box, turned oddly, whose faces are cut into strips of 0.25 m and of 2e-6 m",
                 "the shadow of a box, without lines", "normals that lose a sliver's side", sliverBox),
        floating("C9-2", "300 loose triangles 2 m long and 2e-6 m wide around a ball",
                 kAsWithRays + "; hardly a pixel centre is met", "normals of no length; streaks", looseSlivers),
        floating("C10-1", "a torus of which each triangle has vertices of its own",
                 "as with shared vertices: after welding no edge is open",
                 "false borders, and with them twice the fill",
                 [] {
                     return unshared(oddlyPlaced(torus(1.5, 0.6, 48, 24), {0, 2.1, 0}));
                 }),
        signedZeros(),
        modes(),
        pointsAndLines(),
        skinSeam(),
    };
}

}  // namespace generator::stress
