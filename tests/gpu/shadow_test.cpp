// SPDX-License-Identifier: Apache-2.0
// Shadow masks of every technique against brute force, in the situations that break textbook shadow volumes
// (docs/rules.md, cases). Whole frames, as the program renders them.
#include "techniques.h"

namespace umbrage::test {
namespace {

TEST(Shadow, ClosedSphereOnGroundPointAndDirectional) {
    TestScene test;
    test.add(ground(6.0f));
    test.add(sphere(3)).translation = {0.0, 1.5, 0.0};
    test.addLight(LightType::Point, {2.0, 6.0, 1.5});
    test.addLight(LightType::Directional, {1.0, 2.0, 0.5});
    test.addLight(LightType::Point, {-4.0, 1.2, 2.0});
    expectRight(test);
}

TEST(Shadow, A6LightInsideAClosedMesh) {
    TestScene test;
    test.add(ground(6.0f));
    test.add(sphere(2), true).translation = {0.0, 1.5, 0.0};
    test.addLight(LightType::Point, {0.1, 1.6, 0.05});
    expectRight(test);
}

TEST(Shadow, A8DirectionalLightParallelToFaces) {
    TestScene test;
    test.add(ground(6.0f));
    test.add(box({-1, 0.5f, -1}, {1, 2, 1}));
    test.addLight(LightType::Directional, {0.0, 1.0, 0.0});
    test.addLight(LightType::Directional, {0.0, 0.0, 1.0});
    expectRight(test);
}

TEST(Shadow, B1EyeInsideNestedVolumes) {
    for (const int shells : {1, 2, 7}) {
        SCOPED_TRACE(shells);
        TestScene test;
        test.add(ground(12.0f));
        for (int i = 0; i < shells; ++i) {
            Node& shell = test.add(sphere(2));
            shell.translation = {-0.4, 6.0 + 0.5 * i, 3.0};
            shell.scale = glm::dvec3(0.6 + 0.5 * i);
        }
        test.add(sphere(2)).translation = {2.0, 1.0, 0.0};
        test.eye = {0.0, 1.0, 4.0};
        test.target = {1.0, 0.3, 0.0};
        test.addLight(LightType::Point, {-1.0, 12.0, 2.5});
        expectRight(test);
    }
}

TEST(Shadow, B2EyeInsideAClosedCaster) {
    TestScene test;
    test.add(sphere(3), true).scale = glm::dvec3(3.0);
    test.add(box({-0.5f, -1, -1.5f}, {0.5f, 0.2f, -1}), true);
    test.eye = {0.0, 0.2, 2.0};
    test.target = {0.0, 0.0, -1.0};
    test.addLight(LightType::Point, {0.8, 1.5, 0.5});
    test.addLight(LightType::Point, {4.0, 5.0, 0.5});
    expectRight(test);
}

TEST(Shadow, B4NearPlaneCutsTheCaster) {
    TestScene test;
    test.add(ground(8.0f));
    test.add(sphere(3)).translation = {0.0, 1.5, 3.2};  // reaches through the near plane towards the eye
    test.camera.znear = 1.0;
    test.eye = {0.0, 1.8, 4.6};
    test.target = {0.2, 0.5, 0.0};
    test.addLight(LightType::Point, {0.5, 5.0, 5.0});
    test.addLight(LightType::Directional, {0.3, 0.7, 1.0});
    expectRight(test);
}

TEST(Shadow, T1CardBetweenEyeAndNearPlane) {
    TestScene test;
    test.add(ground(8.0f));
    test.add(quad({-1, 0.5f, 4.3f}, {1, 0.5f, 4.3f}, {1, 2.5f, 4.3f}, {-1, 2.5f, 4.3f}), true);
    test.camera.znear = 1.0;
    test.eye = {0.0, 1.8, 5.0};
    test.target = {0.0, 0.5, 0.0};
    test.addLight(LightType::Point, {0.5, 4.0, 7.0});
    test.addLight(LightType::Directional, {0.1, 0.5, 1.0});
    expectRight(test);
}

TEST(Shadow, T1SingleSidedRoomSeenThroughItsCulledWall) {
    TestScene test;
    Triangles room = box({-3, 0, -3}, {3, 3, 3});
    for (auto& triangle : room) std::swap(triangle[1], triangle[2]);  // faces look inwards
    test.add(room);
    test.add(sphere(2)).translation = {0.0, 1.0, 0.0};
    test.eye = {0.5, 2.0, 9.0};
    test.addLight(LightType::Point, {1.5, 2.5, 1.0});   // inside
    test.addLight(LightType::Point, {0.0, 2.0, 12.0});  // outside: everything seen is in the walls' shadow
    expectRight(test);
}

TEST(Shadow, B11OrthographicCamera) {
    TestScene test;
    test.camera.perspective = false;
    test.camera.xmag = test.camera.ymag = 4.0;
    test.camera.znear = 0.5;
    test.camera.zfar = 30.0;
    test.add(ground(6.0f));
    test.add(sphere(2)).translation = {0.0, 1.5, 0.0};
    test.add(sphere(1), true).translation = {1.5, 3.0, 9.5};  // behind the camera, casting into the view
    test.addLight(LightType::Point, {2.0, 6.0, 1.5});
    test.addLight(LightType::Directional, {0.3, 1.0, 1.2});
    test.addLight(LightType::Point, {2.5, 5.0, 14.0});
    expectRight(test);
}

TEST(Shadow, T5OrthographicEyeAlongADirectionalLight) {
    TestScene test;
    test.camera.perspective = false;
    test.camera.xmag = test.camera.ymag = 4.0;
    test.camera.zfar = 30.0;
    test.eye = {0.0, 0.0, 8.0};
    test.target = {0.0, 0.0, 0.0};
    test.add(quad({-3, -2, -2}, {3, -2, -2}, {3, 2, -2}, {-3, 2, -2}), true);
    test.add(quad({-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}), true);
    test.add(quad({1.5f, -1, 9}, {2.5f, -1, 9}, {2.5f, 1, 9}, {1.5f, 1, 9}), true);  // behind the camera
    Node& light = test.addLight(LightType::Directional, {0.0, 0.0, 1.0});
    light.matrix = glm::dmat4(1.0);  // shines along -Z exactly
    expectRight(test);
}

TEST(Shadow, C1OpenSheetsFromBothSides) {
    TestScene test;
    test.add(ground(6.0f), true);
    test.add(quad({-1, 1, -1}, {1, 1.2f, -1}, {1, 1.5f, 1}, {-1, 1, 1}), true);
    test.add({{glm::vec3(2, 0.5f, 0), glm::vec3(3, 2, 0.4f), glm::vec3(2, 2.5f, 1)}}, true);
    test.addLight(LightType::Point, {0.5, 4.0, 0.5});
    test.addLight(LightType::Point, {0.5, 0.3, 0.5});  // below the sheet
    test.addLight(LightType::Directional, {-1.0, 1.0, 0.2});
    expectRight(test);
}

TEST(Shadow, C2DuplicateAndFlippedFaces) {
    TestScene test;
    test.add(ground(6.0f), true);
    Triangles stack = quad({-1, 1, 1}, {1, 1, 1}, {1, 1, -1}, {-1, 1, -1});
    const Triangles once = stack;
    stack.insert(stack.end(), once.begin(), once.end());
    Triangles flipped = once;
    for (auto& triangle : flipped) std::swap(triangle[1], triangle[2]);
    stack.insert(stack.end(), flipped.begin(), flipped.end());
    test.add(stack, true);
    test.addLight(LightType::Point, {0.5, 4.0, 0.5});
    expectRight(test);
}

TEST(Shadow, C4MoebiusStrip) {
    TestScene test;
    test.add(ground(6.0f), true);
    Triangles strip;
    std::vector<std::array<glm::vec3, 2>> rungs;
    constexpr int kCount = 48;
    for (int i = 0; i < kCount; ++i) {
        const float a = 6.2831853f * float(i) / kCount;
        const glm::vec3 middle(1.5f * std::cos(a), 2.0f, 1.5f * std::sin(a));
        const glm::vec3 across = 0.6f * (std::cos(a / 2) * glm::normalize(middle - glm::vec3(0, 2, 0)) +
                                         std::sin(a / 2) * glm::vec3(0, 1, 0));
        rungs.push_back({middle - across, middle + across});
    }
    for (int i = 0; i < kCount; ++i) {
        std::array<glm::vec3, 2> next = rungs[std::size_t((i + 1) % kCount)];
        if (i == kCount - 1) std::swap(next[0], next[1]);
        strip.push_back({rungs[std::size_t(i)][0], rungs[std::size_t(i)][1], next[1]});
        strip.push_back({rungs[std::size_t(i)][0], next[1], next[0]});
    }
    test.add(strip, true);
    test.addLight(LightType::Point, {0.5, 5.0, 0.5});
    test.addLight(LightType::Directional, {0.3, 1.0, 0.8});
    expectRight(test);
}

TEST(Shadow, B10MirroredAndUnevenlyScaledNodes) {
    TestScene test;
    test.add(ground(6.0f));
    Node& mirrored = test.add(sphere(2));
    mirrored.translation = {-1.5, 1.5, 0.0};
    mirrored.scale = {-1.2, 0.5, 0.8};
    Node& sheet = test.add(quad({0, 0, 1}, {1, 0, 1}, {1, 0, -1}, {0, 0, -1}), true);
    sheet.translation = {1.0, 1.0, 0.0};
    sheet.scale = {2.0, 1.0, -0.7};
    test.addLight(LightType::Point, {0.5, 5.0, 0.5});
    test.addLight(LightType::Directional, {1.0, 1.0, 0.3});
    expectRight(test);
}

/// Random soups, lights and eyes, half of them snapped to a coarse grid so that degeneracies really happen.
TEST(Shadow, RandomSoups) {
    std::uint32_t state = 1;
    const auto random = [&] {
        state = state * 1664525u + 1013904223u;
        return float(state >> 8) / float(1u << 24);
    };
    for (int scene = 0; scene < 40; ++scene) {
        SCOPED_TRACE(scene);
        const bool snapped = scene % 2 == 1;
        const auto coordinate = [&](float low, float high) {
            const float c = low + (high - low) * random();
            return snapped ? std::round(c * 2.0f) / 2.0f : c;
        };
        TestScene test;
        test.add(ground(8.0f), scene % 3 == 0);
        Triangles soup;
        const int count = 1 + int(40.0f * random());
        for (int i = 0; i < count; ++i) {
            const glm::vec3 at(coordinate(-3, 3), coordinate(0.5f, 4), coordinate(-3, 3));
            const auto corner = [&] {
                return at + glm::vec3(coordinate(-1.5f, 1.5f), coordinate(-1, 1), coordinate(-1.5f, 1.5f));
            };
            soup.push_back({corner(), corner(), corner()});
        }
        test.add(soup, scene % 4 < 2);
        test.eye = {coordinate(-2, 2), coordinate(1, 5), coordinate(4, 9)};
        test.camera.perspective = scene % 5 != 4;
        test.camera.xmag = test.camera.ymag = 4.0;
        test.camera.zfar = test.camera.perspective ? 0.0 : 40.0;
        test.addLight(LightType::Point, {coordinate(-4, 4), coordinate(1, 8), coordinate(-4, 4)});
        test.addLight(LightType::Directional, {coordinate(-2, 2), coordinate(0.5f, 3), coordinate(-2, 2)});
        expectRight(test);
    }
}

TEST(Shadow, D1FarFromTheOrigin) {
    TestScene near;
    near.add(ground(6.0f));
    near.add(sphere(3)).translation = {0.0, 1.5, 0.0};
    near.addLight(LightType::Point, {2.0, 6.0, 1.5});
    TestScene far = near;
    const glm::dvec3 shift(1048576.0, 0.0, 1048576.0);
    for (Node& node : far.scene.nodes) node.translation += shift;
    far.eye += shift;
    far.target += shift;
    const FramePixels here = render(near, "z-pass", "compute", true);
    const FramePixels there = render(far, "z-pass", "compute", true);
    EXPECT_EQ(here.lights[0].shadow, there.lights[0].shadow);
}

}  // namespace
}  // namespace umbrage::test
