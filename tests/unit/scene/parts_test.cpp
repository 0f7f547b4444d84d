// SPDX-License-Identifier: Apache-2.0
// Parts of casters: which instances a glob gathers, and the shape of points.
#include "scene/parts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "error.h"
#include "scene/node_paths.h"

namespace umbrage {
namespace {

using testing::ElementsAre;

/// /Army/A and /Army/B, each with two limbs that have a mesh, of which A's first one holds a sword; /Ground; /Lamp.
struct Army {
    Scene scene;
    std::vector<Instance> instances;

    Army() {
        const Index army = addNode(scene, kNone, "Army", "/Army");
        for (const std::string name : {"A", "B"}) {
            const Index knight = addNode(scene, army, name, "/Army/" + name);
            const Index arm = withMesh(knight, "Arm");
            withMesh(knight, "Leg");
            if (name == "A") withMesh(arm, "Sword");
        }
        withMesh(kNone, "Ground");
        addNode(scene, kNone, "Lamp", "/Lamp");
    }

    Index withMesh(Index parent, const std::string& name) {
        const std::string above = parent == kNone ? "" : scene.nodes[std::size_t(parent)].path;
        const Index node = addNode(scene, parent, name, above + "/" + name);
        scene.nodes[std::size_t(node)].mesh = 0;
        instances.emplace_back().node = node;
        return node;
    }

    InstanceParts parts(const std::vector<std::string>& globs) const {
        std::vector<Located<std::string>> located;
        for (const std::string& glob : globs) located.push_back({glob, {}});
        return groupInstances(scene, instances, located);
    }
};

TEST(Parts, WithoutGlobsEveryInstanceIsOne) {
    EXPECT_THAT(Army().parts({}).ofInstance, ElementsAre(0, 1, 2, 3, 4, 5));
}

TEST(Parts, EverythingAtAndBelowEachMatchIsOne) {
    const Army army;
    const InstanceParts parts = army.parts({"/Army/*"});
    EXPECT_THAT(parts.ofInstance, ElementsAre(0, 0, 0, 1, 1, 2));
    EXPECT_EQ(army.scene.nodes[std::size_t(parts.nodes[1])].path, "/Army/B");
    EXPECT_EQ(army.scene.nodes[std::size_t(parts.nodes[2])].path, "/Ground");
}

TEST(Parts, OfNestedMatchesTheNearestCounts) {
    EXPECT_THAT(Army().parts({"/Army", "**/Sword"}).ofInstance, ElementsAre(0, 0, 1, 0, 0, 2));
}

TEST(Parts, AGlobWithoutAMeshIsRefusedAtItsPlace) {
    const Army army;
    const std::vector<Located<std::string>> globs = {{"/Lamp", {"a.yaml", 3, 9}}};
    try {
        groupInstances(army.scene, army.instances, globs);
        FAIL() << "not refused";
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("a.yaml:3:9"));
        EXPECT_THAT(error.what(), testing::HasSubstr("\"/Lamp\" matches no node with a mesh at or below it"));
    }
}

TEST(Parts, TheLongestAxisOfAStickEndsAtItsEnds) {
    std::vector<glm::dvec3> stick;
    const glm::dvec3 along = glm::normalize(glm::dvec3(1.0, 2.0, -0.5)),
                     across = glm::normalize(glm::dvec3(2.0, -1.0, 0.0));
    for (int i = 0; i <= 10; ++i) {
        for (const double side : {-0.1, 0.1}) stick.push_back(glm::dvec3(3.0) + double(i) * along + side * across);
    }
    const PartShape shape = shapeOf(stick);
    const double there = glm::distance(shape.axisEnds[0], glm::dvec3(3.0));
    EXPECT_NEAR(std::min(there, glm::distance(shape.axisEnds[1], glm::dvec3(3.0))), 0.0, 1e-9);
    EXPECT_NEAR(glm::distance(shape.axisEnds[0], shape.axisEnds[1]), 10.0, 1e-9);
    EXPECT_NEAR(shape.thinness, 50.0, 1e-6);
}

TEST(Parts, PointsOnALineAreInfinitelyThinAndOnePointIsNot) {
    EXPECT_EQ(shapeOf(std::vector<glm::dvec3>{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}).thinness > 1e6, true);
    EXPECT_EQ(shapeOf(std::vector<glm::dvec3>{{1, 2, 3}}).thinness, 1.0);
    EXPECT_EQ(shapeOf({}).thinness, 1.0);
}

}  // namespace
}  // namespace umbrage
