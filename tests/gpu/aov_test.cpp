// SPDX-License-Identifier: Apache-2.0
// AOVs of surfaces and of light, against the scene itself.
#include "aovs.h"

namespace umbrage::test {
namespace {

/// With one sample a pixel and with four.
class Aovs : public testing::TestWithParam<int> {
protected:
    int samples = GetParam();
};
INSTANTIATE_TEST_SUITE_P(Samples, Aovs, testing::Values(1, 4), testing::PrintToStringParamName());

TEST_P(Aovs, AskingForAllOfThemChangesNoBitOfThePicture) {
    TestScene test = courtScene();
    test.scene.meshes[1].morphTargets.resize(1);
    test.scene.meshes[1].morphTargets[0].positions.assign(test.scene.meshes[1].positions.size(), {0.0f, 0.1f, 0.0f});
    test.scene.meshes[1].defaultMorphWeights = {0.5f};
    test.eye.x = 1000.0;  // of what deforms, origins are near the eye
    test.target.x = 999.0;
    for (Node& node : test.scene.nodes) node.translation.x += 999.0;
    PlacedMoment before{AovFrame::momentAt(test.scene, 0.0), test.placedCamera()};
    before.camera.worldFromCamera[3].x -= 200.0;
    const AovFrame all(test, samples, 0.0, &before), none(test, samples, 0.0, nullptr, {});
    EXPECT_EQ(all.pixels.radiance, none.pixels.radiance);
    EXPECT_TRUE(none.pixels.aovs.empty() && none.pixels.lights[0].aovs.empty() && none.pixels.scene.fragments.empty());
}

TEST_P(Aovs, PositionIsWhereItsPixelAndDepthSay) {
    for (const bool perspective : {true, false}) {
        TestScene test = courtScene();
        test.camera.perspective = perspective;
        test.camera.ymag = 2.5;
        if (!perspective) test.camera.zfar = 30.0;
        const AovFrame frame(test, samples);
        int judged = 0;
        for (std::size_t i = 0; i < AovFrame::kPixelCount; ++i) {
            const glm::dvec3 p = frame.vectorOf("position", i);
            if (!frame.covered(i)) {
                ASSERT_EQ(p, glm::dvec3(0.0));
                continue;
            }
            ++judged;
            ASSERT_LT(glm::distance(frame.projected(p), frame.placeOf(i)), 1e-3) << i;
            ASSERT_NEAR(-(frame.eye().viewFromWorld * glm::dvec4(p, 1.0)).z, frame.depth(i), 1e-5 * frame.depth(i));
        }
        EXPECT_GT(judged, 5000);
    }
}

TEST_P(Aovs, GeometricNormalIsThatOfThePlaneThroughNeighbouringPositions) {
    const AovFrame frame(courtScene(), samples);
    int judged = 0;
    for (int y = 0; y + 1 < AovFrame::kHeight; ++y) {
        for (int x = 0; x + 1 < AovFrame::kWidth; ++x) {
            const std::size_t i = std::size_t(y) * AovFrame::kWidth + std::size_t(x), right = i + 1,
                              below = i + AovFrame::kWidth;
            if (!frame.covered(i) || frame.ids(i) != frame.ids(right) || frame.ids(i) != frame.ids(below)) continue;
            const glm::dvec3 p = frame.vectorOf("position", i);
            const glm::dvec3 across = frame.vectorOf("position", right) - p,
                             down = frame.vectorOf("position", below) - p;
            const glm::dvec3 n = frame.vectorOf("geometricNormal", i);
            ASSERT_NEAR(glm::length(n), 1.0, 1e-5);
            ASSERT_GT(glm::dot(n, frame.eye().position() - p), 0.0) << "turned away from the viewer";
            ASSERT_GT(glm::dot(n, glm::normalize(glm::cross(down, across))), 0.999) << x << ", " << y;
            ++judged;
        }
    }
    EXPECT_GT(judged, 5000);
}

TEST_P(Aovs, GeometricNormalOfABackFaceIsTurnedRound) {
    TestScene test;
    test.eye = {0.0, -3.0, 0.1};
    test.add(ground(2.0f), true);
    const AovFrame frame(test, samples);
    const std::size_t middle = AovFrame::kPixelCount / 2 + AovFrame::kWidth / 2;
    EXPECT_LT(glm::distance(frame.vectorOf("geometricNormal", middle), glm::dvec3(0, -1, 0)), 1e-6);
}

TEST_P(Aovs, LightsAmbientAndEmissiveAddUpToThePicture) {
    TestScene test = courtScene();
    Material unlit;
    unlit.unlit = true;
    unlit.baseColor = {0.3f, 0.6f, 0.9f, 1.0f};
    test.add(transformed(sphere(1), glm::mat4(0.4f))).translation = {0.2, 0.7, 2.0};
    test.scene.meshes.back().primitives[0].material = Index(test.scene.materials.size());
    test.scene.materials.push_back(unlit);
    for (int i = 0; i < 33; ++i) test.addLight(LightType::Point, {0.2 * i - 3.0, 3.0, 2.0 - 0.1 * i});  // two groups
    const AovFrame frame(test, samples);
    double brightest[3] = {};
    for (std::size_t i = 0; i < AovFrame::kPixelCount; ++i) {
        glm::dvec3 light(0.0);
        for (int l = 0; l < int(frame.pixels.lights.size()); ++l) light += frame.vectorOf("light", i, l);
        const glm::dvec3 ambient = frame.vectorOf("ambient", i), emissive = frame.vectorOf("emissive", i);
        const float* p = &frame.pixels.radiance[4 * i];
        const glm::dvec3 radiance(p[0], p[1], p[2]);
        ASSERT_LE(glm::distance(light + ambient + emissive, radiance), 1e-5 * glm::length(radiance)) << i;
        brightest[0] = std::max(brightest[0], light.g);
        brightest[1] = std::max(brightest[1], ambient.g);
        brightest[2] = std::max(brightest[2], frame.covered(i) ? emissive.b : 0.0);
        ASSERT_EQ(frame.vectorOf("light", i, 2), glm::dvec3(0.0)) << "of the light that is off";
    }
    EXPECT_GT(brightest[0], 0.01);
    EXPECT_GT(brightest[1], 0.01);
    EXPECT_GT(brightest[2], 0.8) << "the unlit sphere";
}

TEST_P(Aovs, AlbedoAndSurfaceAreTheMaterials) {
    TestScene test = courtScene();
    test.scene.materials[0].baseColor = {0.2f, 0.4f, 0.6f, 1.0f};
    test.scene.materials[0].metallic = 0.2f;
    test.scene.materials[0].roughness = 0.6f;
    test.scene.materials[1].unlit = true;
    test.scene.materials[1].baseColor = {0.5f, 0.25f, 0.125f, 1.0f};
    const AovFrame frame(test, samples);
    const glm::dvec3 albedos[] = {{0, 0, 0}, {0.2, 0.4, 0.6}, {0.5, 0.25, 0.125}};
    const glm::dvec3 surfaces[] = {{0, 0, 0}, {0.6, 0.2, 0.0}, {0, 0, 0}};
    bool seen[3] = {};
    for (std::size_t i = 0; i < AovFrame::kPixelCount; ++i) {
        const std::uint32_t material = frame.ids(i).y;
        ASSERT_LT(material, 3u);
        seen[material] = true;
        ASSERT_LT(glm::distance(frame.vectorOf("albedo", i), albedos[material]), 1e-4);
        ASSERT_LT(glm::distance(frame.vectorOf("surface", i), surfaces[material]), 0.5 / 255);
    }
    EXPECT_TRUE(seen[0] && seen[1] && seen[2]);
}

TEST_P(Aovs, IdsNameTheTriangleOfTheSceneThatIsSeen) {
    const TestScene test = courtScene();
    const Moment moment = AovFrame::momentAt(test.scene, 0.0);
    const AovFrame frame(test, samples);
    const BruteForce bruteForce(test, moment, moment.lights[0], AovFrame::kWidth, AovFrame::kHeight);
    std::vector<glm::uvec3> idsOf;
    for (std::size_t i = 0; i < moment.instances.size(); ++i) {
        const Mesh& mesh = test.scene.meshes[std::size_t(moment.instances[i].mesh)];
        for (std::uint32_t t = 0; t < mesh.triangleCount(); ++t) {
            idsOf.emplace_back(i + 1, mesh.primitives[0].material + 1, t + 1);
        }
    }
    int judged = 0;
    for (std::size_t i = 0; i < AovFrame::kPixelCount; ++i) {
        const glm::dvec2 at = frame.placeOf(i);
        const int triangle = bruteForce.at(at.x, at.y).triangle;
        bool sure = true;  // wherever in the pixel the sample is
        for (const glm::dvec2& d : {glm::dvec2(0.5, 0.5), {-0.5, 0.5}, {0.5, -0.5}, {-0.5, -0.5}}) {
            sure = sure && bruteForce.at(at.x + d.x, at.y + d.y).triangle == triangle;
        }
        if (!sure) continue;
        ++judged;
        ASSERT_EQ(frame.ids(i), triangle < 0 ? glm::uvec3(0) : idsOf[std::size_t(triangle)]) << at.x << ", " << at.y;
    }
    EXPECT_GT(judged, 8000);
}

TEST_P(Aovs, LinesHaveIdsAndMotionToo) {
    TestScene test;
    test.add(ground(1.0f));
    Mesh& mesh = test.scene.meshes.back();
    mesh.positions = {{-3, 0.1f, 0}, {3, 0.1f, 0}, {-3, 0, 1}, {3, 0, 1}};
    mesh.indices = {0, 1, 2, 3};
    mesh.primitives[0].topology = Topology::Lines;
    mesh.primitives[0].indexCount = mesh.primitives[0].vertexCount = 4;
    PlacedMoment before{AovFrame::momentAt(test.scene, 0.0), test.placedCamera()};
    before.moment.instances[0].worldFromModel[3].x = 0.5;
    const AovFrame frame(test, samples, 0.0, &before);
    int pixels[3] = {};
    for (std::size_t i = 0; i < AovFrame::kPixelCount; ++i) {
        const glm::uvec3 ids = frame.ids(i);
        ASSERT_LE(ids.z, 2u);
        ++pixels[ids.z];
        if (ids.z == 0) continue;
        EXPECT_EQ(ids, glm::uvec3(1, 1, ids.z));
        EXPECT_LT(frame.vectorOf("motion", i).x, -5.0);
    }
    EXPECT_GT(pixels[1], 50);
    EXPECT_GT(pixels[2], 50);
}

TEST_P(Aovs, ASceneWithoutAnythingHasAllOfThem) {
    TestScene test;
    const AovFrame frame(test, samples);
    for (const char* name : {"position", "geometricNormal", "albedo", "surface", "ambient", "motion"}) {
        EXPECT_EQ(frame.vectorOf(name, 0), glm::dvec3(0.0)) << name;
    }
    EXPECT_LT(glm::distance(frame.vectorOf("emissive", 0), glm::dvec3(0.2, 0.4, 0.1)), 1e-6);
    EXPECT_EQ(frame.ids(0), glm::uvec3(0));
    EXPECT_EQ(frame.pixels.scene.coveredPixels, 0u);
}

}  // namespace
}  // namespace umbrage::test
