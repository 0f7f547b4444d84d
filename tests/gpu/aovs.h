// SPDX-License-Identifier: Apache-2.0
// Test scenes rendered with AOVs, and what the scene says about a pixel.
#pragma once

#include <gtest/gtest.h>

#include "job/aovs.h"
#include "techniques.h"

namespace umbrage::test {

/// All that have no flag of their own, and the flags.
inline FrameOutputs everyAov() {
    FrameOutputs outputs;
    for (const AovInfo& aov : kAovs) outputs.aovs.emplace(aov.name);
    outputs.geometry = outputs.shadows = outputs.overdraw = outputs.scene = outputs.samples = true;
    return outputs;
}

/// A frame of a test scene with all AOVs, and access to their pixels.
class AovFrame {
public:
    static constexpr int kWidth = 160, kHeight = 120;

    explicit AovFrame(const TestScene& test, int samples = 1, double timeSeconds = 0.0,
                      const PlacedMoment* before = nullptr, const FrameOutputs& outputs = everyAov())
        : eye_(makeEye(test.placedCamera(), kWidth, kHeight)) {
        FrameSettings settings;
        settings.width = kWidth;
        settings.height = kHeight;
        settings.samples = samples;
        settings.background = {0.2f, 0.4f, 0.1f};
        settings.ambientSky = {0.3f, 0.2f, 0.1f};
        settings.ambientGround = {0.1f, 0.1f, 0.2f};
        const Moment moment = momentAt(test.scene, timeSeconds);
        FrameRenderer renderer(test.scene, moment, settings, context());
        Statistics statistics;
        pixels = renderer.render(moment, test.placedCamera(), outputs, 1, statistics, before);
    }

    static Moment momentAt(const Scene& scene, double timeSeconds) {
        const Index first = 0;
        return evaluate(scene, scene.animations.empty() ? std::span<const Index>{} : std::span(&first, 1), timeSeconds);
    }

    FramePixels pixels;

    static constexpr std::size_t kPixelCount = std::size_t(kWidth) * std::size_t(kHeight);
    /// Of the first sample, in the picture.
    glm::dvec2 placeOf(std::size_t pixel) const {
        return glm::dvec2(glm::uvec2(pixel % kWidth, pixel / kWidth)) + glm::dvec2(pixels.seen.positions[0]);
    }

    bool covered(std::size_t pixel) const { return std::isfinite(depth(pixel)); }
    double depth(std::size_t pixel) const { return pixels.normalAndDepth[4 * pixel + 3]; }
    glm::dvec3 vectorOf(const char* aov, std::size_t pixel, int light = -1) const {
        const AovPlanes& planes = light < 0 ? pixels.aovs : pixels.lights[std::size_t(light)].aovs;
        const AovPlane& plane = planes.find(aov)->second;
        glm::dvec3 v(0.0);
        for (int c = 0; c < plane.components; ++c)
            v[c] = plane.values[pixel * std::size_t(plane.components) + std::size_t(c)];
        return v;
    }
    /// Object, material, primitive.
    glm::uvec3 ids(std::size_t pixel) const {
        const std::vector<std::uint32_t>& ids = pixels.aovs.find("ids")->second.integers;
        return {ids[3 * pixel], ids[3 * pixel + 1], ids[3 * pixel + 2]};
    }

    /// Where a point of the world is in the picture.
    glm::dvec2 projected(const glm::dvec3& p) const { return projectedBy(eye_, p); }
    static glm::dvec2 projectedBy(const Eye& eye, const glm::dvec3& p) {
        const glm::dvec3 v(eye.viewFromWorld * glm::dvec4(p, 1.0));
        const glm::dvec2 ndc = glm::dvec2(v) / eye.rayScale / (eye.perspective ? -v.z : 1.0);
        return {0.5 * kWidth * (1.0 + ndc.x), 0.5 * kHeight * (1.0 - ndc.y)};
    }
    const Eye& eye() const { return eye_; }

private:
    Eye eye_;
};

/// A ground, a sphere that floats over it and a box, in three materials, two lights and one that is off.
inline TestScene courtScene() {
    TestScene test;
    test.eye = {1.0, 2.5, 6.0};
    test.add(ground(4.0f));
    test.add(transformed(sphere(2), glm::mat4(1.0f))).translation = {-0.8, 1.5, 0.0};
    test.add(box({-0.5f, 0.0f, -0.5f}, {0.5f, 1.0f, 0.5f}), true).translation = {1.3, 0.2, 0.4};
    test.addLight(LightType::Point, {2.0, 4.0, 3.0});
    test.addLight(LightType::Directional, {-1.0, 2.0, 0.5});
    test.addLight(LightType::Point, {0.0, 5.0, 0.0});
    test.scene.lights[2].intensity = 0.0f;
    test.scene.materials[0].metallic = 0.0f;
    test.scene.materials[1].emissive = {0.5f, 0.1f, 0.0f};
    return test;
}

}  // namespace umbrage::test
