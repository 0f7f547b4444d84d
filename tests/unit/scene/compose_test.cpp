// SPDX-License-Identifier: Apache-2.0
#include "scene/compose.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtx/component_wise.hpp>
#include <nlohmann/json.hpp>

#include "error.h"
#include "job/job.h"
#include "scene/moment.h"
#include "scene/node_paths.h"

namespace umbrage {
namespace {

using Json = nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;

// Three positions of a triangle in x, y; the times 0 and 1; the points (0, 0, 0) and (2, 0, 0).
const char* const kBuffer =
    "data:application/octet-stream;base64,"
    "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAAAAAAAAgD8AAAAAAAAAAAAAAAAAAABAAAAAAAAAAAA=";

/// A room with a lamp twice (one shared light), a spot, a camera, a triangle and an animation that moves it.
Json room() {
    return Json::parse(R"({
      "asset": {"version": "2.0"},
      "extensionsUsed": ["KHR_lights_punctual"],
      "extensions": {"KHR_lights_punctual": {"lights": [
        {"type": "point", "name": "bulb", "intensity": 5},
        {"type": "spot", "name": "beam", "spot": {"innerConeAngle": 0.1, "outerConeAngle": 0.5}}]}},
      "scene": 0, "scenes": [{"nodes": [0]}],
      "nodes": [
        {"name": "Room", "children": [1, 2, 3, 4, 5]},
        {"name": "LampA", "translation": [0, 1, 0], "extensions": {"KHR_lights_punctual": {"light": 0}}},
        {"name": "LampB", "extensions": {"KHR_lights_punctual": {"light": 0}}},
        {"name": "Spot", "extensions": {"KHR_lights_punctual": {"light": 1}}},
        {"name": "Cam", "camera": 0, "translation": [0, 0, 5]},
        {"name": "Figure", "mesh": 0}],
      "cameras": [{"name": "wide", "type": "perspective", "perspective": {"yfov": 1.0, "znear": 0.1}}],
      "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "material": 0}]}],
      "materials": [{"name": "paint"}],
      "accessors": [
        {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]},
        {"bufferView": 1, "componentType": 5126, "count": 2, "type": "SCALAR", "min": [0], "max": [1]},
        {"bufferView": 2, "componentType": 5126, "count": 2, "type": "VEC3"}],
      "bufferViews": [{"buffer": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 8},
                      {"buffer": 0, "byteOffset": 44, "byteLength": 24}],
      "buffers": [{"byteLength": 68}],
      "animations": [{"name": "walk", "samplers": [{"input": 1, "output": 2}],
                      "channels": [{"sampler": 0, "target": {"node": 5, "path": "translation"}}]}]})");
}

/// The triangle alone.
Json figure() {
    Json json = room();
    json.erase("extensions");
    json.erase("extensionsUsed");
    json.erase("cameras");
    json.erase("animations");
    json["nodes"] = {{{"name", "Figure"}, {"mesh", 0}}};
    return json;
}

class Compose : public testing::Test {
protected:
    Compose() {
        folder_ = std::filesystem::temp_directory_path() / ("umbrage_compose_" + std::to_string(getpid()));
        std::filesystem::create_directories(folder_);
        write("room.gltf", room());
        write("figure.gltf", figure());
    }
    ~Compose() override { std::filesystem::remove_all(folder_); }

    void write(const std::string& name, Json json) {
        json["buffers"][0]["uri"] = kBuffer;
        std::ofstream(folder_ / name) << json.dump();
    }

    Composition composed(const std::string& layers, const std::string& more = "") const {
        return compose(parseJob("umbrage: 1\nscene:\n" + layers + more, "s.yaml", folder_));
    }

    void expectError(const std::string& layers, const std::string& more, const std::string& where,
                     const std::string& message, const std::string& hint) const {
        SCOPED_TRACE(layers + more);
        try {
            composed(layers, more);
            ADD_FAILURE() << "no error";
        } catch (const Error& error) {
            EXPECT_EQ(error.where(), where) << error.what();
            EXPECT_THAT(error.message(), HasSubstr(message));
            EXPECT_THAT(error.hint(), HasSubstr(hint));
        }
    }

    std::filesystem::path folder_;
};

const std::string kRoom = "- gltf: room.gltf\n";
const std::string kFigure = "- gltf: figure.gltf\n";

std::vector<std::string> pathsOf(const Scene& scene) {
    std::vector<std::string> paths;
    for (const Node& node : scene.nodes) paths.push_back(node.path);
    return paths;
}

const Node& nodeAt(const Scene& scene, const std::string& path) {
    const Index node = findNode(scene, path);
    if (node == kNone) throw std::runtime_error("no node " + path);
    return scene.nodes[static_cast<std::size_t>(node)];
}

const Light& lightAt(const Scene& scene, const std::string& path) {
    return scene.lights.at(static_cast<std::size_t>(nodeAt(scene, path).light));
}

