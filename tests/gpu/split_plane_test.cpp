// SPDX-License-Identifier: Apache-2.0
// Counting by parts: planes made on the device, and parts that cut through meshes.
#include "shadow/caster_parts.h"
#include "shadow/split_parts.h"
#include "subjects.h"

namespace umbrage::test {
namespace {

TEST(SplitPlane, TheDeviceMakesTheHostsPlanes) {
    context();
    for (const bool perspective : {true, false}) {
        for (const LightType type : {LightType::Point, LightType::Directional}) {
            PlacedCamera placed;
            placed.worldFromCamera =
                glm::inverse(glm::lookAt(glm::dvec3(4.0, 3.0, 6.0), glm::dvec3(0.0), glm::dvec3(0.0, 1.0, 0.0)));
            placed.camera = {
                .name = {}, .perspective = perspective, .yfov = 0.9, .ymag = 3.0, .znear = 0.1, .zfar = 50};
            const Eye eye = makeEye(placed, 400, 300);
            const Homogeneous light = type == LightType::Point ? Homogeneous(1.0, 5.0, -2.0, 1.0)
                                                               : Homogeneous(glm::normalize(glm::dvec3(1, 3, 2)), 0.0);
            using Kind = SplitPoints::Kind;
            LightParts parts;
            for (const Kind kind : {Kind::PointCameraLight, Kind::PointPointLight, Kind::Nowhere}) {
                parts.ofCluster.push_back(std::uint32_t(parts.parts.size()));
                parts.parts.push_back({{{0.5, 0.2, 0.1}, {-1.0, 1.0, 0.4}}, kind});
            }
            gpu::Buffer view("view", sizeof(gpu::ViewData)), lights("lights", sizeof(gpu::LightData));
            const gpu::ViewData viewData = viewDataOf(eye);
            view.write(0, sizeof viewData, &viewData);
            view.bindUniform(BIND_VIEW);
            gpu::LightData lightData{};
            lightData.position = gpu::vec4(eye.viewFromWorld * light);
            lights.write(0, sizeof lightData, &lightData);
            lights.bindStorage(BIND_LIGHTS);

            SplitParts onDevice;
            onDevice.setClusters({0, 1, 2}, 3);
            onDevice.set(std::span(&parts, 1), 0, eye);
            onDevice.begin();
            onDevice.read();
            for (std::size_t p = 0; p < parts.parts.size(); ++p) {
                const glm::dvec4 wanted = glm::normalize(screenPlane(parts.parts[p], light, eye).plane);
                const glm::dvec4 made = glm::normalize(glm::dvec4(onDevice.host[p].plane));
                EXPECT_NEAR(glm::distance(made, wanted), 0.0, 1e-5) << p << (perspective ? " perspective" : "");
            }
        }
    }
}

/// Two finely divided spheres, one before the other; the eye may be in the shadow of one.
TestScene spheres() {
    TestScene test;
    test.add(ground(8.0f));
    test.add(sphere(3)).translation = {-0.7, 1.5, 0.0};
    test.add(sphere(3)).translation = {0.9, 1.2, -1.5};
    return test;
}

TEST(SplitPlane, PartsThatCutThroughMeshesChangeNoPixel) {
    for (const LightType type : {LightType::Point, LightType::Directional}) {
        TestScene test = spheres();
        test.addLight(type, {-2.0, 5.0, 3.0});
        expectRight(test);
    }
}

TEST(SplitPlane, EachPartAddsItsOwnConstantWithTheEyeInOneVolume) {
    TestScene test = spheres();
    test.eye = {-0.7, 1.4, 4.0};
    test.target = {0.3, 1.0, -2.0};
    test.addLight(LightType::Point, {-0.7, 1.6, -4.0});  // the first sphere is between light and eye
    expectRight(test);
}

TEST(SplitPlane, MeshesAreDividedForTheEyeAndTheLight) {
    context();
    TestScene test = spheres();
    const Moment moment = evaluate(test.scene, {}, 0.0);
    const Geometry geometry(test.scene, moment);
    for (const bool automatic : {true, false}) {
        CasterParts parts(test.scene, moment, geometry, JobParts{.automatic = automatic});
        EXPECT_EQ(parts.onDevice().clusterCount() > 3, automatic);
    }
}

TEST(SplitPlane, SplitVolumesOfATreeChangeHalfTheCountsOfEitherRuleAlone) {
    const Subject tree = ours("tree", 256, 192);
    const auto updates = [&](const std::string& count) {
        const Moment moment = tree.moment();
        FrameRenderer renderer(tree.scene, moment, tree.settings({.technique = {"compute", count}}), context());
        FrameOutputs outputs;
        outputs.overdraw = true;
        Statistics statistics;
        const FramePixels pixels = renderer.render(moment, tree.camera, outputs, 1, statistics);
        double sum = 0.0;
        for (const float value : pixels.overdrawUpdates) sum += value;
        return sum;
    };
    const double split = updates("split-plane");
    EXPECT_LT(split, 0.5 * updates("z-pass"));
    EXPECT_LT(split, 0.5 * updates("z-fail"));
}

}  // namespace
}  // namespace umbrage::test
