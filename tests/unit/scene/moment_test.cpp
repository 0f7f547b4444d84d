// SPDX-License-Identifier: Apache-2.0
// Animations of glTF files and the scene at a time, against values worked out by hand.
#include "scene/moment.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "gltf_builder.h"

namespace umbrage {
namespace {

constexpr double kHalfRoot = std::numbers::sqrt2 / 2.0;

std::vector<float> at(const Track& track, double time, bool spherical = false) {
    std::vector<float> result(static_cast<std::size_t>(track.width));
    sample(track, time, spherical, result);
    return result;
}

void expectNear(const glm::dvec3& a, const glm::dvec3& b, double tolerance = 1e-6) {
    for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(a[i], b[i], tolerance) << "component " << i;
    }
}

TEST(Sample, StepHoldsEachKeyUntilTheNext) {
    const Track track{{1, 2, 4}, {10, 20, 40}, 1, Interpolation::Step};
    EXPECT_EQ(at(track, 0)[0], 10);
    EXPECT_EQ(at(track, 1.99)[0], 10);
    EXPECT_EQ(at(track, 2)[0], 20);
    EXPECT_EQ(at(track, 3.99)[0], 20);
    EXPECT_EQ(at(track, 99)[0], 40);
}

TEST(Sample, LinearIsHeldAtBothEndsAndExactAtKeys) {
    const Track track{{1, 2, 4}, {10, 0, 20, 2, 40, 4}, 2, Interpolation::Linear};
    EXPECT_EQ(at(track, -5), (std::vector<float>{10, 0}));
    EXPECT_EQ(at(track, 1.5), (std::vector<float>{15, 1}));
    EXPECT_EQ(at(track, 2), (std::vector<float>{20, 2}));
    EXPECT_EQ(at(track, 3), (std::vector<float>{30, 3}));
    EXPECT_EQ(at(track, 4), (std::vector<float>{40, 4}));
    EXPECT_EQ(at(track, 5), (std::vector<float>{40, 4}));
}

TEST(Sample, CubicSplineScalesItsTangentsByTheDistanceOfTheKeys) {
    // Keys at 1 s and 3 s: values 2 and 5, out-tangent 4 and in-tangent -1 per second.
    const Track track{{1, 3}, {99, 2, 4, -1, 5, 99}, 1, Interpolation::CubicSpline};
    // s = 1/2: 0.5*2 + 0.125*2*4 + 0.5*5 - 0.125*2*(-1) = 1 + 1 + 2.5 + 0.25
    EXPECT_NEAR(at(track, 2)[0], 4.75, 1e-6);
    // s = 1/4: 0.84375*2 + 0.140625*8 + 0.15625*5 - 0.046875*(-2)
    EXPECT_NEAR(at(track, 1.5)[0], 1.6875 + 1.125 + 0.78125 + 0.09375, 1e-6);
    EXPECT_EQ(at(track, 1)[0], 2);
    EXPECT_EQ(at(track, 3)[0], 5);
    EXPECT_EQ(at(track, 0)[0], 2);
    EXPECT_EQ(at(track, 4)[0], 5);
}

TEST(Sample, RotationsTakeTheShorterWayOnTheSphere) {
    const auto half = [](double degrees) { return static_cast<float>(std::sin(degrees * std::numbers::pi / 360)); };
    const auto real = [](double degrees) { return static_cast<float>(std::cos(degrees * std::numbers::pi / 360)); };
    // From 0 to 90 degrees around z, the second key written as the opposite quaternion.
    const Track track{{0, 1}, {0, 0, 0, 1, 0, 0, -half(90), -real(90)}, 4, Interpolation::Linear};
    const auto q = at(track, 1.0 / 3.0, true);
    const float sign = q[3] < 0 ? -1.0f : 1.0f;
    EXPECT_NEAR(sign * q[2], half(30), 1e-6);
    EXPECT_NEAR(sign * q[3], real(30), 1e-6);
}

TEST(Sample, RotationsAreUnitQuaternionsWhateverTheKeysWere) {
    for (const Interpolation interpolation : {Interpolation::Step, Interpolation::Linear}) {
        const Track track{{0, 1}, {0, 0, 0, 3, 0, 0.2f, 0, 0}, 4, interpolation};
        for (const double time : {-1.0, 0.0, 0.3, 0.5, 1.0, 2.0}) {
            const auto q = at(track, time, true);
            EXPECT_NEAR(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3], 1.0, 1e-6);
        }
    }
}

