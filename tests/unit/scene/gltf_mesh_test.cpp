// SPDX-License-Identifier: Apache-2.0
// Meshes: primitive modes, shared arrays, influences, morph targets, and the checks that need the data.
#include <cmath>

#include "gltf_builder.h"

namespace umbrage {
namespace {

using Indices = std::vector<std::uint32_t>;

/// Five vertices on a zigzag, drawn in some mode.
Mesh zigzag(int mode, std::optional<std::vector<std::uint16_t>> indices = std::nullopt) {
    GltfBuilder builder;
    builder.triangle();
    builder.primitive()["attributes"]["POSITION"] = builder.vec3s({0, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 0, 2, 0, 0});
    builder.primitive()["mode"] = mode;
    if (indices) {
        builder.primitive()["indices"] = builder.accessor("SCALAR", *indices, indices->size());
    }
    return builder.load().meshes.at(0);
}

TEST(GltfPrimitiveModes, EveryModeBecomesAList) {
    EXPECT_EQ(zigzag(0).indices, (Indices{0, 1, 2, 3, 4}));
    EXPECT_EQ(zigzag(1).indices, (Indices{0, 1, 2, 3}));
    EXPECT_EQ(zigzag(2).indices, (Indices{0, 1, 1, 2, 2, 3, 3, 4, 4, 0}));
    EXPECT_EQ(zigzag(3).indices, (Indices{0, 1, 1, 2, 2, 3, 3, 4}));
    EXPECT_EQ(zigzag(4).indices, (Indices{0, 1, 2}));
    EXPECT_EQ(zigzag(5).indices, (Indices{0, 1, 2, 1, 3, 2, 2, 3, 4}));
    EXPECT_EQ(zigzag(6).indices, (Indices{1, 2, 0, 2, 3, 0, 3, 4, 0}));
    EXPECT_EQ(zigzag(5, std::vector<std::uint16_t>{4, 3, 2, 1}).indices, (Indices{4, 3, 2, 3, 1, 2}));
    EXPECT_EQ(zigzag(0).primitives[0].topology, Topology::Points);
    EXPECT_EQ(zigzag(3).primitives[0].topology, Topology::Lines);
    EXPECT_EQ(zigzag(5).triangleCount(), 3);
    EXPECT_EQ(zigzag(2).triangleCount(), 0);
}

TEST(GltfPrimitiveModes, AllTrianglesOfAStripAndAFanFaceTheSameWay) {
    // A fan needs a convex outline, which the zigzag is not: its vertices are taken around the outline here.
    for (const Mesh& mesh : {zigzag(5), zigzag(6, std::vector<std::uint16_t>{1, 3, 4, 2, 0})}) {
        const auto normal = [&](std::size_t t) {
            const auto p = [&](std::size_t k) { return mesh.positions[mesh.indices[3 * t + k]]; };
            return glm::cross(p(1) - p(0), p(2) - p(0)).z;
        };
        for (std::size_t t = 0; t < 3; ++t) {
            EXPECT_LT(normal(t), 0.0f) << t;
        }
    }
}

TEST(GltfPrimitiveModes, TooFewVerticesForAnElementDrawNothing) {
    for (const int mode : {1, 2, 3, 4, 5, 6}) {
        EXPECT_TRUE(zigzag(mode, std::vector<std::uint16_t>{1}).indices.empty()) << mode;
    }
}

class GltfMesh : public testing::Test {
protected:
    GltfMesh() { builder.triangle(); }
    json& attributes() { return builder.primitive()["attributes"]; }
    Mesh mesh() const { return builder.load().meshes.at(0); }