const LightTrack* trackOn(const Scene& scene, const std::string& path, LightProperty property) {
    for (const LightTrack& track : scene.lightTracks)
        if (track.node == findNode(scene, path) && track.property == property) return &track;
    return nullptr;
}

glm::dvec3 worldPosition(const Composition& composition, const std::string& path, double timeSeconds) {
    const Moment moment = evaluate(composition.scene, composition.animations, timeSeconds);
    return glm::dvec3(moment.worldFromNode.at(static_cast<std::size_t>(findNode(composition.scene, path)))[3]);
}

glm::dvec3 worldForward(const Composition& composition, Index node, double timeSeconds) {
    const Moment moment = evaluate(composition.scene, composition.animations, timeSeconds);
    return -glm::dvec3(moment.worldFromNode.at(static_cast<std::size_t>(node))[2]);
}

void expectNear(const glm::dvec3& actual, const glm::dvec3& expected, double tolerance = 1e-6) {
    EXPECT_LT(glm::compMax(glm::abs(actual - expected)), tolerance)
        << actual.x << ", " << actual.y << ", " << actual.z << " is not " << expected.x << ", " << expected.y << ", "
        << expected.z;
}

void expectParentsFirst(const Scene& scene) {
    for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
        EXPECT_LT(scene.nodes[i].parent, static_cast<Index>(i));
        for (const Index child : scene.nodes[i].children)
            EXPECT_EQ(scene.nodes.at(static_cast<std::size_t>(child)).parent, static_cast<Index>(i));
    }
}

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

TEST_F(Compose, CamerasAreFoundByPathNameOrIndex) {
    for (const char* camera : {"/Room/Cam", "Cam", "wide", "0"}) {
        const Composition seen = composed(kRoom, std::string("camera: ") + camera + "\n");
        EXPECT_EQ(seen.cameraNode, findNode(seen.scene, "/Room/Cam")) << camera;
    }
}

TEST_F(Compose, UnknownCamerasNameTheNearest) {
    expectError(kRoom, "camera: /Room/Can\n", "s.yaml:4:9", "there is no camera \"/Room/Can\"",
                "did you mean \"/Room/Cam\"?");
    expectError(kRoom, "camera: 1\n", "s.yaml:4:9", "there is no camera \"1\"", "/Room/Cam");
    expectError(kRoom, "camera: /Room/LampA\n", "s.yaml:4:9", "the node /Room/LampA has no camera", "/Room/Cam");
    expectError(kFigure, "camera: x\n", "s.yaml:4:9", "no camera", "describe one");
    expectError(kRoom + kRoom, "camera: wide\n", "s.yaml:5:9", "2 cameras are called \"wide\"",
                "/Room/Cam, /Room_1/Cam");
}

TEST_F(Compose, ADescribedCameraIsANodeOfItsOwn) {
    const Composition seen =
        composed(kRoom, "camera: {position: {0: [0, 0, 4], 1: [4, 0, 0]}, yfov: 60, znear: .5, zfar: 90}\n");
    EXPECT_EQ(seen.cameraNode, findNode(seen.scene, "/camera"));
    const PlacedCamera start = placeCamera(seen.scene, evaluate(seen.scene, seen.animations, 0), seen.cameraNode);
    EXPECT_NEAR(start.camera.yfov, glm::radians(60.0), 1e-12);
    EXPECT_EQ(start.camera.znear, .5);
    EXPECT_EQ(start.camera.zfar, 90);
    expectNear(glm::dvec3(start.worldFromCamera[3]), {0, 0, 4});
    expectNear(worldForward(seen, seen.cameraNode, 1), {-1, 0, 0});
    const Composition flat = composed(kRoom, "camera: {type: orthographic, ymag: 3, zfar: 9}\n");
    const Camera& camera = flat.scene.cameras.back();
    EXPECT_FALSE(camera.perspective);
    EXPECT_EQ(camera.ymag, 3);
}

