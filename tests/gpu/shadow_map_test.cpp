// SPDX-License-Identifier: Apache-2.0
// Shadow maps, the bench's competitor: nearly right at a high resolution, worse at a lower one, full of spots without
// a bias. Wrong is what the judge says.
#include "bench/shadow_map.h"

#include "subjects.h"

namespace umbrage::test {
namespace {

struct Judged {
    std::uint64_t wrong = 0, turned = 0;
    std::size_t shadowed = 0;

    double share() const { return double(wrong) / double(turned); }
};

Judged judged(const Subject& subject, const ShadowMapSettings& map, int samples = 1) {
    FrameSettings settings = subject.settings();
    settings.samples = samples;
    settings.shadows = false;
    settings.maskMaker = makeShadowMaps(map);
    const Moment moment = subject.moment();
    FrameRenderer renderer(subject.scene, moment, settings, context());
    FrameOutputs outputs;
    outputs.samples = true;
    Statistics statistics;
    const FramePixels pixels = renderer.render(moment, subject.camera, outputs, 1, statistics);
    Judge judge(subject.scene, subject.width, subject.height, toleranceOf(context().subPixelBits()), 2);
    judge.setFrame(moment, subject.camera, renderer, pixels);
    VerdictPlanes planes;
    Judged sum;
    for (const LightVerdict& light : judge.judge(pixels, "shadow map", planes).lights) {
        sum.wrong += light.hard() + light.band();
        sum.turned += light.litFacing;
    }
    sum.shadowed = samples == 1 ? shadowed(subject, pixels) : 0;
    return sum;
}

/// The knight under one light.
Subject under(LightType type) {
    Subject subject = ours("knight", 128, 96);
    for (Light& light : subject.scene.lights) {
        light.type = type;
        light.outerConeAngle = 0.9f;
        light.innerConeAngle = 0.0f;
    }
    return subject;
}

class OfLights : public testing::TestWithParam<LightType> {};
INSTANTIATE_TEST_SUITE_P(Types, OfLights, testing::Values(LightType::Point, LightType::Spot, LightType::Directional));

TEST_P(OfLights, MoreTexelsAreNearerToTheTruthAndABiasNearerYet) {
    const Subject subject = under(GetParam());
    const Judged fine = judged(subject, {2048, true}), coarse = judged(subject, {128, true});
    EXPECT_GT(fine.shadowed, 50u);
    EXPECT_LT(fine.share(), 0.02);
    EXPECT_LT(2.0 * fine.share(), coarse.share());
    EXPECT_LT(coarse.share(), 0.2);
    // Every other texel of a surface is before it.
    EXPECT_GT(judged(subject, {128, false}).share(), 0.2);
}

TEST(ShadowMaps, JudgeEverySample) {
    const Subject subject = under(LightType::Point);
    const Judged one = judged(subject, {1024, true}), four = judged(subject, {1024, true}, 4);
    EXPECT_GT(four.turned, 3 * one.turned);
    EXPECT_LT(four.share(), 1.5 * one.share());
}

}  // namespace
}  // namespace umbrage::test
