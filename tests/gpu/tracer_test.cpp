// SPDX-License-Identifier: Apache-2.0
// The tracer beside the renderer: two ways to the same picture, so that their times can be compared.
#include "bench/tracer.h"

#include "subjects.h"

namespace umbrage::test {
namespace {

/// A frame by both, with constant colours and nothing blended.
struct ByBoth {
    explicit ByBoth(Subject pictured) : subject(std::move(pictured)) {
        const int width = subject.width, height = subject.height;
        makeColorsConstant(subject.scene);
        for (Material& material : subject.scene.materials) {
            if (material.alphaMode == AlphaMode::Blend) material.alphaMode = AlphaMode::Opaque;
        }
        const Moment moment = subject.moment();
        FrameSettings settings = subject.settings();
        settings.background = {0.1f, 0.2f, 0.3f};
        settings.ambientSky = {0.03f, 0.04f, 0.05f};
        settings.ambientGround = {0.02f, 0.01f, 0.015f};
        FrameRenderer renderer(subject.scene, moment, settings, context());
        FrameOutputs outputs;
        outputs.samples = true;
        Statistics statistics;
        rendered = renderer.render(moment, subject.camera, outputs, 1, statistics);
        TracerScene scene(subject.scene);
        EXPECT_TRUE(scene.place(moment, renderer.geometry(), makeEye(subject.camera, width, height)));
        scene.build();
        Tracer tracer(scene, tracerSettings(settings));
        traced = tracer.traceSamples(moment, subject.camera);
        withoutSamples = tracer.trace(moment, subject.camera);
        Judge judge(subject.scene, width, height, toleranceOf(context().subPixelBits()), 2);
        judge.setFrame(moment, subject.camera, renderer, traced);
        VerdictPlanes planes;
        verdict = judge.judge(traced, "tracer", planes);
    }

    std::size_t pixelCount() const { return std::size_t(subject.width) * std::size_t(subject.height); }
    bool alike(std::size_t pixel) const {
        for (std::size_t i = 4 * pixel; i < 4 * pixel + 4; ++i) {
            const float ours = rendered.radiance[i], theirs = traced.radiance[i];
            if (!(std::abs(ours - theirs) <= 1e-3f * std::max(ours, theirs) + 1e-6f)) return false;
        }
        return true;
    }

    std::size_t differentPixels() const {
        std::size_t different = 0;
        for (std::size_t i = 0; i < pixelCount(); ++i) different += !alike(i);
        return different;
    }
    std::size_t sampleCount() const { return traced.lights.size() * pixelCount(); }

