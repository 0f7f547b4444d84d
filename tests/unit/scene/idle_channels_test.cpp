// SPDX-License-Identifier: Apache-2.0
// What channels that move nothing are, and that nothing placed moves by leaving them out.
#include "scene/idle_channels.h"

#include "compose_fixture.h"

namespace umbrage::test {
namespace {

using IdleChannels = Compose;

/// The room with channels on some of its nodes and on an empty one, "Nothing".
/// @param sampler  0: from (0, 0, 0) to (2, 0, 0); 1: always (0, 0, 0)
Json roomWith(const std::vector<std::tuple<int, const char*, int>>& nodePathSampler) {
    Json json = room();
    json["nodes"].push_back({{"name", "Nothing"}});
    json["nodes"][0]["children"].push_back(6);
    // The same bytes, whose first two points are equal: (0, 0, 0) and, with an offset, (0, 0, 0) again.
    json["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", 44}, {"byteLength", 12}});
    json["accessors"].push_back({{"bufferView", 3}, {"componentType", 5126}, {"count", 1}, {"type", "VEC3"}});
    json["accessors"].push_back(
        {{"bufferView", 1}, {"componentType", 5126}, {"count", 1}, {"type", "SCALAR"}, {"min", {0}}, {"max", {0}}});
    json["animations"][0]["samplers"].push_back({{"input", 4}, {"output", 3}});
    json["animations"][0]["channels"] = Json::array();
    for (const auto& [node, path, sampler] : nodePathSampler) {
        json["animations"][0]["channels"].push_back(
            {{"sampler", sampler}, {"target", {{"node", node}, {"path", path}}}});
    }
    return json;
}

TEST_F(IdleChannels, AreThoseOfOneValueAndThoseUnderWhichNothingIsPlaced) {
    write("room.gltf", roomWith({{1, "translation", 1},     // a lamp, held at (0, 0, 0)
                                 {5, "translation", 0},     // the figure moves
                                 {6, "translation", 0}}));  // nothing moves
    const Composition all = composed(kRoom, "shadow: {skips: {channels: off}}\n"), lean = composed(kRoom);
    EXPECT_EQ(all.idleChannels, 0u);
    EXPECT_EQ(all.scene.animations[0].channels.size(), 3u);
    EXPECT_EQ(lean.idleChannels, 2u);
    ASSERT_EQ(lean.scene.animations[0].channels.size(), 1u);
    EXPECT_EQ(lean.scene.animations[0].channels[0].node, findNode(lean.scene, "/Room/Figure"));
    EXPECT_EQ(lean.scene.animations[0].durationSeconds(), 1.0) << "frames stay those of the whole animation";
    for (const double time : {0.0, 0.3, 0.7, 2.0}) {
        const Moment a = evaluate(all.scene, all.animations, time), b = evaluate(lean.scene, lean.animations, time);
        ASSERT_EQ(a.instances.size(), b.instances.size());
        for (std::size_t i = 0; i < a.instances.size(); ++i) {
            EXPECT_EQ(a.instances[i].worldFromModel, b.instances[i].worldFromModel);
        }
        for (std::size_t l = 0; l < a.lights.size(); ++l) {
            EXPECT_EQ(a.lights[l].position, b.lights[l].position);
            EXPECT_EQ(a.lights[l].direction, b.lights[l].direction);
        }
        EXPECT_EQ(placeCamera(all.scene, a, all.cameraNode).worldFromCamera,
                  placeCamera(lean.scene, b, lean.cameraNode).worldFromCamera);
    }
    expectNear(worldPosition(lean, "/Room/LampA", 0), {0, 0, 0});
}

TEST_F(IdleChannels, OfSeveralOnOneNodeStay) {
    write("room.gltf", roomWith({{5, "translation", 1}}));
    Composition one = composed(kRoom, "shadow: {skips: {channels: off}}\n");
    one.scene.drivers = {one.scene.animations[0]};
    EXPECT_EQ(dropIdleChannels(one.scene, one.animations, one.cameraNode), 0u) << "the last wins, whichever that is";
    EXPECT_EQ(dropIdleChannels(one.scene, {}, one.cameraNode), 1u);
}

TEST_F(IdleChannels, WeightsOfWhatDoesNotMorphMoveNothing) {
    Composition one = composed(kRoom, "shadow: {skips: {channels: off}}\n");
    Animation& walk = one.scene.animations[0];
    walk.tracks.push_back({{0.0f, 1.0f}, {0.0f, 1.0f}, 1, Interpolation::Linear});
    walk.channels.push_back({findNode(one.scene, "/Room/Figure"), Target::Weights, Index(walk.tracks.size() - 1)});
    EXPECT_EQ(dropIdleChannels(one.scene, one.animations, one.cameraNode), 1u);
    EXPECT_EQ(walk.channels.size(), 1u);
}

TEST_F(IdleChannels, JointsAndTheCameraArePlaces) {
    Composition one = composed(kFigure + kRoom, "camera: /Room/Cam\nshadow: {skips: {channels: off}}\n");
    Scene& scene = one.scene;
    const auto indexOf = [&](const char* path) { return findNode(scene, path); };
    scene.skins.push_back({"", {indexOf("/Room/Spot")}, {glm::mat4(1.0f)}});
    scene.nodes[std::size_t(indexOf("/Figure"))].skin = 0;
    scene.nodes[std::size_t(indexOf("/Room/Spot"))].light = kNone;
    Animation& walk = scene.animations[0];
    walk.channels.clear();
    for (const char* path : {"/Room/Cam", "/Room/Spot", "/Figure"}) {
        walk.channels.push_back({indexOf(path), Target::Translation, 0});
    }
    ASSERT_FALSE(isConstant(walk.tracks[0]));
    EXPECT_EQ(dropIdleChannels(scene, one.animations, one.cameraNode), 1u);
    ASSERT_EQ(walk.channels.size(), 2u) << "a skinned mesh stands where its joints are";
    EXPECT_EQ(walk.channels[0].node, indexOf("/Room/Cam"));
    EXPECT_EQ(walk.channels[1].node, indexOf("/Room/Spot"));
}

TEST(ConstantTracks, HaveTheSameBitsAtAllTimes) {
    // A rotation whose parts are no float fractions: interpolated, it would wander by roundings.
    const float q[] = {0.1f, 0.7f, -0.3f, 0.64f};
    for (const Interpolation interpolation : {Interpolation::Step, Interpolation::Linear, Interpolation::CubicSpline}) {
        Track track{{0.0f, 0.37f, 1.0f}, {}, 4, interpolation};
        for (int key = 0; key < 3; ++key) {
            const bool spline = interpolation == Interpolation::CubicSpline;
            if (spline) track.values.insert(track.values.end(), 4, 0.0f);
            track.values.insert(track.values.end(), std::begin(q), std::end(q));
            if (spline) track.values.insert(track.values.end(), 4, 0.0f);
        }
        EXPECT_TRUE(isConstant(track));
        std::array<float, 4> first{}, now{};
        sample(track, 0.0, true, first);
        for (double time = 0.0; time < 1.2; time += 0.013) {
            sample(track, time, true, now);
            EXPECT_EQ(now, first) << time;
        }
        track.values[interpolation == Interpolation::CubicSpline ? 9 : 1] += 0.1f;  // a tangent, or a value
        EXPECT_FALSE(isConstant(track));
    }
}

}  // namespace
}  // namespace umbrage::test
