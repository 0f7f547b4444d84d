// SPDX-License-Identifier: Apache-2.0
// Lights: opinions on them, extra ones, and those a scene without any gets.
#include "compose_fixture.h"

namespace umbrage::test {
namespace {

TEST_F(Compose, OpinionsChangeTheLightsTheirGlobMatches) {
    const Composition lit =
        composed(kRoom + "- over: {\"/Room/Lamp*\": {light: {intensity: 40, color: [1, 0, 0], range: 7}}}\n");
    for (const char* path : {"/Room/LampA", "/Room/LampB"}) {
        EXPECT_EQ(lightAt(lit.scene, path).intensity, 40);
        EXPECT_EQ(lightAt(lit.scene, path).color, glm::vec3(1, 0, 0));
        EXPECT_EQ(lightAt(lit.scene, path).rangeMetres, 7);
    }
    EXPECT_EQ(lightAt(lit.scene, "/Room/Spot").intensity, 1);
    EXPECT_TRUE(lit.scene.lightTracks.empty());
}

TEST_F(Compose, ASharedLightChangesOnOneNodeOnly) {
    const Composition lit = composed(kRoom + "- over: {/Room/LampB: {light: {intensity: 40}}}\n");
    EXPECT_EQ(lightAt(lit.scene, "/Room/LampA").intensity, 5);
    EXPECT_EQ(lightAt(lit.scene, "/Room/LampB").intensity, 40);
}

TEST_F(Compose, TimeSamplesBecomeTracks) {
    const Composition lit = composed(
        kRoom + "- over: {/Room/LampA: {light: {intensity: {0: 0, 2: 60}, color: {1: [1, 0, 0], 3: [0, 0, 1]}}}}\n");
    const LightTrack* intensity = trackOn(lit.scene, "/Room/LampA", LightProperty::Intensity);
    ASSERT_NE(intensity, nullptr);
    EXPECT_THAT(intensity->track.timesSeconds, ElementsAre(0, 2));
    EXPECT_THAT(intensity->track.values, ElementsAre(0, 60));
    EXPECT_EQ(intensity->track.width, 1);
    EXPECT_EQ(intensity->track.interpolation, Interpolation::Linear);
    EXPECT_EQ(trackOn(lit.scene, "/Room/LampA", LightProperty::Color)->track.width, 3);
    const Moment moment = evaluate(lit.scene, lit.animations, 1.0);
    for (const PlacedLight& light : moment.lights)
        EXPECT_FLOAT_EQ(light.light.intensity, light.node == findNode(lit.scene, "/Room/LampA")  ? 30.0f
                                               : light.node == findNode(lit.scene, "/Room/Spot") ? 1.0f
                                                                                                 : 5.0f);
}

TEST_F(Compose, LaterOpinionsWin) {
    const Composition lit =
        composed(kRoom +
                 "- over: {/Room/LampA: {light: {intensity: {0: 0, 2: 60}}}}\n"
                 "- over: {/Room/LampA: {light: {intensity: 3}}}\n"
                 "- over: {/Room/LampB: {light: {intensity: 3}}}\n"
                 "- over: {/Room/LampB: {light: {intensity: {0: 7, 2: 8}, interpolation: step}}}\n");
    EXPECT_EQ(trackOn(lit.scene, "/Room/LampA", LightProperty::Intensity), nullptr);
    EXPECT_EQ(lightAt(lit.scene, "/Room/LampA").intensity, 3);
    ASSERT_EQ(lit.scene.lightTracks.size(), 1u);
    EXPECT_EQ(lit.scene.lightTracks[0].track.interpolation, Interpolation::Step);
}

TEST_F(Compose, OpinionsOnNothingNameTheNearestLight) {
    expectError(kRoom, "- over:\n    /Room/LampC: {light: {intensity: 1}}\n", "s.yaml:5:5",
                "\"/Room/LampC\" matches no node with a light", "did you mean \"/Room/LampA\"?");
    expectError(kRoom, "- over:\n    /Room/Figure: {light: {intensity: 1}}\n", "s.yaml:5:5", "no node with a light",
                "/Room/LampA");
    expectError(kFigure, "- over:\n    /x: {light: {intensity: 1}}\n", "s.yaml:5:5", "no node",
                "the scene has no light");
}

TEST_F(Compose, OpinionsThatNoLightCanFollowAreRefused) {
    expectError(kRoom, "- over:\n    /Room/Lamp*: {light: {outerConeAngle: 30}}\n", "s.yaml:5:43",
                "only for spot lights", "");
    const Composition lit = composed(kRoom + "- over: {/Room/*: {light: {outerConeAngle: 60}}}\n");
    EXPECT_NEAR(lightAt(lit.scene, "/Room/Spot").outerConeAngle, glm::radians(60.0), 1e-6);
}

TEST_F(Compose, TheInnerConeStaysNarrower) {
    expectError(kRoom, "- over:\n    /Room/Spot: {light: {innerConeAngle: 40}}\n", "s.yaml:5:42",
                "the inner cone of /Room/Spot (40 degrees) is not narrower than the outer one (28.65)", "both");
    expectError(kRoom, "- over:\n    /Room/Spot: {light: {outerConeAngle: {0: 30, 1: 10, 2: 3}}}\n", "s.yaml:5:42",
                "not narrower", "");
    expectError(kRoom, "lights: [{type: spot, name: a, innerConeAngle: 50}]\n", "s.yaml:4:48",
                "not narrower than the outer one (45)", "");
    EXPECT_NO_THROW(composed(
        kRoom + "- over: {/Room/Spot: {light: {innerConeAngle: {0: 10, 1: 40}, outerConeAngle: {0: 20, 1: 50}}}}\n"));
}

TEST_F(Compose, ExtraLightsStandAndShine) {
    const Composition lit =
        composed(kRoom,
                 "lights:\n"
                 "- {type: point, name: key, intensity: 120, color: [1, .5, 0], position: [1, 2, 3]}\n"
                 "- {type: spot, name: rim, position: [0, 5, 0], target: [0, 0, 0], outerConeAngle: 20}\n"
                 "- {type: directional, name: sun, target: [1, -1, 0]}\n");
    EXPECT_EQ(lightAt(lit.scene, "/lights/key").intensity, 120);
    EXPECT_EQ(lightAt(lit.scene, "/lights/key").type, LightType::Point);
    EXPECT_EQ(lightAt(lit.scene, "/lights/rim").type, LightType::Spot);
    EXPECT_NEAR(lightAt(lit.scene, "/lights/rim").outerConeAngle, glm::radians(20.0), 1e-6);
    expectNear(worldPosition(lit, "/lights/key", 0), {1, 2, 3});
    expectNear(worldForward(lit, findNode(lit.scene, "/lights/rim"), 0), {0, -1, 0});
    expectNear(worldForward(lit, findNode(lit.scene, "/lights/sun"), 0), glm::normalize(glm::dvec3(1, -1, 0)));
    EXPECT_TRUE(lit.scene.drivers.empty()) << "what does not move needs no animation";
}

TEST_F(Compose, MovingLightsAreDriven) {
    const Composition lit = composed(
        kRoom,
        "animations: []\n"
        "lights:\n"
        "- {type: spot, name: a, position: {0: [0, 0, 0], 2: [4, 0, 0]}, target: {1: [2, 0, -1], 2: [4, -1, 0]}}\n"
        "- {type: point, name: b, position: {0: [0, 0, 0], 2: [4, 0, 0]}, interpolation: step}\n");
    expectNear(worldPosition(lit, "/lights/a", 1), {2, 0, 0});
    expectNear(worldPosition(lit, "/lights/a", 9), {4, 0, 0});
    expectNear(worldPosition(lit, "/lights/b", 1.9), {0, 0, 0});
    const Index a = findNode(lit.scene, "/lights/a");
    expectNear(worldForward(lit, a, 0), glm::normalize(glm::dvec3(2, 0, -1)));
    expectNear(worldForward(lit, a, 1), {0, 0, -1});
    expectNear(worldForward(lit, a, 1.5), glm::normalize(glm::dvec3(0, -1, -1)));
    expectNear(worldForward(lit, a, 2), {0, -1, 0});
}

TEST_F(Compose, ALightThatLooksAtItselfIsRefused) {
    expectError(kRoom, "lights: [{type: spot, name: a, position: [1, 1, 1], target: [1, 1, 1]}]\n", "s.yaml:4:61",
                "same point", "");
    expectError(kRoom,
                "lights: [{type: spot, name: a, position: {0: [1, 1, 1], 2: [3, 1, 1]}, target: {1: [2, 1, 1]}}]\n",
                "s.yaml:4:80", "at 1 seconds position and target are the same point", "");
}

TEST_F(Compose, DefaultLightsComeWithAnAmbientTermUnlessTheJobHasOne) {
    EXPECT_GT(composed(kFigure).ambientSky.g, composed(kFigure).ambientGround.g);
    EXPECT_GT(composed(kFigure).ambientGround.g, 0.0f);
    EXPECT_EQ(composed(kFigure, "image: {ambient: [.5, .25, 1]}\n").ambientSky, glm::vec3(.5f, .25f, 1.0f));
    EXPECT_EQ(composed(kRoom).ambientSky, glm::vec3(0.0f)) << "lights of the file are left alone";
}

TEST_F(Compose, ASceneWithoutLightsIsLitFromTheCamera) {
    const Composition lit = composed(kFigure, "camera: {position: [0, 0, -5]}\n");
    EXPECT_THAT(lit.scene.notes, ElementsAre(HasSubstr("the scene has no lights")));
    EXPECT_EQ(lightAt(lit.scene, "/lights/key").type, LightType::Directional);
    EXPECT_GT(lightAt(lit.scene, "/lights/key").intensity, lightAt(lit.scene, "/lights/fill").intensity);
    const glm::dvec3 key = worldForward(lit, findNode(lit.scene, "/lights/key"), 0);
    EXPECT_GT(key.z, 0.0) << "away from the camera, which looks along +z";
    EXPECT_LT(key.y, 0.0) << "from above";
    EXPECT_LT(key.x, 0.0) << "from the camera's left, which is +x";
    EXPECT_TRUE(composed(kFigure, "camera: {}\nlights: [{type: point, name: a}]\n").scene.notes.empty());
}

}  // namespace
}  // namespace umbrage::test