TEST(Sample, ASplineThroughTheZeroQuaternionKeepsTheLastKey) {
    const Track track{{0, 1},
                      {0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, -1, 0, 0, 0, 0},
                      4,
                      Interpolation::CubicSpline};
    EXPECT_EQ(at(track, 0.5, true), (std::vector<float>{0, 0, 0, 1}));
}

class GltfAnimation : public testing::Test {
protected:
    GltfAnimation() {
        builder.triangle();
        builder.document["nodes"] = {{{"name", "A"}, {"mesh", 0}, {"children", {1}}}, {{"name", "B"}}};
    }

    void animate(int node, const char* path, const std::vector<float>& times, int output,
                 const char* interpolation = "LINEAR") {
        builder.document["animations"] = {
            {{"name", "anim"},
             {"samplers", {{{"input", builder.scalars(times)}, {"output", output}, {"interpolation", interpolation}}}},
             {"channels", {{{"sampler", 0}, {"target", {{"node", node}, {"path", path}}}}}}}};
    }
    Moment moment(double time) const {
        const Scene scene = builder.load();
        return evaluate(scene, std::vector<Index>{0}, time);
    }

    GltfBuilder builder;
};

TEST_F(GltfAnimation, TranslationRotationAndScaleMoveTheNodeAndItsChildren) {
    builder.document["nodes"][1]["translation"] = {1, 0, 0};
    animate(0, "translation", {0, 2}, builder.vec3s({0, 0, 0, 4, 0, 0}));
    expectNear(moment(0.5).worldFromNode[1][3], {2, 0, 0});
    animate(0, "rotation", {0, 1}, builder.vec4s({0, 0, 0, 1, 0, 0, float(kHalfRoot), float(kHalfRoot)}));
    expectNear(moment(0.5).worldFromNode[1][3], {kHalfRoot, kHalfRoot, 0});
    animate(0, "scale", {0, 1}, builder.vec3s({1, 1, 1, 3, 1, 1}), "STEP");
    expectNear(moment(0.5).worldFromNode[1][3], {1, 0, 0});
    expectNear(moment(1.0).worldFromNode[1][3], {3, 0, 0});
}

TEST_F(GltfAnimation, NormalisedIntegersMayHoldRotations) {
    animate(1, "rotation", {0}, builder.accessor<std::int16_t>("VEC4", {0, 0, 32767, 0}, 1, true));
    expectNear(moment(0).worldFromNode[1][0], {-1, 0, 0});
}

TEST_F(GltfAnimation, CubicSplinesOfAllPathsHaveThreeValuesAKey) {
    animate(0, "translation", {0, 1}, builder.vec3s({0, 0, 0, 1, 0, 0, 2, 0, 0, 0, 0, 0, 3, 0, 0, 0, 0, 0}),
            "CUBICSPLINE");
    // 0.5*1 + 0.125*2 + 0.5*3
    expectNear(moment(0.5).worldFromNode[0][3], {2.25, 0, 0});
    animate(0, "translation", {0, 1}, builder.vec3s({0, 0, 0, 1, 0, 0}), "CUBICSPLINE");
    expectGltfError(builder, "/animations/0/samplers/0/output",
                    "has 2 elements, but the translation of this sampler needs 6");
}

TEST_F(GltfAnimation, WeightsAreSampledForAllTargetsTogether) {
    builder.primitive()["targets"] = {{{"POSITION", 0}}, {{"POSITION", 0}}};
    animate(0, "weights", {0, 1}, builder.scalars({0, 1, 1, 3}));
    EXPECT_EQ(moment(0.5).instances.at(0).morphWeights, (std::vector<float>{0.5f, 2.0f}));
    animate(0, "weights", {0, 1}, builder.scalars({9, 9, 0, 1, 0, 0, 4, 0, 1, 3, 9, 9}), "CUBICSPLINE");
    // Second target: 0.5*1 + 0.5*3; first: 0.5*0 + 0.5*1 - 0.125*4
    EXPECT_EQ(moment(0.5).instances.at(0).morphWeights, (std::vector<float>{0.0f, 2.0f}));
    animate(0, "weights", {0, 1}, builder.scalars({0, 1, 1}));
    expectGltfError(builder, "/animations/0/samplers/0/output", "needs 4");
}

