// SPDX-License-Identifier: Apache-2.0
// Counts themselves: high ones, their agreement between techniques, many lights, and frames with nothing to count.
#include "techniques.h"

namespace umbrage::test {
namespace {

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
    const FramePixels pixels = render(test, "z-pass", "compute", true);
    const FramePixels host = render(test, "z-fail", "cpu", true);
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
    const FramePixels pixels = render(test, "z-pass", "compute", true);
    const float* centre = &pixels.normalAndDepth[4 * (std::size_t(kHeight) / 2 * kWidth + kWidth / 2)];
    EXPECT_NEAR(centre[1], 1.0f, 1e-3f);
    EXPECT_NEAR(centre[3], std::sqrt(68.0f), 0.3f);  // from (0, 2, 8) to the origin, half a pixel aside
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
        const FramePixels counted = render(test, "z-pass", "compute", true, true);
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
    const std::vector<float>& shadow = pixels.lights[0].shadow;
    const std::vector<std::uint32_t>& counts = pixels.lights[0].counts;
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
    const FramePixels pass = render(test, "z-pass", "compute", true, true);
    const FramePixels fail = render(test, "z-fail", "cpu", true, true);
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
