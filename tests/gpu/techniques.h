// SPDX-License-Identifier: Apache-2.0
// Rendering a test scene by any technique, and what must hold for all of them.
#pragma once

#include <gtest/gtest.h>

#include "gpu/context.h"
#include "job/names.h"
#include "scenes.h"

namespace umbrage::test {

inline constexpr int kWidth = 160, kHeight = 120;

inline const gpu::Context& context() {
    static const gpu::Context instance;
    return instance;
}

inline FramePixels render(const TestScene& test, const std::string& count, const std::string& silhouette, bool halve,
                          bool counts = false, bool endVolumes = true) {
    FrameSettings settings;
    settings.width = kWidth;
    settings.height = kHeight;
    settings.count = count;
    settings.silhouette = silhouette;
    settings.halveEvenComponents = halve;
    settings.endVolumes = endVolumes;
    const Moment moment = evaluate(test.scene, {}, 0.0);
    FrameRenderer renderer(test.scene, moment, settings, context());
    FrameOutputs outputs;
    outputs.shadows = outputs.geometry = true;
    outputs.counts = counts;
    Statistics statistics;
    return renderer.render(moment, test.placedCamera(), outputs, 1, statistics);
}

inline void expectAsBruteForce(const TestScene& test, const FramePixels& pixels) {
    const Moment moment = evaluate(test.scene, {}, 0.0);
    for (std::size_t l = 0; l < moment.lights.size(); ++l) {
        SCOPED_TRACE(moment.lights[l].id);
        const BruteForce bruteForce(test, moment, moment.lights[l], kWidth, kHeight);
        const BruteForce::Mismatches mismatches = bruteForce.compare(pixels.lights[l].shadow, pixels.normalAndDepth);
        EXPECT_EQ(mismatches.wrong, 0);
        EXPECT_LE(mismatches.boundary, 0.002 * kWidth * kHeight);
        EXPECT_GT(mismatches.judged, kWidth);
    }
}

/// The mask agrees with brute force but for pixels on boundaries, and is the same for every technique and skip that
/// moves no corner.
inline void expectRight(const TestScene& test) {
    const Moment moment = evaluate(test.scene, {}, 0.0);
    FramePixels reference;
    for (const char* count : {"z-pass", "z-fail", "split-plane"}) {
        for (const NameAndMeaning& technique : kSilhouettes) {
            const std::string silhouette(technique.name);
            if (!canPair(silhouette, count)) continue;
            for (const bool halve : {true, false}) {
                SCOPED_TRACE(std::string(count) + " " + silhouette + (halve ? " halved" : " whole"));
                FramePixels pixels = render(test, count, silhouette, halve, false, false);
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
    expectAsBruteForce(test, reference);
    expectAsBruteForce(test, render(test, "z-pass", "compute", true));
}

}  // namespace umbrage::test