    Subject subject;
    FramePixels rendered, traced;
    std::vector<float> withoutSamples;
    FrameVerdict verdict;
};

class TracerAndRenderer : public testing::TestWithParam<const char*> {};

TEST_P(TracerAndRenderer, MakeTheSamePicture) {
    const ByBoth both(ours(GetParam(), 256, 192));
    const std::size_t different = both.differentPixels(), samples = both.sampleCount();
    const std::size_t masks = maskDifferences(both.rendered, both.traced);
    std::uint64_t wrong = 0, facing = 0;
    for (const LightVerdict& light : both.verdict.lights) {
        wrong += light.hard() + light.bandFalseDark + light.bandFalseLit;
        facing += light.litFacing;
    }
    EXPECT_LT(double(different), 1e-2 * double(both.pixelCount()));
    EXPECT_LT(double(masks), 3e-4 * double(samples));
    EXPECT_LT(double(wrong), 2e-4 * double(facing));
    EXPECT_GT(facing, 10000u);
    EXPECT_EQ(both.traced.radiance, both.withoutSamples);
}

INSTANTIATE_TEST_SUITE_P(Sequences, TracerAndRenderer,
                         testing::Values("knights", "tree", "hall", "noise-spheres", "courtyard", "lantern", "pole"));

/// Eyes of both kinds, faces culled or not, mirrored and deforming meshes, lights of all kinds.
TEST(Tracer, SeesWhatTheRendererSeesInRandomScenes) {
    std::size_t pixels = 0, different = 0, samples = 0, masks = 0;
    for (const Subject& subject : subjects()) {
        const ByBoth both(subject);
        pixels += both.pixelCount();
        different += both.differentPixels();
        samples += both.sampleCount();
        masks += maskDifferences(both.rendered, both.traced);
    }
    EXPECT_GT(pixels, 100000u);
    EXPECT_LT(double(different), 2e-3 * double(pixels));  // depths tie where coordinates are snapped
    EXPECT_LT(double(masks), 3e-4 * double(samples));
}

/// Shadow rays that begin far from the surface miss what touches it; those that begin on it meet the surface itself.
TEST(Tracer, IsOnlyAsRightAsItsOffset) {
    const Subject subject = ours("knights", 256, 192);
    const Moment moment = subject.moment();
    FrameRenderer renderer(subject.scene, moment, subject.settings(), context());
    Statistics statistics;
    renderer.render(moment, subject.camera, {}, 1, statistics);
    TracerScene scene(subject.scene);
    scene.place(moment, renderer.geometry(), makeEye(subject.camera, 256, 192));
    scene.build();
    Judge judge(subject.scene, 256, 192, toleranceOf(context().subPixelBits()), 2);
    const auto verdictAt = [&](float offset) {
        TracerSettings settings = tracerSettings(subject.settings());
        settings.offset = offset;
        const FramePixels samples = Tracer(scene, settings).traceSamples(moment, subject.camera);
        judge.setFrame(moment, subject.camera, renderer, samples);
        VerdictPlanes planes;
        return judge.judge(samples, "tracer", planes).lights.front();
    };
    EXPECT_GT(verdictAt(0.0f).hardFalseDark, 100u);
    EXPECT_GT(verdictAt(1e-2f).hardFalseLit, 10u);
    EXPECT_EQ(verdictAt(TracerSettings().offset).hard(), 0u);
}

TEST(Tracer, TracesAlikeWithEveryInstructionSet) {
    const Subject subject = ours("courtyard", 101, 75);  // no whole number of packets
    const Moment moment = subject.moment();
    FrameRenderer renderer(subject.scene, moment, subject.settings(), context());
    Statistics statistics;
    renderer.render(moment, subject.camera, {}, 1, statistics);
    TracerScene scene(subject.scene);
    scene.place(moment, renderer.geometry(), makeEye(subject.camera, 101, 75));
    scene.build();
    const auto trace = [&](TraceTile* how) {
        return Tracer(scene, tracerSettings(subject.settings()), how).trace(moment, subject.camera);
    };
    const std::vector<float> here = trace(traceTileHere());
    __builtin_cpu_init();
    std::vector<TraceTile*> others{traceTileBaseline};
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) others.push_back(traceTileAvx2);
    for (TraceTile* other : others) {
        const std::vector<float> there = trace(other);
        std::size_t different = 0;
        for (std::size_t i = 0; i < here.size(); ++i) {
            different += !(std::abs(here[i] - there[i]) <= 1e-3f * std::max(here[i], there[i]) + 1e-6f);
        }
        EXPECT_LT(different, here.size() / 500);  // borders, where they contract otherwise
    }
}

TEST(Tracer, StandsStillWithItsScene) {
    const Subject subject = ours("tree", 64, 48);
    const Moment moment = subject.moment(), later = evaluate(subject.scene, subject.animations, 0.25);
    Geometry geometry(subject.scene, moment);
    const Eye eye = makeEye(subject.camera, 64, 48);
    TracerScene scene(subject.scene);
    const auto place = [&](const Moment& at) {
        geometry.update(subject.scene, at, eye);
        return scene.place(at, geometry, eye);
    };
    EXPECT_TRUE(place(moment));
    EXPECT_FALSE(place(moment));
    EXPECT_FALSE(place(later));  // there only light and camera move
}

}  // namespace
}  // namespace umbrage::test
