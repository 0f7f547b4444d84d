// SPDX-License-Identifier: Apache-2.0
// Motion against formulas: where each point of the surface was in the frame before.
#include <functional>

#include "aovs.h"

namespace umbrage::test {
namespace {

class Motion : public testing::TestWithParam<int> {
protected:
    int samples = GetParam();

    /// Judges every covered pixel of objects for which `placeBefore` is the right answer.
    /// @param placeBefore  from where a point is to where it was
    void expectMotion(const AovFrame& frame, const PlacedMoment& before,
                      const std::function<glm::dvec3(const glm::dvec3&)>& placeBefore, std::uint32_t object,
                      double leastPixels) {
        const Eye eyeBefore = makeEye(before.camera, AovFrame::kWidth, AovFrame::kHeight);
        int judged = 0;
        double farthest = 0.0;
        for (std::size_t i = 0; i < AovFrame::kPixelCount; ++i) {
            if (frame.ids(i).x != object) continue;
            ++judged;
            const glm::dvec3 p = frame.vectorOf("position", i);
            const glm::dvec2 expected = frame.projected(p) - AovFrame::projectedBy(eyeBefore, placeBefore(p));
            const glm::dvec2 is(frame.vectorOf("motion", i));
            farthest = std::max(farthest, glm::length(expected));
            ASSERT_LE(glm::distance(is, expected), 2e-3)
                << i % AovFrame::kWidth << ", " << i / AovFrame::kWidth << ": " << is.x << " " << is.y << " instead of "
                << expected.x << " " << expected.y;
        }
        EXPECT_GT(judged, 300);
        EXPECT_GT(farthest, leastPixels) << "nothing moved far enough to tell";
    }
};
INSTANTIATE_TEST_SUITE_P(Samples, Motion, testing::Values(1, 4), testing::PrintToStringParamName());

const auto stands = [](const glm::dvec3& p) { return p; };

TEST_P(Motion, IsExactlyZeroWhereNothingMoves) {
    const TestScene test = courtScene();
    const PlacedMoment before{AovFrame::momentAt(test.scene, 0.0), test.placedCamera()};
    const AovFrame frame(test, samples, 0.0, &before);
    for (std::size_t i = 0; i < AovFrame::kPixelCount; ++i) {
        ASSERT_EQ(frame.vectorOf("motion", i), glm::dvec3(0.0));
    }
}

TEST_P(Motion, OfACameraThatTurnsAndTravels) {
    for (const bool perspective : {true, false}) {
        TestScene test = courtScene();
        test.camera.perspective = perspective;
        test.camera.ymag = 2.5;
        if (!perspective) test.camera.zfar = 30.0;
        TestScene earlier = test;
        earlier.eye += glm::dvec3(0.3, -0.1, 0.4);
        earlier.target += glm::dvec3(-0.2, 0.1, 0.0);
        earlier.camera.yfov = 0.95;
        earlier.camera.ymag = 2.6;
        const PlacedMoment before{AovFrame::momentAt(test.scene, 0.0), earlier.placedCamera()};
        expectMotion(AovFrame(test, samples, 0.0, &before), before, stands, 1, 5.0);
    }
}

TEST_P(Motion, OfABoxThatMovesAndTurnsBeforeGroundThatStands) {
    TestScene test = courtScene();
    TestScene earlier = test;
    Node& node = earlier.scene.nodes[2];
    node.translation += glm::dvec3(-0.3, 0.1, 0.2);
    node.rotation = glm::angleAxis(0.2, glm::dvec3(0, 1, 0));
    const PlacedMoment before{AovFrame::momentAt(earlier.scene, 0.0), test.placedCamera()};
    const AovFrame frame(test, samples, 0.0, &before);
    const Moment now = AovFrame::momentAt(test.scene, 0.0);
    const glm::dmat4 back = before.moment.instances[2].worldFromModel * glm::inverse(now.instances[2].worldFromModel);
    expectMotion(
        frame, before, [&](const glm::dvec3& p) { return glm::dvec3(back * glm::dvec4(p, 1.0)); }, 3, 5.0);
    for (std::size_t i = 0; i < AovFrame::kPixelCount; ++i) {
        if (frame.ids(i).x == 1) {
            ASSERT_EQ(frame.vectorOf("motion", i), glm::dvec3(0.0));
        }
    }
}

/// A sheet whose right end follows a joint, seen from the front.
TestScene skinnedSheet() {
    TestScene test;
    test.eye = {0.0, 0.0, 5.0};
    Node& sheet = test.add(quad({-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}));
    sheet.skin = 0;
    Mesh& mesh = test.scene.meshes.back();
    for (const glm::vec3& p : mesh.positions) {
        mesh.joints.emplace_back(0, 1, 0, 0);
        mesh.weights.emplace_back(p.x > 0 ? 0.0f : 1.0f, p.x > 0 ? 1.0f : 0.0f, 0.0f, 0.0f);
    }
    for (const char* path : {"/left", "/right"}) {
        Node joint;
        joint.path = path;
        test.scene.nodes.push_back(joint);
    }
    test.scene.skins.push_back({"skin", {1, 2}, {glm::mat4(1.0f), glm::mat4(1.0f)}});
    return test;
}

TEST_P(Motion, OfASkinWhoseOneEndFollowsAJoint) {
    TestScene test = skinnedSheet(), earlier = test;
    earlier.scene.nodes[2].translation.y = -0.4;
    earlier.eye = {0.2, 0.0, 5.0};
    earlier.target = {0.2, 0.0, 0.0};
    const PlacedMoment before{AovFrame::momentAt(earlier.scene, 0.0), earlier.placedCamera()};
    const auto back = [](const glm::dvec3& p) { return p - glm::dvec3(0.0, 0.4 * (p.x + 1.0) / 2.0, 0.0); };
    expectMotion(AovFrame(test, samples, 0.0, &before), before, back, 1, 5.0);
}

TEST_P(Motion, OfASkinFarFromTheWorldsOriginWhileTheEyeCrossesACell) {
    TestScene test = skinnedSheet(), earlier = test;
    const glm::dvec3 away(40'000.0, 0.0, 0.0);
    for (TestScene* scene : {&test, &earlier}) {
        for (std::size_t joint : {1u, 2u}) scene->scene.nodes[joint].translation += away;
        scene->eye += away;
        scene->target += away;
    }
    earlier.eye.z = 120.0;  // the eye comes 115 m nearer in one frame
    const PlacedMoment before{AovFrame::momentAt(earlier.scene, 0.0), earlier.placedCamera()};
    const AovFrame frame(test, samples, 0.0, &before);
    const Eye eyeBefore = makeEye(before.camera, AovFrame::kWidth, AovFrame::kHeight);
    int judged = 0;
    for (std::size_t i = 0; i < AovFrame::kPixelCount; ++i) {
        if (frame.ids(i).x != 1) continue;
        ++judged;
        // World positions are floats: here they are good to 4 mm, 0.1 pixels.
        const glm::dvec3 p = frame.vectorOf("position", i);
        const glm::dvec2 expected = frame.projected(p) - AovFrame::projectedBy(eyeBefore, p);
        ASSERT_LE(glm::distance(glm::dvec2(frame.vectorOf("motion", i)), expected), 0.3);
    }
    EXPECT_GT(judged, 300);
}

TEST_P(Motion, OfAMorph) {
    TestScene test;
    test.eye = {0.0, 0.0, 5.0};
    Node& sheet = test.add(quad({-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}));
    test.scene.meshes[0].morphTargets.resize(1);
    for (const glm::vec3& p : test.scene.meshes[0].positions) {
        test.scene.meshes[0].morphTargets[0].positions.emplace_back(0.0f, p.x > 0 ? 1.0f : 0.0f, 0.0f);
    }
    sheet.morphWeights = {0.7f};
    TestScene earlier = test;
    earlier.scene.nodes[0].morphWeights = {0.2f};
    const PlacedMoment before{AovFrame::momentAt(earlier.scene, 0.0), earlier.placedCamera()};
    const auto back = [](const glm::dvec3& p) { return p - glm::dvec3(0.0, 0.5 * (p.x + 1.0) / 2.0, 0.0); };
    expectMotion(AovFrame(test, samples, 0.0, &before), before, back, 1, 5.0);
}

TEST_P(Motion, IsZeroOfWhatWasBehindTheEye) {
    TestScene test;
    test.add(ground(2.0f));
    TestScene earlier = test;
    earlier.eye = {0.0, 2.0, -8.0};
    earlier.target = {0.0, 2.0, -16.0};
    const PlacedMoment before{AovFrame::momentAt(test.scene, 0.0), earlier.placedCamera()};
    const AovFrame frame(test, samples, 0.0, &before);
    for (std::size_t i = 0; i < AovFrame::kPixelCount; ++i) {
        ASSERT_EQ(frame.vectorOf("motion", i), glm::dvec3(0.0));
    }
}

}  // namespace
}  // namespace umbrage::test
