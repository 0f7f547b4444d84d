// SPDX-License-Identifier: Apache-2.0
// The numbers of shadow volumes against counts that share nothing with the passes that make them: the device's own
// query, exact crossings of view rays with sides and caps, a brute-force search for silhouette edges, and sum rules.
#include <array>
#include <set>

#include "counted.h"
#include "counter_checks.h"
#include "oracle/predicates.h"
#include "scene/topology.h"
#include "shading/lights.h"

namespace umbrage::test {
namespace {

using oracle::kNothing;
using Json = nlohmann::json;

/// Without meshes some edge of which has more than two triangles: such edges are counted in pairs of triangles, each
/// for itself.
Subject manifold(Subject subject) {
    for (Node& node : subject.scene.nodes) {
        if (node.mesh == kNone) continue;
        const Mesh& mesh = subject.scene.meshes[std::size_t(node.mesh)];
        if (buildTopology(mesh, subject.scene.materials).figures.nonManifoldEdges > 0) node.mesh = kNone;
    }
    return subject;
}

class FillBy : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Techniques, FillBy, testing::Values("z-pass", "z-fail"),
                         [](const auto& test) { return std::string(test.param).replace(1, 1, ""); });

TEST_P(FillBy, FragmentsAndUpdatesAreTheCrossingsOfViewRays) {
    const bool byFail = std::string_view(GetParam()) == "z-fail";
    const std::string against = std::string("view rays, ") + GetParam();
    std::size_t lights = 0, pixels = 0, different = 0, unexplained = 0;
    for (const Subject& any : subjects()) {
        if (any.tied || any.seed == 0 || !any.camera.camera.perspective) continue;
        const Subject subject = manifold(solid(any));
        const Counted counted(subject, {.technique = {"compute", GetParam()}, .counts = true});
        const oracle::EyeRays rays(subject.camera, subject.width, subject.height);
        for (std::size_t l = 0; l < counted.moment.lights.size(); ++l) {
            const LightPlanes& planes = counted.pixels.lights[l];
            // By z-pass only casters near the eye have caps, and those that may be missing from the depth buffer.
            if (!byFail && counted.value(planes.id, "caps.light") > 0) continue;
            if (counted.value(planes.id, "casters.outOfReach") > 0) continue;
            const glm::dvec4 light = oracle::placeOf(counted.moment.lights[l]);
            const std::vector<Quad> quads = counted.quadsOf(light);
            // With another sign of a triangle seen edge-on by the light, which is as good, these are other volumes.
            if (quads.empty() || counted.value(planes.id, "edges.silhouette") != double(quads.size())) continue;
            ++lights;
            Crossings all;
            std::set<std::pair<int, int>> touched, processed;
            std::size_t differentHere = 0;
            for (int y = 0; y < subject.height; ++y) {
                for (int x = 0; x < subject.width; ++x) {
                    const std::size_t i = std::size_t(y * subject.width + x);
                    const int drawn = int(planes.aovs.at("cost").values[i]);
                    int least = 1 << 30, most = 0;
                    for (int k = 0; k < 9; ++k) {  // the rasteriser's grid of 1/256 pixel
                        const auto ray = rays.at(x + 0.5 + (k % 3 - 1) / 128.0, y + 0.5 + (k / 3 - 1) / 128.0);
                        const std::uint32_t seen = counted.truth.oracle().see(ray);
                        const double distance = seen == kNothing ? farthest(subject.camera, ray)
                                                                 : counted.truth.oracle().distanceTo(seen, ray);
                        const Crossings here = crossingsOf(counted, ray, quads, light, byFail, distance);
                        least = std::min(least, here.all());
                        most = std::max(most, here.all());
                        if (k != 4) continue;
                        differentHere += drawn != here.all();
                        all += here;
                        if (here.all() > 0) touched.insert({x / 8, y / 8});
                        if (here.updates() > 0) processed.insert({x / 8, y / 8});
                    }
                    // At a corner quads come and go together, but the rasteriser may take some of them.
                    unexplained += least == most && drawn != most;
                    ++pixels;
                }
            }
            different += differentHere;
            SCOPED_TRACE(subject.name + " " + planes.id);
            // Borders have a few quads each.
            const double tolerance = 4.0 * double(1 + differentHere);
            const auto expect = [&](const Counter& counter, double theirs) {
                const std::string name(counter.info().name);
                expectCounter(counter, against, counted.value(planes.id, name.c_str()), theirs, tolerance);
            };
            expect("overdraw.fragments", all.all());
            expect("overdraw.sides", all.sides);
            expect("overdraw.lightCaps", all.lightCaps);
            expect("overdraw.darkCaps", all.darkCaps);
            expect("overdraw.passed", all.passed);
            expect("overdraw.failed", all.failed);
            expect("overdraw.updates", all.updates());
            expect("overdraw.entered", all.entered);
            expect("overdraw.left", all.left);
            expect("tiles.touched", double(touched.size()));
            expect("tiles.processed", double(processed.size()));
            expect("tiles.culled", double(touched.size() - processed.size()));
        }
    }
    EXPECT_GE(lights, 5u);
    EXPECT_EQ(unexplained, 0u) << "of " << pixels;
    std::printf("%zu of %zu pixels differ, all on borders; %zu lights\n", different, pixels, lights);
    EXPECT_LT(double(different), 2e-3 * double(pixels));
}

TEST_P(FillBy, GeometryIsThatOfABruteForceSearch) {
    const bool byFail = std::string_view(GetParam()) == "z-fail";
    std::size_t found = 0;
    for (const Subject& any : subjects()) {
        if (any.tied) continue;
        const Subject subject = manifold(solid(any));
        const Counted counted(subject, {.technique = {"compute", GetParam()}, .skipOutOfReach = false, .counts = true});
        const oracle::EyeRays rays(subject.camera, subject.width, subject.height);
        std::vector<oracle::Triangle> casters;
        std::set<std::uint32_t> instances;
        for (std::uint32_t t = 0; t < counted.truth.oracle().triangles().size(); ++t) {
            if (!counted.truth.oracle()[t].casts) continue;
            instances.insert(counted.instanceOf.at(t));
            const auto& [a, b, c] = counted.truth.oracle()[t].corners;
            if (a != b && b != c && c != a) casters.push_back(counted.truth.oracle()[t]);
        }
        SCOPED_TRACE(subject.name);
        expectCounter("triangles", "brute-force search", counted.value("triangles"), double(casters.size()));
        expectCounter("edges", "brute-force search", counted.value("edges"), double(counted.edgeCount()));
        for (std::size_t l = 0; l < counted.moment.lights.size(); ++l) {
            const std::string& id = counted.pixels.lights[l].id;
            if (!isOn(counted.moment.lights[l].light)) continue;
            const glm::dvec4 light = oracle::placeOf(counted.moment.lights[l]);
            const std::vector<Quad> edges = counted.quadsOf(light);
            double twice = 0, quads = 0, front = 0, facing = 0, around = 0;
            for (const Quad& edge : edges) {
                twice += std::abs(edge.times) > 1;
                quads += std::abs(edge.times);
            }
            for (const oracle::Triangle& triangle : casters) {
                const int side = oracle::sideOfLight(triangle.corners, light);
                front += side > 0;
                facing += side != 0;
                const oracle::Ray toLight{rays.eye(),
                                          light.w != 0.0 ? glm::dvec3(light) - rays.eye() : glm::dvec3(light)};
                around += oracle::meets(toLight, triangle.corners) &&
                          side * oracle::sideOfLight(triangle.corners, glm::dvec4(rays.eye(), 1.0)) < 0;
            }
            SCOPED_TRACE(id);
            const auto expect = [&](const Counter& counter, double theirs) {
                const std::string name(counter.info().name);
                expectCounter(counter, "brute-force search", counted.value(id, name.c_str()), theirs);
            };
            expect("triangles.facing", front);
            expect("edges.silhouette", double(edges.size()));
            expect("edges.silhouette.once", double(edges.size()) - twice);
            expect("edges.silhouette.twice", twice);
            expect("quads", quads);
            if (byFail) {
                expect("caps.light", facing);
                expect("caps.dark", light.w != 0.0 && subject.camera.camera.perspective ? facing : 0.0);
                expect("casters.zfail", double(instances.size()));
            } else if (subject.camera.camera.perspective) {
                expect("eye.constant", around);
            }
            found += edges.size();
        }
    }
    EXPECT_GT(found, 1000u);
}

/// Whether the sphere around a box is farther from a spot's cone than its radius.
template <class Box>
bool isOutOfCone(const PlacedLight& light, const Box& box) {
    if (light.light.type != LightType::Spot) return false;
    const glm::dvec3 towards = 0.5 * (box.first + box.second) - light.position;
    const double along = glm::dot(towards, light.direction), aside = glm::length(towards - along * light.direction);
    const double angle = light.light.outerConeAngle;
    const bool nearestIsTheTip = along * std::cos(angle) + aside * std::sin(angle) < 0.0;
    const double distance = nearestIsTheTip ? glm::length(towards) : aside * std::cos(angle) - along * std::sin(angle);
    return distance > 0.5 * glm::distance(box.first, box.second);
}

TEST(Fill, WhatIsOutOfALightsReachIsSkipped) {
    const Subject subject = ours("hall", 128, 96);
    const Counted counted(subject, {});
    std::map<std::uint32_t, std::pair<glm::dvec3, glm::dvec3>> boxes;  // by instance
    for (std::uint32_t t = 0; t < counted.truth.oracle().triangles().size(); ++t) {
        if (!counted.truth.oracle()[t].casts) continue;
        for (const glm::dvec3& corner : counted.truth.oracle()[t].corners) {
            auto& [low, high] = boxes.try_emplace(counted.instanceOf.at(t), corner, corner).first->second;
            low = glm::min(low, corner);
            high = glm::max(high, corner);
        }
    }
    double off = 0, all = 0;
    for (std::size_t l = 0; l < counted.moment.lights.size(); ++l) {
        const PlacedLight& light = counted.moment.lights[l];
        off += !isOn(light.light);
        if (!isOn(light.light)) continue;
        double beyond = 0;
        for (const auto& [instance, box] : boxes) {
            const glm::dvec3 place(oracle::placeOf(light)), nearest = glm::clamp(place, box.first, box.second);
            beyond += glm::distance(place, nearest) > light.light.rangeMetres || isOutOfCone(light, box);
        }
        all += beyond;
        const std::string& id = counted.pixels.lights[l].id;
        expectCounter("casters.outOfReach", "boxes and ranges", counted.value(id, "casters.outOfReach"), beyond);
    }
    EXPECT_GT(all, 10.0);
    expectCounter("lights.skipped", "lights that are off", counted.value("lights.skipped"), off);
    expectCounter("casters", "meshes of the moment", counted.value("casters"), double(counted.moment.instances.size()));
    expectCounter("tiles", "the picture's size", counted.value("tiles"), 128.0 / 8 * 96 / 8);
}

TEST(Fill, AHalvedQuadStandsForTwo) {
    const Subject subject = ours("courtyard", 128, 96);
    const Counted halved(subject, {}), whole(subject, {.halve = false});
    for (const auto& [id, light] : halved.json["lights"].items()) {
        EXPECT_GT(halved.value(id, "quads.halved"), 0.0) << id;
        EXPECT_EQ(whole.value(id, "quads.halved"), 0.0) << id;
        expectCounter("quads.halved", "quads less than without", halved.value(id, "quads.halved"),
                      whole.value(id, "quads") - halved.value(id, "quads"));
    }
}

TEST(Fill, SkippedCastersFillNothingAndEndedOnesLess) {
    const Subject subject = ours("courtyard", 128, 96);
    const Counted skipped(subject, {}), plain(subject, {.skipOutOfView = false, .endVolumes = false});
    const auto fragmentsOf = [](const Counted& counted, const std::string& light, const std::string& caster) {
        const Json& casters = counted.json["lights"][light]["casters"];
        return casters.contains(caster) ? casters[caster]["values"].value("overdraw.fragments", 0.0) : 0.0;
    };
    double outOfView = 0, ended = 0;
    for (const LightPlanes& planes : skipped.pixels.lights) {
        if (!skipped.json["lights"].contains(planes.id)) continue;
        double empty = 0, shrunk = 0;
        for (const Instance& instance : skipped.moment.instances) {
            const std::string& path = subject.scene.nodes[std::size_t(instance.node)].path;
            const double before = fragmentsOf(plain, planes.id, path), after = fragmentsOf(skipped, planes.id, path);
            empty += before == 0.0;
            shrunk += after < 0.999 * before;
            EXPECT_LE(after, 1.001 * before) << planes.id << " " << path;
        }
        // On the safe side: fewer may be skipped than could be, more may end than lose a fragment.
        const double view = skipped.value(planes.id, "casters.outOfView"),
                     end = skipped.value(planes.id, "casters.ended");
        expectCounter("casters.outOfView", "casters without a fragment (at most)", view, empty, empty - view);
        expectCounter("casters.ended", "casters that lose fragments (at least)", end, shrunk, end - shrunk);
        outOfView += view;
        ended += end;
    }
    EXPECT_GT(outOfView, 20.0);
    EXPECT_GT(ended, 100.0);
    EXPECT_LT(skipped.value("overdraw.fragments"), 0.9 * plain.value("overdraw.fragments"));
}

class Sums : public testing::TestWithParam<std::tuple<bool, int>> {};
INSTANTIATE_TEST_SUITE_P(CountsAndSamples, Sums,
                         testing::Values(std::tuple{false, 1}, std::tuple{true, 1}, std::tuple{false, 4}));

TEST_P(Sums, CastersMakeTheLightAndLightsTheFrame) {
    const auto [counts, samples] = GetParam();
    const Counted counted(ours("courtyard", 256, 192), {.counts = counts}, samples);
    for (const char* counter : {"overdraw.fragments", "overdraw.updates"}) {
        double lights = 0;
        for (const auto& [id, light] : counted.json["lights"].items()) {
            double casters = 0;
            for (const auto& [path, caster] : light["casters"].items()) casters += caster["values"].value(counter, 0.0);
            EXPECT_EQ(casters, light["values"].value(counter, 0.0)) << id << " " << counter;
            lights += light["values"].value(counter, 0.0);
        }
        double casters = 0;
        for (const auto& [path, caster] : counted.json["casters"].items())
            casters += caster["values"].value(counter, 0.0);
        EXPECT_EQ(lights, counted.value(counter)) << counter;
        EXPECT_EQ(casters, counted.value(counter)) << counter;
        EXPECT_GT(lights, 0.0);
    }
    for (const auto& [id, light] : counted.json["lights"].items()) {
        const auto value = [&](const char* counter) { return light["values"].value(counter, 0.0); };
        EXPECT_EQ(value("overdraw.sides") + value("overdraw.lightCaps") + value("overdraw.darkCaps"),
                  value("overdraw.fragments"));
        EXPECT_EQ(value("overdraw.passed") + value("overdraw.failed"), value("overdraw.fragments"));
        EXPECT_EQ(value("overdraw.entered") + value("overdraw.left"), value("overdraw.updates"));
        EXPECT_EQ(value("edges.silhouette.once") + value("edges.silhouette.twice"), value("edges.silhouette"));
        EXPECT_EQ(value("tiles.processed") + value("tiles.culled"), value("tiles.touched"));
        expectCounter("overdraw.fragments", "GL_SAMPLES_PASSED", value("overdraw.fragments"),
                      value("overdraw.queried"));
        EXPECT_LE(value("tiles.touched"), counted.value("tiles"));
    }
    double materials = 0;
    for (const auto& [name, material] : counted.json["materials"].items())
        materials += material["values"].value("scene.fragments", 0.0);
    EXPECT_EQ(materials, counted.value("scene.fragments"));
    EXPECT_GT(counted.json["materials"].size(), 5u);
    double perPixel = 0;
    for (const float fragments : counted.pixels.overdrawFragments) perPixel += double(fragments);
    EXPECT_NEAR(perPixel * samples, counted.value("overdraw.fragments"), 1e-6 * perPixel);
    expectCounter("overdraw.depthComplexity", "the pixels' mean", counted.value("overdraw.depthComplexity"),
                  perPixel / (256 * 192), 1e-6);
    EXPECT_NEAR(counted.json["distributions"]["overdraw"]["mean"].get<double>(), perPixel / (256 * 192),
                1e-6 * perPixel);
}

/// The depth test that the tally makes itself is the one that the stencil test goes by.
TEST(Fill, EntersLessLeavesAndTheEyeConstantAreTheStencilsCounts) {
    for (const char* name : {"courtyard", "lantern", "knight"}) {
        const Subject subject = ours(name, 256, 192);
        const Counted counted(subject), halved(subject, {.endVolumes = false});
        for (const LightPlanes& light : counted.pixels.lights) {
            double sum = 0;
            for (const std::uint32_t count : light.counts) sum += count;
            EXPECT_GT(sum, 0.0) << name << " " << light.id;
            // A pixel on whose border rounding made -1 counts one there and two less in the net count.
            const double net = counted.value(light.id, "count.net");
            EXPECT_LE(net, sum) << name << " " << light.id;
            expectCounter("count.net", "the stencil buffer", net, sum, 2.0 * 4);
            EXPECT_EQ(std::fmod(sum - net, 2.0), 0.0) << name << " " << light.id;
            // Volumes that end early do not hold the background.
            if (halved.json["lights"][light.id]["values"].contains("count.net") &&
                halved.value(light.id, "casters.outOfReach") == 0) {
                EXPECT_EQ(net, halved.value(light.id, "count.net")) << name << " " << light.id << ", halved";
            }
        }
    }
}

}  // namespace
}  // namespace umbrage::test
