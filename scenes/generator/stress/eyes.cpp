// SPDX-License-Identifier: Apache-2.0
// Stress family B, first part: the eye in shadow volumes and casters, on their borders, and at the light.
#include <fmt/format.h>

#include <set>

#include "stress/parts.h"
#include "stress/stress.h"

namespace generator::stress {
namespace {

using Fill = std::function<void(Document&)>;

Fill stageWith(const Mesh& mesh, bool doubleSided = false) {
    return [=](Document& document) {
        addStage(document);
        place(document, "Extra", mesh, paint(document, "Extra", {0.3, 0.5, 0.75}, doubleSided), Kind::Open);
    };
}

/// The unit icosphere without its part towards +z, and the same within it at `inner`, joined along their rims.
Mesh bowl(int levels, double inner) {
    const Mesh ball = icosphere(dvec3(0), 1, levels);
    std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
    Mesh outside;
    for (std::size_t i = 0; i < ball.indices.size(); i += 3) {
        const std::uint32_t* t = &ball.indices[i];
        const vec3 a = ball.positions[t[0]], b = ball.positions[t[1]], c = ball.positions[t[2]];
        if (a.z + b.z + c.z > 1.4f) continue;
        outside.triangle(a, b, c);
        for (int k = 0; k < 3; ++k) edges.emplace(t[k], t[(k + 1) % 3]);
    }
    const auto inwards = [&](const dvec3& p) { return p * inner; };
    Mesh result = outside;
    result.add(flipped(moved(outside, inwards)));
    for (const auto& [from, to] : edges)
        if (!edges.contains({to, from})) {
            const vec3 u = ball.positions[from], v = ball.positions[to];
            result.quad(v, u, inwards(u), inwards(v));
        }
    return result;
}

std::vector<Case> inVolumes() {
    const dvec3 centre(0, 1.5, 5);
    const auto shells = [=](int count, const Mesh& mesh) {
        return [=](Document& document) {
            addStage(document);
            const int shell = document.mesh("Shell", {partOf(mesh, paint(document, "Shell", {0.3, 0.5, 0.75}))});
            for (int i = 0; i < count; ++i)
                document.node({.name = fmt::format("Shell{}", i + 1),
                               .translation = centre,
                               .rotation = turn(180, {0, 1, 0}),
                               .scale = dvec3(0.6 + 0.6 * i / count),
                               .mesh = shell});
        };
    };
    const std::string shot =
        sequence({.camera = eye(at(centre), at({0, 1.25, 0}), 75, 0.02),
                  .lights = {pointLight("Behind", "[1.5, 5, 11]", 14), pointLight("Side", "[-8, 6, 3]", 9)}});
    std::vector<Case> all;
    for (const int count : {1, 2, 7, 300}) {
        const Mesh mesh = count == 300 ? bowl(1, 0.999) : bowl(2, count == 7 ? 0.96 : 0.95);
        all.push_back(
            {fmt::format("B1-{}", all.size() + 1),
             count == 1 ? "the eye in a bowl, open towards what it sees, lit from behind"
                        : fmt::format("the eye in {} nested bowls, open towards what it sees, lit from behind", count),
             "the bowls' shadow on ground and wall; all else is lit by the light from behind",
             "z-pass without the eye's own count, or with it modulo 256", shells(count, mesh), shot});
    }
    all.push_back({"B1-5", "the eye at the centre of 7 closed spheres, through whose culled backs it sees",
                   "the spheres' shadow on ground and wall", "closed casters that the depth buffer lacks altogether",
                   shells(7, icosphere(dvec3(0), 1, 2)), shot});
    return all;
}

std::vector<Case> inCasters() {
    const auto ball = [](bool doubleSided) { return stageWith(icosphere({1, 2.5, 7}, 1.5, 3), doubleSided); };
    const std::string inside = eye("[1.25, 2.25, 7.5]", "[0, 1.5, 0]", 75);
    const std::vector<std::string> lamps{pointLight("Lamp", "[4, 8, 12]", 12), pointLight("Side", "[-9, 5, 1]", 9)};
    return {{"B2-1", "the eye inside a closed sphere of a double-sided material",
             "the sphere's inside, all of it in shadow", "the eye's count, backs of faces that are shaded as fronts",
             ball(true), sequence({.camera = inside, .lights = lamps})},
            {"B2-2", "the eye inside a closed sphere whose backs are culled",
             "what is outside, with the sphere's own shadow", "caps that need the culled faces in the depth buffer",
             ball(false), sequence({.camera = inside, .lights = lamps})},
            {"B2-3", "the eye inside a closed, double-sided sphere together with a light",
             "the sphere's inside is lit by the inner light only", "the eye's count of one light used for another",
             ball(true),
             sequence({.camera = inside, .lights = {lamps[0], pointLight("Inner", "[0.75, 2.75, 6.25]", 1.25)}})}};
}

/// A triangle, or a closed wedge, that holds one corner of the near rectangle in its shadow: its long edge's shadow
/// plane cuts the rectangle's upper and right sides.
Mesh cornerCaster(const dvec3& light, const dvec3& cutAbove, const dvec3& cutRight, const dvec3& corner, bool closed) {
    const auto half = [&](const dvec3& p) { return (light + p) / 2.0; };
    const dvec3 along = half(cutRight) - half(cutAbove), outwards = half(corner) - half(cutAbove);
    const dvec3 a = half(cutAbove) - 6.0 * along, b = half(cutRight) + 6.0 * along,
                c = a + 20.0 * outwards + 6.0 * along;
    if (!closed) return Mesh{}.triangle(a, b, c);
    const dvec3 d = (a + b + c) / 3.0 + 0.25 * glm::normalize(light - (a + b + c) / 3.0);
    return Mesh{}.triangle(a, b, c).triangle(a, d, b).triangle(b, d, c).triangle(c, d, a);
}

std::vector<Case> aroundNearPlane() {
    const dvec3 position(0, 2, 9), light(3, 5, 12);
    const double near = 0.5, halfHeight = near * 0.57735026919, halfWidth = halfHeight * 4 / 3;
    const auto onNear = [&](double x, double y) { return position + dvec3(x * halfWidth, y * halfHeight, -near); };
    const auto corner = [&](bool closed) {
        return cornerCaster(light, onNear(0.5, 1), onNear(1, 0.25), onNear(1, 1), closed);
    };
    const std::string straight = eye(at(position), at({0, 2, 0}), 60, near);
    const std::string lamp = pointLight("Lamp", at(light), 13);
    const std::string cornerShot = sequence({.camera = straight, .lights = {lamp}});
    const std::string cutShot =
        sequence({.camera = straight,
                  .lights = {pointLight("Side", "[-4, 8, 6]", 9), pointLight("Behind", "[1.5, 3.5, 12]", 14)}});
    const char* cut = "the shadow of the whole caster, as if nothing were cut";
    return {
        {"B3-1", "one triangle's shadow holds one corner of the near rectangle", "rays' shadow",
         "choosing the way of counting by one point of the near rectangle", stageWith(corner(false), true), cornerShot},
        {"B3-2", "one closed wedge's shadow holds one corner of the near rectangle", "rays' shadow",
         "choosing the way of counting by one point of the near rectangle", stageWith(corner(true)), cornerShot},
        {"B4-1", "the near plane cuts a tilted box; one sees into it, its backs are culled", cut,
         "counting the missing front, light caps at far depth",
         stageWith(moved(box(dvec3(-0.3), dvec3(0.3), 2),
                         [](const dvec3& p) { return oddRotation() * p + dvec3(-0.125, 2.125, 8.375); })),
         cutShot},
        {"B4-2", "the near plane cuts a double-sided sphere; one sees into it", cut,
         "acne inside from caps at their true depth", stageWith(icosphere({0.25, 1.875, 8.5}, 0.25, 2), true), cutShot},
        {"B4-3", "a lit card between the eye and the near plane", cut, "cards that cast though no pixel shows them",
         stageWith(Mesh{}.quad({-0.2f, 1.85f, 8.7f}, {0.1f, 1.9f, 8.75f}, {0.15f, 2.15f, 8.7f}, {-0.15f, 2.1f, 8.65f}),
                   true),
         cutShot}};
}

// Eye, light and the ends of an edge between them in one plane, by construction: all are multiples of 2^-10.
const dvec3 kPlaneLight(-6.125, 8.25, -3.5);
const dvec3 kPlaneEdge[] = {{0.25, 2.75, 2.625}, {0.375, 6.5, -0.25}};  // of oddTetrahedron()
const dvec3 kPlaneEye = kPlaneEdge[0] + kPlaneEdge[1] - kPlaneLight;

std::vector<Case> onSilhouettePlane() {
    const Fill fill = [](Document& document) {
        addRoom(document, {-12, -2, -12}, {12, 12, 12});
        const Mesh caster = oddTetrahedron();
        place(document, "Caster", caster, paint(document, "Caster", kCasterColor));
        const dvec3 normal = glm::cross(kPlaneEdge[0] - kPlaneLight, kPlaneEdge[1] - kPlaneLight);
        std::size_t beside = 0;
        for (const vec3& corner : caster.positions)
            if (glm::dot(normal, dvec3(corner) - kPlaneLight) > 0) ++beside;
        // Three triangles at either other corner.
        document.promise("corners on one side of the edge's shadow plane", beside % 6, 0);
        document.promise("eye in the shadow plane", glm::dot(normal, kPlaneEye - kPlaneLight) == 0, 1);
    };
    const char* away = "[12, 0.5, 7.5]";
    const auto shot = [&](const std::string& position, const std::string& target, const char* frames) {
        return sequence({.camera = eye(position, target, 70),
                         .lights = {pointLight("Lamp", at(kPlaneLight), 16)},
                         .frames = frames});
    };
    const char* answer = "the border of the shadow through the middle of the picture; neither half flips";
    const char* catches = "a sign of the eye's count that the rasteriser decides otherwise: half the picture wrong";
    const double ulp = static_cast<double>(std::nextafter(static_cast<float>(kPlaneEye.x), 100.0f)) - kPlaneEye.x;
    std::vector<Case> all{{"B5-1", "the eye exactly on the shadow plane of a silhouette edge, beyond it", answer,
                           catches, fill, shot(at(kPlaneEye), away, "1")}};
    const std::pair<const char*, double> steps[] = {{"one float to its left", -ulp}, {"one float to its right", ulp},
                                                    {"1e-6 to its left", -1e-6},     {"1e-6 to its right", 1e-6},
                                                    {"1e-3 to its left", -1e-3},     {"1e-3 to its right", 1e-3}};
    for (const auto& [name, step] : steps)
        all.push_back({fmt::format("B5-{}", all.size() + 1), fmt::format("the eye of B5-1 moved in x: {}", name),
                       answer, catches, fill, shot(at(kPlaneEye + dvec3(step, 0, 0)), away, "1")});
    all.push_back({"B5-8", "the eye passes through the plane of B5-1, which it meets at frame 501", answer, catches,
                   fill, shot(pathThrough(kPlaneEye, {0.25, 0, 0}), away, kSweepFrames)});
    all.push_back({"B5-9", "the eye of B5-1 looks back at the edge",
                   "the side of the caster that is turned from the light, before lit walls", catches, fill,
                   shot(at(kPlaneEye), at({0.5, 3.5, 1}), "1")});
    return all;
}

std::vector<Case> atTheLight() {
    return {{"B6", "the eye at the light", "no shadow is visible at all", "side quads that are seen as lines", addStage,
             sequence({.camera = eye("[4, 5.5, 11]", "[0, 1.75, -0.5]"),
                       .lights = {pointLight("Lamp", "[4, 5.5, 11]", 12)}})}};
}

}  // namespace

std::vector<Case> eyeCases() {
    std::vector<Case> all;
    for (auto* const group : {inVolumes, inCasters, aroundNearPlane, onSilhouettePlane, atTheLight})
        for (Case& one : group()) all.push_back(std::move(one));
    return all;
}

}  // namespace generator::stress
