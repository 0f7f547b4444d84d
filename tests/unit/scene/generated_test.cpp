// SPDX-License-Identifier: Apache-2.0
// Generated scenes have what was asked for, and their bodies are closed.
#include "scene/generated.h"

#include <gtest/gtest.h>

#include <cmath>

#include "scene/moment.h"
#include "scene/node_paths.h"
#include "scene/topology.h"

namespace umbrage {
namespace {

std::uint32_t bodyTriangles(const Scene& scene) {
    std::uint32_t sum = 0;
    for (const Mesh& mesh : scene.meshes) sum += mesh.triangleCount();
    return sum - 2;  // the ground's
}

double volumeOf(const Mesh& mesh) {
    double sum = 0.0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const auto corner = [&](std::size_t c) { return glm::dvec3(mesh.positions[mesh.indices[i + c]]); };
        sum += glm::dot(corner(0), glm::cross(corner(1), corner(2))) / 6.0;
    }
    return sum;
}

TEST(Generated, BodiesAreClosedAndOutsideOutwards) {
    for (const int k : {1, 2, 3, 8, 31}) {
        SCOPED_TRACE(k);
        const Mesh mesh = noisyBody(k, {1.0, 2.0, 0.5}, k < 3 ? 0.0 : 0.6, 7);
        EXPECT_EQ(mesh.triangleCount(), 8u * unsigned(k * k));
        EXPECT_EQ(mesh.positions.size(), 4u * unsigned(k * k) + 2u);
        const MeshTopology::Figures figures = buildTopology(mesh, {}).figures;
        EXPECT_EQ(figures.weldedVertices, mesh.positions.size());
        EXPECT_EQ(figures.edges, 12u * unsigned(k * k));
        EXPECT_EQ(figures.openEdges + figures.nonManifoldEdges + figures.inconsistentEdges, 0u);
        EXPECT_EQ(figures.closedComponents, 1u);
        EXPECT_EQ(figures.degenerateTriangles, 0u);
    }
    const double ellipsoid = 4.0 / 3.0 * std::acos(-1.0) * 1.0 * 2.0 * 0.5;
    EXPECT_NEAR(volumeOf(noisyBody(64, {1.0, 2.0, 0.5}, 0.0, 7)), ellipsoid, 0.01 * ellipsoid);
}

TEST(Generated, TrianglesAreAsManyAsAskedFor) {
    for (const int wanted : {1000, 4000, 16000, 64000, 250000}) {
        const double made = bodyTriangles(generatedScene({.triangles = wanted}));
        EXPECT_NEAR(made, wanted, 4.0 * (2.0 * std::sqrt(wanted / 512.0) + 1.0)) << wanted;
    }
    EXPECT_EQ(bodyTriangles(generatedScene({.triangles = 8, .columns = 5, .layers = 2})), 80u) << "8 a body at least";
}

TEST(Generated, MovesTheShareThatIsAskedFor) {
    for (const double percent : {0.0, 25.0, 50.0, 100.0}) {
        const Scene scene = generatedScene({.triangles = 1000, .moving = percent, .movingLights = percent == 25.0});
        const Moment first = evaluate(scene, std::vector<Index>{0}, 0.0),
                     later = evaluate(scene, std::vector<Index>{0}, 0.7);
        int bodies = 0, lights = 0;
        for (std::size_t i = 0; i < first.instances.size(); ++i) {
            bodies += first.instances[i].worldFromModel != later.instances[i].worldFromModel;
        }
        for (std::size_t i = 0; i < first.lights.size(); ++i) {
            lights += first.lights[i].position != later.lights[i].position;
        }
        EXPECT_EQ(bodies, int(0.64 * percent));
        EXPECT_EQ(lights, percent == 25.0 ? 3 : 0);
    }
}

TEST(Generated, BodiesStandApartAndAboveTheGround) {
    const Scene scene =
        generatedScene({.triangles = 20000, .columns = 9, .layers = 5, .roughness = 1.0, .moving = 0.0});
    const Moment moment = evaluate(scene, {}, 0.0);
    std::vector<std::array<glm::dvec3, 2>> boxes;
    for (const Instance& instance : moment.instances) {
        if (scene.nodes[std::size_t(instance.node)].name == "Ground") continue;
        std::array<glm::dvec3, 2> box{glm::dvec3(INFINITY), glm::dvec3(-INFINITY)};
        for (const glm::vec3& position : scene.meshes[std::size_t(instance.mesh)].positions) {
            const glm::dvec3 at(instance.worldFromModel * glm::dvec4(position, 1.0));
            box = {glm::min(box[0], at), glm::max(box[1], at)};
        }
        EXPECT_GT(box[0].y, 0.0);
        for (const auto& other : boxes) {
            const bool apart = glm::any(glm::lessThan(box[1], other[0])) || glm::any(glm::lessThan(other[1], box[0]));
            EXPECT_TRUE(apart);
        }
        boxes.push_back(box);
    }
    EXPECT_EQ(boxes.size(), 45u);
}

}  // namespace
}  // namespace umbrage