TEST_F(GltfAnimation, WeightsComeFromAnimationThenNodeThenMesh) {
    builder.primitive()["targets"] = {{{"POSITION", 0}}};
    builder.document["meshes"][0]["weights"] = {0.25};
    EXPECT_EQ(evaluate(builder.load(), {}, 0).instances[0].morphWeights, (std::vector<float>{0.25f}));
    builder.document["nodes"][0]["weights"] = {0.5};
    EXPECT_EQ(evaluate(builder.load(), {}, 0).instances[0].morphWeights, (std::vector<float>{0.5f}));
    animate(0, "weights", {0}, builder.scalars({0.75f}));
    EXPECT_EQ(moment(0).instances[0].morphWeights, (std::vector<float>{0.75f}));
}

TEST_F(GltfAnimation, FaultyTimesAndTargetsAreErrorsAtTheirPlace) {
    animate(0, "translation", {0, 1, 1}, builder.vec3s(std::vector<float>(9)));
    expectGltfError(builder, "/animations/0/samplers/0/input", "key 1 is at 1 s and key 2 at 1 s");
    animate(0, "translation", {-1, 1}, builder.vec3s(std::vector<float>(6)));
    expectGltfError(builder, "/animations/0/samplers/0/input", "must not be negative");
    animate(0, "translation", {0}, builder.vec3s({0, NAN, 0}));
    expectGltfError(builder, "/animations/0/samplers/0/output", "not a finite number");
    animate(0, "rotation", {0, 1}, builder.vec4s({0, 0, 0, 1, 0, 0, 0, 0}));
    expectGltfError(builder, "/animations/0/samplers/0/output", "key 1 is the zero quaternion");
    animate(0, "shear", {0}, builder.vec3s({0, 0, 0}));
    expectGltfError(builder, "/animations/0/channels/0/target/path", "shear");
    animate(7, "scale", {0}, builder.vec3s({0, 0, 0}));
    expectGltfError(builder, "/animations/0/channels/0/target/node", "names node 7");
    animate(0, "scale", {0}, builder.vec3s({0, 0, 0}), "BEZIER");
    expectGltfError(builder, "/animations/0/samplers/0/interpolation", "BEZIER");
    animate(0, "weights", {0}, builder.scalars({0}));
    expectGltfError(builder, "/animations/0/channels/0/target/path", "no mesh with morph targets");
    animate(0, "scale", {0}, builder.vec3s({0, 0, 0}));
    json& channels = builder.document["animations"][0]["channels"];
    channels.push_back(channels[0]);
    expectGltfError(builder, "/animations/0/channels/1/target", "already animated");
    channels.erase(1);
    builder.document["nodes"][0]["matrix"] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    expectGltfError(builder, "/animations/0/channels/0/target/path", "has a matrix");
}

TEST_F(GltfAnimation, PointerChannelsAreDroppedAndTheOthersKept) {
    builder.document["extensionsUsed"] = {"KHR_animation_pointer"};
    animate(0, "translation", {0}, builder.vec3s({1, 2, 3}));
    json& channels = builder.document["animations"][0]["channels"];
    channels.push_back(
        {{"sampler", 0},
         {"target",
          {{"path", "pointer"}, {"extensions", {{"KHR_animation_pointer", {{"pointer", "/nodes/0/scale"}}}}}}}});
    channels.push_back({{"sampler", 0}, {"target", {{"path", "scale"}}}});
    const Scene scene = builder.load();
    EXPECT_EQ(scene.animations.at(0).channels.size(), 1);
    EXPECT_TRUE(hasNote(scene, "KHR_animation_pointer"));
    builder.document.erase("extensionsUsed");
    expectGltfError(builder, "/animations/0/channels/1/target/path", "pointer");
}