    GltfBuilder builder;
    const std::string kPrimitive = "/meshes/0/primitives/0";
};

TEST_F(GltfMesh, AnIndexBeyondTheVerticesIsAnErrorWithItsAccessorAndValue) {
    const json indices = builder.accessor<std::uint8_t>("SCALAR", {0, 1, 3}, 3);
    builder.primitive()["indices"] = indices;
    expectGltfError(builder, kPrimitive + "/indices",
                    "index 2 of accessor " + indices.dump() + " is 3, but there are 3 vertices");
}

TEST_F(GltfMesh, ThePrimitiveRestartValueIsAnErrorEvenWhereItNamesAVertex) {
    attributes()["POSITION"] = builder.vec3s(std::vector<float>(3 * 256, 1.0f));
    builder.primitive()["indices"] = builder.accessor<std::uint8_t>("SCALAR", {0, 1, 255}, 3);
    expectGltfError(builder, kPrimitive + "/indices", "restart");
}

TEST_F(GltfMesh, ATrianglesRestIsIgnoredWithANote) {
    builder.primitive()["indices"] = builder.accessor<std::uint8_t>("SCALAR", {0, 1, 2, 0, 1}, 5);
    const Scene scene = builder.load();
    EXPECT_EQ(scene.meshes[0].indices, (Indices{0, 1, 2}));
    EXPECT_TRUE(hasNote(scene, "2 vertices at the end"));
}

TEST_F(GltfMesh, MinusZeroBecomesZeroInPositions) {
    attributes()["POSITION"] = builder.vec3s({-0.0f, 0, 0, 1, -0.0f, 0, 0, 1, -0.0f});
    for (const glm::vec3& position : mesh().positions) {
        EXPECT_FALSE(std::signbit(position.x) || std::signbit(position.y) || std::signbit(position.z));
    }
}

TEST_F(GltfMesh, PrimitivesAreSortedByTopologyAndKeepTheirMaterials) {
    builder.document["materials"] = {{{"name", "points"}}, {{"name", "triangles"}}, {{"name", "lines"}}};
    json& primitives = builder.document["meshes"][0]["primitives"];
    const json first = primitives[0];
    primitives = json::array();
    for (const auto& [mode, material] : {std::pair{0, 0}, {4, 1}, {2, 2}}) {
        json primitive = first;
        primitive["mode"] = mode;
        primitive["material"] = material;
        primitive["attributes"]["POSITION"] = builder.vec3s({0, 0, 0, 1, 0, 0, 0, 1, 0});
        primitives.push_back(primitive);
    }
    const Mesh mesh = this->mesh();
    ASSERT_EQ(mesh.primitives.size(), 3);
    EXPECT_EQ(mesh.primitives[0].material, 1);
    EXPECT_EQ(mesh.primitives[1].material, 2);
    EXPECT_EQ(mesh.primitives[2].material, 0);
    EXPECT_EQ(mesh.positions.size(), 9);
    EXPECT_EQ(mesh.primitives[0].firstVertex, 3);
    EXPECT_EQ(mesh.indices, (Indices{3, 4, 5, 6, 7, 7, 8, 8, 6, 0, 1, 2}));
}

TEST_F(GltfMesh, PrimitivesOfTheSameAccessorsShareTheirVertices) {
    json& primitives = builder.document["meshes"][0]["primitives"];
    primitives.push_back(primitives[0]);
    const Mesh mesh = this->mesh();
    EXPECT_EQ(mesh.positions.size(), 3);
    EXPECT_EQ(mesh.indices, (Indices{0, 1, 2, 0, 1, 2}));
}

TEST_F(GltfMesh, AttributesThatOnlySomePrimitivesHaveAreFilledForTheOthers) {
    json& primitives = builder.document["meshes"][0]["primitives"];
    for (int i = 0; i < 2; ++i) {
        primitives.push_back(primitives[0]);
        primitives.back()["attributes"]["POSITION"] = builder.vec3s({0, 0, 1, 1, 0, 1, 0, 1, 1});
    }
    primitives[1]["attributes"]["NORMAL"] = builder.vec3s({0, 0, 1, 0, 0, 1, 0, 0, 1});
    primitives[1]["attributes"]["COLOR_0"] = builder.vec3s({.1f, .2f, .3f, 0, 0, 0, 1, 1, 1});
    const Mesh mesh = this->mesh();
    ASSERT_EQ(mesh.normals.size(), 9);
    ASSERT_EQ(mesh.colors.size(), 9);
    EXPECT_FALSE(mesh.primitives[0].hasNormals);
    EXPECT_TRUE(mesh.primitives[1].hasNormals);
    EXPECT_EQ(mesh.normals[3], glm::vec3(0, 0, 1));
    EXPECT_EQ(mesh.colors[0], glm::vec4(1.0f));
    EXPECT_EQ(mesh.colors[3], glm::vec4(.1f, .2f, .3f, 1.0f));
    EXPECT_EQ(mesh.colors[8], glm::vec4(1.0f));
}

TEST_F(GltfMesh, TangentsWithoutNormalsDoNotCount) {
    attributes()["TANGENT"] = builder.vec4s({1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, -1});
    EXPECT_FALSE(mesh().primitives[0].hasTangents);
    attributes()["NORMAL"] = builder.vec3s({0, 0, 1, 0, 0, 1, 0, 0, 1});
    EXPECT_TRUE(mesh().primitives[0].hasTangents);
    EXPECT_EQ(mesh().tangents[2].w, -1.0f);
}

TEST_F(GltfMesh, AttributeCountsMustAgree) {
    attributes()["NORMAL"] = builder.vec3s({0, 0, 1, 0, 0, 1});
    expectGltfError(builder, kPrimitive + "/attributes/NORMAL", "has 2 elements, but POSITION has 3");
}

TEST_F(GltfMesh, AttributeFormatsAreThoseOfTheSpecification) {
    attributes()["COLOR_0"] = builder.accessor<float>("VEC2", {0, 0, 0, 0, 0, 0}, 3);
    expectGltfError(builder, kPrimitive + "/attributes/COLOR_0", "VEC2 of FLOAT");
    attributes().erase("COLOR_0");
    attributes()["JOINTS_0"] = attributes()["WEIGHTS_0"] = builder.vec4s(std::vector<float>(12));
    expectGltfError(builder, kPrimitive + "/attributes/JOINTS_0",
                    "allowed: VEC4 of UNSIGNED_BYTE; VEC4 of UNSIGNED_SHORT");
}

TEST_F(GltfMesh, UnsupportedSetsAndUnknownAttributesAreNotedButUnderscoresAreSilent) {
    attributes()["TEXCOORD_2"] = builder.accessor<float>("VEC2", {0, 0, 0, 0, 0, 0}, 3);
    attributes()["COLOR_1"] = attributes()["_MINE"] = attributes()["POSITION"];
    attributes()["STRANGE"] = attributes()["POSITION"];
    const Scene scene = builder.load();
    EXPECT_TRUE(hasNote(scene, "TEXCOORD_2"));
    EXPECT_TRUE(hasNote(scene, "COLOR_1"));
    EXPECT_TRUE(hasNote(scene, "STRANGE"));
    EXPECT_FALSE(hasNote(scene, "_MINE"));
}

TEST_F(GltfMesh, APrimitiveWithoutPositionsIsLeftOutWithANote) {
    attributes().erase("POSITION");
    const Scene scene = builder.load();
    EXPECT_TRUE(scene.meshes[0].primitives.empty());
    EXPECT_TRUE(hasNote(scene, "no POSITION"));
}

TEST_F(GltfMesh, ReferencesOutOfRangeAreErrorsAtTheirPlace) {
    attributes()["POSITION"] = 9;
    expectGltfError(builder, kPrimitive + "/attributes/POSITION", "names accessor 9");
    attributes()["POSITION"] = 0;
    builder.primitive()["material"] = 0;
    expectGltfError(builder, kPrimitive + "/material", "names material 0");
    builder.primitive().erase("material");
    builder.primitive()["mode"] = 7;
    expectGltfError(builder, kPrimitive + "/mode", "from 0 to 6");
    builder.primitive()["mode"] = 4;
    builder.primitive()["indices"] = 0;
    expectGltfError(builder, kPrimitive + "/indices", "VEC3 of FLOAT");
}

TEST_F(GltfMesh, DracoWithAFallbackLoadsTheFallbackAndWithoutOneIsAnErrorThatNamesIt) {
    builder.document["extensionsUsed"] = {"KHR_draco_mesh_compression"};
    builder.primitive()["extensions"]["KHR_draco_mesh_compression"] = {{"bufferView", 0},
                                                                       {"attributes", {{"POSITION", 0}}}};
    EXPECT_EQ(mesh().positions[1], glm::vec3(1, 0, 0));
    builder.document["accessors"][0].erase("bufferView");
    expectGltfError(builder, kPrimitive + "/attributes/POSITION", "KHR_draco_mesh_compression");
}

class GltfSkinnedMesh : public GltfMesh {
protected:
    GltfSkinnedMesh() {
        builder.document["nodes"] = {{{"mesh", 0}, {"skin", 0}}, {{"name", "a"}}, {{"name", "b"}}};
        builder.document["skins"] = {{{"joints", {1, 2}}}};
        builder.document["scenes"][0]["nodes"] = {0, 1, 2};
        attributes()["JOINTS_0"] = builder.accessor<std::uint8_t>("VEC4", {0, 1, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, 3);
        attributes()["WEIGHTS_0"] = builder.vec4s({.5f, .5f, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0});
    }
};

TEST_F(GltfSkinnedMesh, WeightsAreNormalisedAndAVertexWithoutAnyFollowsItsFirstJoint) {
    const Scene scene = builder.load();
    const Mesh& mesh = scene.meshes[0];
    EXPECT_EQ(mesh.influenceSets(), 1);
    EXPECT_EQ(mesh.joints[0], glm::u16vec4(0, 1, 0, 0));
    EXPECT_EQ(mesh.weights[0], glm::vec4(.5f, .5f, 0, 0));
    EXPECT_EQ(mesh.weights[1], glm::vec4(1, 0, 0, 0));
    EXPECT_EQ(mesh.weights[2], glm::vec4(1, 0, 0, 0));
    EXPECT_TRUE(hasNote(scene, "did not add up"));
    EXPECT_TRUE(hasNote(scene, "bound to its first joint"));
}

TEST_F(GltfSkinnedMesh, SeveralSetsOfInfluencesAreVertexMajorAndNormalisedTogether) {
    attributes()["JOINTS_1"] = builder.accessor<std::uint16_t>("VEC4", {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, 3);
    attributes()["WEIGHTS_1"] =
        builder.accessor<std::uint8_t>("VEC4", {255, 0, 0, 0, 0, 0, 0, 0, 255, 0, 0, 0}, 3, true);
    const Mesh mesh = this->mesh();
    ASSERT_EQ(mesh.influenceSets(), 2);
    EXPECT_EQ(mesh.weights[0], glm::vec4(.25f, .25f, 0, 0));
    EXPECT_EQ(mesh.weights[1], glm::vec4(.5f, 0, 0, 0));
    EXPECT_EQ(mesh.joints[1], glm::u16vec4(1, 0, 0, 0));
    EXPECT_EQ(mesh.weights[5], glm::vec4(1, 0, 0, 0));
}

TEST_F(GltfSkinnedMesh, FaultyInfluencesAreErrorsAtTheirPlace) {
    attributes()["JOINTS_0"] = builder.accessor<std::uint8_t>("VEC4", {0, 1, 0, 0, 1, 0, 0, 2, 1, 0, 0, 0}, 3);
    expectGltfError(builder, kPrimitive + "/attributes/JOINTS_0", "names joint 2, but skin 0 has 2 joints");
    attributes()["JOINTS_0"] = builder.accessor<std::uint8_t>("VEC4", std::vector<std::uint8_t>(12), 3);
    attributes()["WEIGHTS_0"] = builder.vec4s({1, 0, 0, 0, -1, 0, 0, 0, 1, 0, 0, 0});
    expectGltfError(builder, kPrimitive + "/attributes/WEIGHTS_0", "vertex 1 has the negative weight -1");
    attributes().erase("WEIGHTS_0");
    expectGltfError(builder, kPrimitive + "/attributes", "only one of JOINTS_0 and WEIGHTS_0");
    attributes().erase("JOINTS_0");
    expectGltfError(builder, "/nodes/0/skin", "cannot be skinned");
}

TEST_F(GltfSkinnedMesh, FaultySkinsAreErrorsAtTheirPlace) {
    json& skin = builder.document["skins"][0];
    skin["inverseBindMatrices"] = builder.accessor<float>("MAT4", std::vector<float>(16), 1);
    expectGltfError(builder, "/skins/0/inverseBindMatrices", "1 matrices for 2 joints");
    skin["inverseBindMatrices"] = builder.accessor<float>("MAT4", std::vector<float>(32), 2);
    expectGltfError(builder, "/skins/0/inverseBindMatrices", "last row of matrix 0");
    skin.erase("inverseBindMatrices");
    skin["joints"] = {1, 1};
    expectGltfError(builder, "/skins/0/joints/1", "twice");
    skin["joints"] = {1, 3};
    expectGltfError(builder, "/skins/0/joints/1", "names node 3");
    skin["joints"] = json::array();
    expectGltfError(builder, "/skins/0/joints", "at least one");
}

TEST_F(GltfMesh, MorphTargetsHaveDisplacementsOfPositionsNormalsAndTangents) {
    builder.primitive()["targets"] = {{{"POSITION", builder.vec3s({0, 0, 1, 0, 0, 2, 0, 0, 3})},
                                       {"NORMAL", builder.vec3s({1, 0, 0, 0, 0, 0, 0, 0, 0})}},
                                      {{"TANGENT", builder.vec3s({0, 1, 0, 0, 0, 0, 0, 0, 0})}}};
    builder.document["meshes"][0]["weights"] = {0.25, 0.5};
    const Mesh mesh = this->mesh();
    ASSERT_EQ(mesh.morphTargets.size(), 2);
    EXPECT_EQ(mesh.morphTargets[0].positions[2], glm::vec3(0, 0, 3));
    EXPECT_EQ(mesh.morphTargets[0].normals[0], glm::vec3(1, 0, 0));
    EXPECT_TRUE(mesh.morphTargets[0].tangents.empty());
    EXPECT_EQ(mesh.morphTargets[1].tangents[0], glm::vec3(0, 1, 0));
    EXPECT_EQ(mesh.defaultMorphWeights, (std::vector<float>{0.25f, 0.5f}));
}

TEST_F(GltfMesh, MorphTargetCountsMustAgree) {
    builder.primitive()["targets"] = {{{"POSITION", builder.vec3s({0, 0, 1})}}};
    expectGltfError(builder, kPrimitive + "/targets/0/POSITION", "has 1 elements, but POSITION has 3");
    builder.primitive()["targets"] = {{{"POSITION", 0}}};
    builder.document["meshes"][0]["weights"] = {1, 2};
    expectGltfError(builder, "/meshes/0/weights", "must have 1 numbers, but has 2");
    builder.document["meshes"][0].erase("weights");
    builder.document["nodes"][0]["weights"] = json::array();
    expectGltfError(builder, "/nodes/0/weights", "must have 1 numbers, but has 0");
    builder.document["nodes"][0].erase("weights");
    json& primitives = builder.document["meshes"][0]["primitives"];
    primitives.push_back({{"attributes", {{"POSITION", 0}}}});
    expectGltfError(builder, "/meshes/0/primitives/1", "has 0 morph targets");
}

}  // namespace
}  // namespace umbrage
