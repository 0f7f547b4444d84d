// SPDX-License-Identifier: Apache-2.0
// Layers, opinions on nodes, displacements and animations.
#include "compose_fixture.h"

namespace umbrage::test {
namespace {

TEST_F(Compose, OneLayerIsTheFileItself) {
    const Composition one = composed(kRoom);
    EXPECT_THAT(pathsOf(one.scene),
                ElementsAre("/Room", "/Room/LampA", "/Room/LampB", "/Room/Spot", "/Room/Cam", "/Room/Figure"));
    EXPECT_EQ(one.scene.nodes[static_cast<std::size_t>(one.cameraNode)].path, "/Room/Cam");
    EXPECT_THAT(one.animations, ElementsAre(0));
    EXPECT_TRUE(one.scene.notes.empty());
}

TEST_F(Compose, LayersAreAppendedWithTheirOwnData) {
    const Composition both = composed(kFigure + kRoom);
    expectParentsFirst(both.scene);
    EXPECT_THAT(pathsOf(both.scene), ElementsAre("/Figure", "/Room", "/Room/LampA", "/Room/LampB", "/Room/Spot",
                                                 "/Room/Cam", "/Room/Figure"));
    EXPECT_EQ(both.scene.meshes.size(), 2u);
    EXPECT_EQ(nodeAt(both.scene, "/Room/Figure").mesh, 1);
    EXPECT_EQ(both.scene.meshes[1].primitives[0].material, 1);
    EXPECT_EQ(lightAt(both.scene, "/Room/Spot").name, "beam");
    expectNear(worldPosition(both, "/Room/Figure", 0.5), {1, 0, 0});
    expectNear(worldPosition(both, "/Figure", 0.5), {0, 0, 0});
}

TEST_F(Compose, EqualRootsGetAnIndex) {
    const Composition twice = composed(kRoom + kRoom + kRoom);
    EXPECT_NE(findNode(twice.scene, "/Room_1/LampA"), kNone);
    EXPECT_NE(findNode(twice.scene, "/Room_2/LampA"), kNone);
}

TEST_F(Compose, ATransformScalesThenTurnsThenMoves) {
    const Composition moved = composed("- {gltf: room.gltf, translate: [10, 0, 0], rotate: [90, 90, 0], scale: 2}\n");
    expectParentsFirst(moved.scene);
    EXPECT_NE(findNode(moved.scene, "/room/Room/LampA"), kNone) << "its node is named after the file";
    // (0, 1, 0) is scaled to (0, 2, 0), turned about x to (0, 0, 2), about y to (2, 0, 0), and moved
    expectNear(worldPosition(moved, "/room/Room/LampA", 0), {12, 0, 0});
}

TEST_F(Compose, AtMakesWhatIsNotThere) {
    const Composition placed = composed("- {gltf: figure.gltf, at: /Hall/Guests, translate: [1, 2, 3]}\n");
    EXPECT_THAT(pathsOf(placed.scene), testing::Contains("/Hall/Guests/Figure"));
    EXPECT_EQ(nodeAt(placed.scene, "/Hall").translation, glm::dvec3(0.0));
    EXPECT_EQ(nodeAt(placed.scene, "/Hall/Guests").translation, glm::dvec3(1, 2, 3));
    EXPECT_EQ(nodeAt(placed.scene, "/Hall/Guests").name, "Guests");
    expectParentsFirst(placed.scene);
}

TEST_F(Compose, AtANodeOfAnEarlierLayerFollowsIt) {
    const Composition placed =
        composed(kRoom + "- {gltf: figure.gltf, at: /Room/LampA, scale: 3}\n" +
                 "- {gltf: figure.gltf, at: /Room/LampA}\n" + "- {gltf: figure.gltf, at: /Room/LampA}\n");
    expectParentsFirst(placed.scene);
    EXPECT_EQ(nodeAt(placed.scene, "/Room/LampA").scale, glm::dvec3(1.0)) << "a node that was there is not changed";
    EXPECT_EQ(nodeAt(placed.scene, "/Room/LampA/figure").scale, glm::dvec3(3.0));
    EXPECT_NE(findNode(placed.scene, "/Room/LampA/figure/Figure"), kNone);
    EXPECT_NE(findNode(placed.scene, "/Room/LampA/Figure"), kNone);
    EXPECT_NE(findNode(placed.scene, "/Room/LampA/Figure_1"), kNone);
    expectNear(worldPosition(placed, "/Room/LampA/Figure", 0), {0, 1, 0});
}

TEST_F(Compose, AMissingFileIsReportedAtItsPlace) {
    expectError("- gltf: nowhere.glb\n", "", "s.yaml:3:9", "there is no file", "folder");
    expectError("- {gltf: room.gltf, at: /A//B}\n", "", "s.yaml:3:25", "empty part", "");
}

TEST_F(Compose, DisplacementsAreLaidOnMeshes) {
    const Composition moved =
        composed(kRoom + kFigure,
                 "displace: {\"/**/Figure\": {amplitude: .5}, /Figure: {amplitude: 1, frequency: 2, speed: 3},"
                 " /Room/Figure: {amplitude: .7}}\n");
    ASSERT_EQ(moved.scene.displacements.size(), 2u);
    EXPECT_EQ(moved.scene.displacements[0].node, findNode(moved.scene, "/Figure"));
    EXPECT_EQ(moved.scene.displacements[0].frequency, 2);
    EXPECT_EQ(moved.scene.displacements[1].amplitude.values[0], .7f) << "the later one wins";
    expectError(kRoom, "displace: {/Room/Figur: {}}\n", "s.yaml:4:12", "matches no node with a mesh",
                "\"/Room/Figure\"");
}

TEST_F(Compose, AnimationsAreChosenByNameAndIndex) {
    EXPECT_THAT(composed(kRoom + kRoom).animations, ElementsAre(0)) << "the first, when nothing is said";
    EXPECT_THAT(composed(kRoom + kRoom, "animations: [1]\n").animations, ElementsAre(1));
    EXPECT_THAT(composed(kRoom + kRoom, "animations: [walk, 0]\n").animations, ElementsAre(0, 1))
        << "all of a name, each once";
    EXPECT_TRUE(composed(kRoom, "animations: []\n").animations.empty());
    EXPECT_TRUE(composed(kFigure).animations.empty());
    expectError(kRoom, "animations: [run]\n", "s.yaml:4:14", "there is no animation \"run\"", "0 \"walk\"");
    expectError(kRoom, "animations: [1]\n", "s.yaml:4:14", "there is no animation \"1\"", "0 \"walk\"");
    expectError(kFigure, "animations: [0]\n", "s.yaml:4:14", "there is no animation", "no animations");
}

TEST_F(Compose, ABareSceneFileComposes) {
    const Composition seen = compose(jobForScene(folder_ / "room.gltf"));
    EXPECT_EQ(seen.scene.nodes[static_cast<std::size_t>(seen.cameraNode)].path, "/Room/Cam");
}

}  // namespace
}  // namespace umbrage::test