TEST_F(GltfAnimation, OnlyTheChosenAnimationsPlayAndDriversAlwaysDo) {
    animate(0, "translation", {0}, builder.vec3s({1, 2, 3}));
    Scene scene = builder.load();
    expectNear(evaluate(scene, {}, 0).worldFromNode[0][3], {0, 0, 0});
    scene.drivers.push_back(
        {"driver", {{{0, 1}, {0, 0, 0, 8, 0, 0}, 3, Interpolation::Linear}}, {{0, Target::Translation, 0}}});
    expectNear(evaluate(scene, {}, 0.25).worldFromNode[0][3], {2, 0, 0});
}

TEST(Evaluate, TransformsAreComposedInDouble) {
    Scene scene;
    for (int i = 0; i < 3; ++i) {
        Node node;
        node.path = "/n";
        node.parent = i - 1;
        node.translation = glm::dvec3(i == 0 ? 1e9 : i == 1 ? 0.125 : -1e9, 0, 0);
        scene.nodes.push_back(node);
    }
    EXPECT_EQ(evaluate(scene, {}, 0).worldFromNode[2][3].x, 0.125);
}

TEST(Evaluate, SkinnedInstancesFollowTheirJointsAndNotTheirNode) {
    GltfBuilder builder;
    builder.triangle();
    builder.primitive()["attributes"]["JOINTS_0"] =
        builder.accessor<std::uint8_t>("VEC4", {0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0}, 3);
    builder.primitive()["attributes"]["WEIGHTS_0"] = builder.vec4s({1, 0, 0, 0, 1, 0, 0, 0, .5f, .5f, 0, 0});
    builder.document["nodes"] = {{{"mesh", 0}, {"skin", 0}, {"translation", {50, 50, 50}}},
                                 {{"translation", {10, 0, 0}}},
                                 {{"translation", {0, 20, 0}}, {"scale", {2, 2, 2}}}};
    builder.document["scenes"][0]["nodes"] = {0, 1, 2};
    std::vector<float> inverse(32, 0.0f);
    for (const int i : {0, 5, 10, 15, 16, 21, 26, 31}) {
        inverse[static_cast<std::size_t>(i)] = 1.0f;
    }
    inverse[12] = -1.0f;  // joint 0 was bound at x = 1
    builder.document["skins"] = {{{"joints", {1, 2}}, {"inverseBindMatrices", builder.accessor("MAT4", inverse, 2)}}};
    const Scene scene = builder.load();
    const Moment moment = evaluate(scene, {}, 0);
    const Instance& instance = moment.instances.at(0);
    ASSERT_TRUE(instance.skinned());
    EXPECT_EQ(instance.worldFromModel, glm::dmat4(1.0));
    expectNear(instance.worldFromBindPose[0] * glm::dvec4(0, 0, 0, 1), {9, 0, 0});
    expectNear(instance.worldFromBindPose[1] * glm::dvec4(1, 0, 0, 1), {2, 20, 0});
    // Vertices land at (9,0,0), (2,20,0) and half way between (9,1,0) and (0,22,0).
    const auto [low, high] = boundsOf(scene, moment);
    expectNear(low, {2, 0, 0});
    expectNear(high, {9, 20, 0});
}

TEST(Evaluate, BoundsOfRigidInstancesAreTight) {
    GltfBuilder builder;
    builder.triangle();
    builder.document["nodes"] = {{{"mesh", 0}, {"scale", {-2, 3, 1}}, {"translation", {0, 0, 5}}}};
    const Scene scene = builder.load();
    const auto [low, high] = boundsOf(scene, evaluate(scene, {}, 0));
    expectNear(low, {-2, 0, 5});
    expectNear(high, {0, 3, 5});
    const auto [emptyLow, emptyHigh] = boundsOf(Scene{}, Moment{});
    EXPECT_EQ(emptyLow, glm::dvec3(0.0));
    EXPECT_EQ(emptyHigh, glm::dvec3(0.0));
}

class PlacedLights : public testing::Test {
protected:
    PlacedLights() {
        scene.lights.push_back({"lamp", LightType::Spot, glm::vec3(1), 5.0f, 0.0f, 0.1f, 0.2f});
        addNode("/A/B", kNone);
        addNode("/A_B", kNone);
    }
    void addNode(const std::string& path, Index parent) {
        Node node;
        node.path = path;
        node.parent = parent;
        node.light = 0;
        scene.nodes.push_back(node);
    }
    Scene scene;
};

