// SPDX-License-Identifier: Apache-2.0
// The tracer beside the renderer: two ways to the same picture, so that their times can be compared.
#include "bench/tracer.h"

#include "subjects.h"

namespace umbrage::test {
namespace {

/// A frame by both, with constant colours.
struct ByBoth {
    ByBoth(const std::string& name, int width, int height) : subject(ours(name, width, height)) {
        makeColorsConstant(subject.scene);
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

    Subject subject;
    FramePixels rendered, traced;
    std::vector<float> withoutSamples;
    FrameVerdict verdict;
};

class TracerAndRenderer : public testing::TestWithParam<const char*> {};

TEST_P(TracerAndRenderer, MakeTheSamePicture) {
    const ByBoth both(GetParam(), 256, 192);
    std::size_t different = 0, samples = 0;
    for (std::size_t i = 0; i < both.pixelCount(); ++i) different += !both.alike(i);
    for (const LightPlanes& light : both.traced.lights) samples += light.reaches.size();
    const std::size_t masks = maskDifferences(both.rendered, both.traced);
    std::uint64_t wrong = 0, facing = 0;
    for (const LightVerdict& light : both.verdict.lights) {
        wrong += light.hard() + light.bandFalseDark + light.bandFalseLit;
        facing += light.litFacing;
    }
    std::printf("%s: %zu of %zu pixels differ, masks of %zu of %zu samples; %llu of %llu wrong, %llu hard\n",
                GetParam(), different, both.pixelCount(), masks, samples, (unsigned long long)wrong,
                (unsigned long long)facing, (unsigned long long)both.verdict.hard());
    EXPECT_LT(double(different), 1e-2 * double(both.pixelCount()));
    EXPECT_LT(double(masks), 5e-4 * double(samples));
    EXPECT_EQ(both.traced.radiance, both.withoutSamples);
}

INSTANTIATE_TEST_SUITE_P(Sequences, TracerAndRenderer,
                         testing::Values("knights", "tree", "hall", "noise-spheres", "lantern", "pole"));

}  // namespace
}  // namespace umbrage::test
