// SPDX-License-Identifier: Apache-2.0
// Cameras: found, described, and the one a scene without any gets.
#include "compose_fixture.h"

namespace umbrage::test {
namespace {

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

TEST_F(Compose, AnEmptySceneStillHasACameraAndLights) {
    Json empty = figure();
    empty["nodes"] = {{{"name", "nothing"}}};
    write("empty.gltf", empty);
    const Composition seen = composed("- gltf: empty.gltf\n");
    EXPECT_NE(seen.cameraNode, kNone);
    EXPECT_EQ(seen.scene.notes.size(), 2u) << "a camera and lights";
}

}  // namespace
}  // namespace umbrage::test