TEST_F(PlacedLights, HaveUniqueIdsFromTheirPaths) {
    const Moment moment = evaluate(scene, {}, 0);
    ASSERT_EQ(moment.lights.size(), 2);
    EXPECT_EQ(moment.lights[0].id, "A_B");
    EXPECT_EQ(moment.lights[1].id, "A_B_1");
}

TEST_F(PlacedLights, ShineAlongTheirNodesMinusZWhateverItsScale) {
    scene.nodes[0].translation = {1, 2, 3};
    scene.nodes[0].rotation = glm::dquat(kHalfRoot, 0, kHalfRoot, 0);  // 90 degrees around y: -z becomes -x
    scene.nodes[0].scale = {5, 6, 7};
    scene.nodes[1].scale = {0, 0, 0};
    const Moment moment = evaluate(scene, {}, 0);
    expectNear(moment.lights[0].position, {1, 2, 3});
    expectNear(moment.lights[0].direction, {-1, 0, 0});
    expectNear(moment.lights[1].direction, {0, 0, -1});
}

TEST_F(PlacedLights, TakeTheValuesOfTheirTracksEachForItself) {
    const auto track = [](std::vector<float> values, int width) {
        return Track{{0, 1}, std::move(values), width, Interpolation::Linear};
    };
    scene.lightTracks = {{0, LightProperty::Intensity, track({0, 10}, 1)},
                         {0, LightProperty::Color, track({0, 0, 0, 1, .5f, .25f}, 3)},
                         {1, LightProperty::Range, track({2, 4}, 1)},
                         {1, LightProperty::InnerConeAngle, track({0, .1f}, 1)},
                         {1, LightProperty::OuterConeAngle, track({.2f, .4f}, 1)}};
    const Moment moment = evaluate(scene, {}, 0.5);
    EXPECT_FLOAT_EQ(moment.lights[0].light.intensity, 5.0f);
    EXPECT_EQ(moment.lights[0].light.color, glm::vec3(.5f, .25f, .125f));
    EXPECT_EQ(moment.lights[0].light.rangeMetres, 0.0f);
    EXPECT_EQ(moment.lights[1].light.intensity, 5.0f);
    EXPECT_FLOAT_EQ(moment.lights[1].light.rangeMetres, 3.0f);
    EXPECT_FLOAT_EQ(moment.lights[1].light.innerConeAngle, .05f);
    EXPECT_FLOAT_EQ(moment.lights[1].light.outerConeAngle, .3f);
}

TEST(PlaceCamera, KeepsTheRigidPartOfItsNode) {
    Scene scene;
    scene.cameras.push_back({});
    Node node;
    node.path = "/Cam";
    node.camera = 0;
    node.translation = {1, 2, 3};
    node.rotation = glm::dquat(kHalfRoot, 0, kHalfRoot, 0);
    node.scale = {2, 3, -4};
    scene.nodes.push_back(node);
    const glm::dmat4 world = placeCamera(scene, evaluate(scene, {}, 0), 0).worldFromCamera;
    expectNear(world[3], {1, 2, 3});
    EXPECT_NEAR(glm::determinant(glm::dmat3(world)), 1.0, 1e-12);
    expectNear(world[2], {-1, 0, 0});  // z was turned to x and mirrored
    expectNear(world[1], {0, 1, 0});
    scene.nodes[0].scale = {0, 0, 0};
    EXPECT_NEAR(glm::determinant(glm::dmat3(placeCamera(scene, evaluate(scene, {}, 0), 0).worldFromCamera)), 1.0,
                1e-12);
}

TEST(Evaluate, DisplacementsBelongToTheirNodesInstance) {
    GltfBuilder builder;
    builder.triangle();
    builder.document["nodes"].push_back({{"mesh", 0}});
    builder.document["scenes"][0]["nodes"] = {0, 1};
    Scene scene = builder.load();
    scene.displacements.push_back({.node = 1});
    const Moment moment = evaluate(scene, {}, 0);
    EXPECT_EQ(moment.instances[0].displacement, kNone);
    EXPECT_EQ(moment.instances[1].displacement, 0);
}

}  // namespace
}  // namespace umbrage
