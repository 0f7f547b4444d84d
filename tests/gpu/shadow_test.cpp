// SPDX-License-Identifier: Apache-2.0
// Shadow masks of every technique against brute force, in the situations that break textbook shadow volumes
// (algorithms.md C1). Whole frames, as the program renders them.
#include <gtest/gtest.h>

#include "gpu/context.h"
#include "scenes.h"

namespace umbrage::test {
namespace {

constexpr int kWidth = 160, kHeight = 120;

const gpu::Context& context() {
    static const gpu::Context instance;
    return instance;
}

FramePixels render(const TestScene& test, CountTechnique count, const std::string& silhouette, bool halve,
                   bool counts = false) {
    FrameSettings settings;
    settings.width = kWidth;
    settings.height = kHeight;
    settings.count = count;
    settings.silhouette = silhouette;
    settings.halveEvenComponents = halve;
    const Moment moment = evaluate(test.scene, {}, 0.0);
    FrameRenderer renderer(test.scene, moment, settings, context());
    FrameOutputs outputs;
    outputs.shadows = outputs.geometry = true;
    outputs.counts = counts;
    Statistics statistics;
    return renderer.render(moment, test.placedCamera(), outputs, 1, statistics);
}

/// The mask agrees with brute force but for pixels on boundaries, and is the same for every technique and skip.
void expectRight(const TestScene& test) {
    const Moment moment = evaluate(test.scene, {}, 0.0);
    FramePixels reference;
    for (const CountTechnique count : {CountTechnique::ZPass, CountTechnique::ZFail}) {
        for (const char* silhouette : {"compute", "cpu"}) {
            for (const bool halve : {true, false}) {
                SCOPED_TRACE(std::string(count == CountTechnique::ZPass ? "z-pass " : "z-fail ") + silhouette +
                             (halve ? " halved" : " whole"));
                FramePixels pixels = render(test, count, silhouette, halve);
                if (reference.lights.empty()) {
                    reference = std::move(pixels);
                    continue;
                }
                for (std::size_t l = 0; l < moment.lights.size(); ++l) {
                    EXPECT_EQ(pixels.lights[l].shadow, reference.lights[l].shadow) << moment.lights[l].id;
                }
            }
        }
    }
    for (std::size_t l = 0; l < moment.lights.size(); ++l) {
        SCOPED_TRACE(moment.lights[l].id);
        const BruteForce bruteForce(test, moment, moment.lights[l], kWidth, kHeight);
        const BruteForce::Mismatches mismatches =
            bruteForce.compare(reference.lights[l].shadow, reference.normalAndDepth);
        EXPECT_EQ(mismatches.wrong, 0);
        EXPECT_LE(mismatches.boundary, 0.002 * kWidth * kHeight);
        EXPECT_GT(mismatches.judged, kWidth);
    }
}

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

TEST(Shadow, MoreLightsThanOneGroupHolds) {
    TestScene test;
    test.add(ground(6.0f));
    test.add(sphere(2)).translation = {0.0, 1.5, 0.0};
    for (int i = 0; i < 70; ++i) {
        const double angle = 0.09 * i;
        test.addLight(i % 7 == 3 ? LightType::Directional : LightType::Point,
                      {4.0 * std::cos(angle), 3.0 + 0.03 * i, 4.0 * std::sin(angle)});
    }
    const Moment moment = evaluate(test.scene, {}, 0.0);
    const FramePixels pixels = render(test, CountTechnique::ZPass, "compute", true);
    const FramePixels host = render(test, CountTechnique::ZFail, "cpu", true);
    ASSERT_EQ(pixels.lights.size(), 70u);
    for (const std::size_t l : {0u, 31u, 32u, 45u, 63u, 64u, 69u}) {
        SCOPED_TRACE(l);
        EXPECT_EQ(pixels.lights[l].shadow, host.lights[l].shadow);
        const BruteForce bruteForce(test, moment, moment.lights[l], kWidth, kHeight);
        const BruteForce::Mismatches mismatches = bruteForce.compare(pixels.lights[l].shadow, pixels.normalAndDepth);
        EXPECT_EQ(mismatches.wrong, 0);
        EXPECT_GT(mismatches.judged, kWidth);
    }
}

TEST(Frame, NothingToSeeIsBackground) {
    for (const bool withLight : {false, true}) {
        TestScene test;
        if (withLight) test.addLight(LightType::Point, {0.0, 1.0, 0.0});
        FrameSettings settings;
        settings.width = 8;
        settings.height = 4;
        settings.background = {0.25f, 0.5f, 0.75f};
        const Moment moment = evaluate(test.scene, {}, 0.0);
        FrameOutputs outputs;
        outputs.shadows = outputs.counts = outputs.overdraw = outputs.geometry = outputs.figures = true;
        Statistics statistics;
        const FramePixels pixels = FrameRenderer(test.scene, moment, settings, context())
                                       .render(moment, test.placedCamera(), outputs, 1, statistics);
        for (std::size_t i = 0; i < 32; ++i) {
            EXPECT_EQ(pixels.radiance[4 * i], 0.25f);
            EXPECT_EQ(pixels.radiance[4 * i + 2], 0.75f);
            EXPECT_TRUE(std::isinf(pixels.normalAndDepth[4 * i + 3]));
        }
    }
}

TEST(Frame, WithoutLightsThereIsStillGeometry) {
    TestScene test;
    test.add(ground(6.0f));
    const FramePixels pixels = render(test, CountTechnique::ZPass, "compute", true);
    const float* centre = &pixels.normalAndDepth[4 * (std::size_t(kHeight) / 2 * kWidth + kWidth / 2)];
    EXPECT_NEAR(centre[1], 1.0f, 1e-3f);
    EXPECT_NEAR(centre[3], std::sqrt(68.0f), 0.3f);  // from (0, 2, 8) to the origin, half a pixel aside
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
    const FramePixels here = render(near, CountTechnique::ZPass, "compute", true);
    const FramePixels there = render(far, CountTechnique::ZPass, "compute", true);
    EXPECT_EQ(here.lights[0].shadow, there.lights[0].shadow);
}

TEST(Shadow, E1StacksOfPlatesBeyondEightBits) {
    for (const int plates : {255, 256, 257, 512}) {
        SCOPED_TRACE(plates);
        TestScene test;
        test.add(ground(6.0f), true);
        Triangles stack;
        for (int i = 0; i < plates; ++i) {
            const float y = 1.0f + 0.004f * float(i);
            const Triangles plate = quad({-1, y, 1}, {1, y, 1}, {1, y, -1}, {-1, y, -1});
            stack.insert(stack.end(), plate.begin(), plate.end());
        }
        test.add(stack, true);
        test.addLight(LightType::Point, {0.1, 6.0, 0.1});
        expectRight(test);
        const FramePixels counted = render(test, CountTechnique::ZPass, "compute", true, true);
        const std::vector<std::uint32_t>& counts = counted.lights[0].counts;
        EXPECT_EQ(*std::max_element(counts.begin(), counts.end()), std::uint32_t(plates > 255 ? plates : plates % 256));
    }
}

TEST(Shadow, WideCountsOfOneSampleAreNotAveraged) {
    TestScene test;
    test.add(ground(6.0f), true);
    Triangles stack;
    for (int i = 0; i < 300; ++i) {
        const float y = 1.0f + 0.004f * float(i);
        const Triangles plate = quad({-1, y, 1}, {1, y, 1}, {1, y, -1}, {-1, y, -1});
        stack.insert(stack.end(), plate.begin(), plate.end());
    }
    test.add(stack, true);
    test.addLight(LightType::Point, {0.1, 6.0, 0.1});
    FrameSettings settings;
    settings.width = kWidth;
    settings.height = kHeight;
    settings.samples = context().maxSamples();
    const Moment moment = evaluate(test.scene, {}, 0.0);
    FrameOutputs outputs;
    outputs.counts = outputs.shadows = true;
    Statistics statistics;
    const FramePixels pixels = FrameRenderer(test.scene, moment, settings, context())
                                   .render(moment, test.placedCamera(), outputs, 1, statistics);
    const auto& [id, shadow, counts] = pixels.lights[0];
    EXPECT_EQ(*std::max_element(counts.begin(), counts.end()), 300u);
    bool partly = false;  // masks are shares of samples, counts are whole
    for (std::size_t i = 0; i < shadow.size(); ++i) {
        partly = partly || (shadow[i] > 0.0f && shadow[i] < 1.0f);
        if (shadow[i] == 1.0f) {
            EXPECT_EQ(counts[i], 0u) << i;
        }
    }
    EXPECT_TRUE(partly);
}

TEST(Shadow, E2EyeUnderAStackOfPlates) {
    TestScene test;
    test.add(ground(6.0f), true);
    Triangles stack;
    for (int i = 0; i < 256; ++i) {
        const float y = 4.0f + 0.004f * float(i);
        const Triangles plate = quad({-2, y, 8}, {2, y, 8}, {2, y, 2}, {-2, y, 2});
        stack.insert(stack.end(), plate.begin(), plate.end());
    }
    test.add(stack, true);
    test.eye = {0.0, 1.5, 5.0};
    test.addLight(LightType::Point, {0.1, 9.0, 5.3});
    expectRight(test);
}

TEST(Shadow, M1CountsOfPassAndFailAgreeEverywhere) {
    TestScene test;
    test.add(ground(8.0f));
    for (int i = 0; i < 4; ++i) test.add(sphere(2)).translation = {0.3 * i, 1.2 + 1.4 * i, 0.2 * i};
    test.add(quad({-2, 3, -1}, {2, 3, -1}, {2, 3.3f, 1}, {-2, 3.3f, 1}), true);
    test.addLight(LightType::Point, {2.0, 7.0, 1.5});
    test.addLight(LightType::Directional, {-1.0, 2.0, 0.5});
    const FramePixels pass = render(test, CountTechnique::ZPass, "compute", true, true);
    const FramePixels fail = render(test, CountTechnique::ZFail, "cpu", true, true);
    for (std::size_t l = 0; l < 2; ++l) {
        int differences = 0, deepest = 0;
        for (std::size_t i = 0; i < pass.lights[l].counts.size(); ++i) {
            if (pass.radiance[4 * i] == 0.0f && pass.radiance[4 * i + 1] == 0.0f) continue;  // background
            differences += pass.lights[l].counts[i] != fail.lights[l].counts[i];
            deepest = std::max(deepest, int(pass.lights[l].counts[i]));
        }
        EXPECT_EQ(differences, 0);
        EXPECT_GE(deepest, 3);
        EXPECT_LT(deepest, 20);
    }
}

}  // namespace
}  // namespace umbrage::test