TEST_F(Compose, ASceneWithoutCameraIsFramedWhole) {
    for (const char* size : {"[64, 64]", "[200, 50]", "[50, 200]"}) {
        SCOPED_TRACE(size);
        const Composition seen = composed("- {gltf: figure.gltf, translate: [100, 20, -7], scale: 5}\n",
                                          std::string("image: {size: ") + size + "}\n");
        EXPECT_THAT(seen.scene.notes, testing::Contains(HasSubstr("the scene has no camera")));
        const Moment moment = evaluate(seen.scene, seen.animations, 0);
        const PlacedCamera placed = placeCamera(seen.scene, moment, seen.cameraNode);
        const int width = std::stoi(size + 1),
                  height = std::stoi(std::string(size).substr(std::string(size).find(',') + 1));
        const double aspect = static_cast<double>(width) / height;
        const glm::dmat4 clipFromWorld = glm::infinitePerspective(placed.camera.yfov, aspect, placed.camera.znear) *
                                         glm::inverse(placed.worldFromCamera);
        glm::dvec2 low(1.0), high(-1.0);
        for (const glm::dvec3 corner : {glm::dvec3(0, 0, 0), glm::dvec3(5, 0, 0), glm::dvec3(0, 5, 0)}) {
            const glm::dvec4 clip = clipFromWorld * glm::dvec4(corner + glm::dvec3(100, 20, -7), 1.0);
            low = glm::min(low, glm::dvec2(clip) / clip.w);
            high = glm::max(high, glm::dvec2(clip) / clip.w);
            EXPECT_GT(clip.w, placed.camera.znear);
        }
        EXPECT_NEAR(std::max(high.x, high.y), 0.9, 1e-6) << "as large as it gets, less a margin";
        for (int axis = 0; axis < 2; ++axis) EXPECT_NEAR(low[axis], -high[axis], 1e-6) << "not in the middle";
        EXPECT_EQ(placed.camera.zfar, 0.0);
    }
}

TEST_F(Compose, TheFramingCameraIsTheSameForEveryFrameAndSeesTheWholeAnimation) {
    Json walking = room();
    walking["nodes"][0]["children"] = {5};
    write("walking.gltf", walking);
    std::vector<glm::dmat4> cameras;
    for (const char* frames : {"1", "24", "1-48"}) {
        const Composition seen = composed("- gltf: walking.gltf\n",
                                          std::string("image: {size: [64, 64]}\ntime: {frames: ") + frames + "}\n");
        for (const double seconds : {0.0, 1.0}) {
            const Moment moment = evaluate(seen.scene, seen.animations, seconds);
            const PlacedCamera placed = placeCamera(seen.scene, moment, seen.cameraNode);
            cameras.push_back(placed.worldFromCamera);
            for (const glm::dvec3& position : positionsOf(seen.scene, moment)) {
                const glm::dvec4 clip = glm::infinitePerspective(placed.camera.yfov, 1.0, placed.camera.znear) *
                                        glm::inverse(placed.worldFromCamera) * glm::dvec4(position, 1.0);
                EXPECT_LT(std::max(std::abs(clip.x), std::abs(clip.y)), clip.w) << frames << " at " << seconds;
            }
        }
    }
    for (const glm::dmat4& camera : cameras) EXPECT_EQ(camera, cameras.front());
}

TEST_F(Compose, ACameraThatLooksAwayIsSaidToSeeNothing) {
    const std::string nothing = "the camera /camera sees nothing";
    for (const char* away : {"{position: [0, 0, 5], target: [0, 0, 9]}", "{position: [0, 0, 5], target: [9, 0, 5]}",
                             "{position: [0, 0, 5], zfar: 4}", "{position: [0, 0, 5], znear: 6}",
                             "{position: [7, 0, 5], target: [7, 0, 0], type: orthographic, ymag: 3, zfar: 9}"}) {
        EXPECT_THAT(composed(kFigure, std::string("camera: ") + away + "\n").scene.notes,
                    testing::Contains(HasSubstr(nothing)))
            << away;
    }
    EXPECT_THAT(composed(kFigure, "camera: {position: [0, 0, 5]}\n").scene.notes,
                testing::Not(testing::Contains(HasSubstr(nothing))));
    EXPECT_THAT(
        composed(kFigure, "camera: {position: {0: [0, 0, 5], 1: [0, 0, 5]}, target: {0: [0, 0, 9.5], 1: [1, 0, 0]}}\n")
            .scene.notes,
        testing::Not(testing::Contains(HasSubstr(nothing))))
        << "it turns round";
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

TEST_F(Compose, AnEmptySceneStillHasACameraAndLights) {
    Json empty = figure();
    empty["nodes"] = {{{"name", "nothing"}}};
    write("empty.gltf", empty);
    const Composition seen = composed("- gltf: empty.gltf\n");
    EXPECT_NE(seen.cameraNode, kNone);
    EXPECT_EQ(seen.scene.notes.size(), 2u) << "a camera and lights";
}

TEST_F(Compose, DisplacementsAreLaidOnMeshes) {
    const Composition moved =
        composed(kRoom + kFigure,
                 "displace: {\"/**/Figure\": {amplitude: .5}, /Figure: {amplitude: 1, frequency: 2, speed: 3},"
                 " /Room/Figure: {amplitude: .7}}\n");
    ASSERT_EQ(moved.scene.displacements.size(), 2u);
    EXPECT_EQ(moved.scene.displacements[0].node, findNode(moved.scene, "/Figure"));
    EXPECT_EQ(moved.scene.displacements[0].frequency, 2);
    EXPECT_EQ(moved.scene.displacements[1].amplitude, .7f) << "the later one wins";
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
}  // namespace umbrage
