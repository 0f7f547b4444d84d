// SPDX-License-Identifier: Apache-2.0
// The judge on real frames with faults planted into the masks: what it lets pass, toggles, several samples a pixel,
// counts.
#include <random>

#include "subjects.h"

namespace umbrage::test {
namespace {

/// A picture, right as far as the device can, and its judge.
class Court {
public:
    explicit Court(const Subject& subject, int samples = 1, bool counts = false)
        : subject_(subject),
          judge_(subject.scene, subject.width, subject.height, toleranceOf(context().subPixelBits()), 2) {
        settings_ = subject.settings();
        settings_.samples = samples;
        outputs_.samples = true;
        outputs_.counts = counts;
        render(subject.moment());
    }

    void render(const Moment& moment) {
        Statistics statistics;
        FrameRenderer renderer(subject_.scene, moment, settings_, context());
        pixels = renderer.render(moment, subject_.camera, outputs_, 1, statistics);
        judge_.setFrame(moment, subject_.camera, renderer, pixels);
    }

    const std::vector<std::vector<std::uint8_t>>& exact() const { return judge_.exact(); }
    void makeExact() {
        for (std::size_t l = 0; l < pixels.lights.size(); ++l) pixels.lights[l].reaches = exact()[l];
    }
    FrameVerdict verdict(const std::string& technique = "tested") {
        VerdictPlanes planes;
        return judge_.judge(pixels, technique, planes);
    }

    FramePixels pixels;

private:
    const Subject& subject_;
    Judge judge_;
    FrameSettings settings_;
    FrameOutputs outputs_;
};

/// Per light, whether samples are turned to it and in its reach.
std::vector<std::vector<std::uint8_t>> facing(const Subject& subject) {
    How how;
    how.shadows = false;
    std::vector<std::vector<std::uint8_t>> result;
    for (LightPlanes& light : picture(subject, how).lights) result.push_back(std::move(light.reaches));
    return result;
}

class Power : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Ours, Power, testing::Values("knight", "courtyard"));

TEST_P(Power, FewWrongMasksWouldBeExcused) {
    constexpr int kFlips = 2000;
    const Subject subject = ours(GetParam(), 256, 192);
    Court court(subject);
    court.makeExact();
    ASSERT_EQ(court.verdict().lights[0].band(), 0u);
    const auto turned = facing(subject);
    std::mt19937_64 random(1);
    std::vector<std::vector<bool>> flipped(turned.size(), std::vector<bool>(turned[0].size()));
    for (int flips = 0; flips < kFlips;) {
        const std::size_t l = random() % turned.size(), i = random() % turned[l].size();
        if (!turned[l][i] || flipped[l][i]) continue;
        flipped[l][i] = true;
        court.pixels.lights[l].reaches[i] ^= 1u;
        ++flips;
    }
    std::uint64_t excused = 0, hard = 0, primary = 0, grazing = 0, boundary = 0;
    for (const LightVerdict& light : court.verdict().lights) {
        hard += light.hard();
        excused += light.band();
        primary += light.primary;
        grazing += light.grazing;
        boundary += light.boundary;
    }
    EXPECT_EQ(hard + excused, std::uint64_t(kFlips));
    EXPECT_LT(double(excused), 0.03 * kFlips);
    std::printf(
        "%s: of %d wrong masks %.2f %% would be excused (other surface %.2f %%, grazing %.2f %%, boundary %.2f %%)\n",
        GetParam(), kFlips, 100.0 * double(excused) / kFlips, 100.0 * double(primary) / kFlips,
        100.0 * double(grazing) / kFlips, 100.0 * double(boundary) / kFlips);
}

/// A box over a ground that fills the picture.
Subject boxOverGround() {
    TestScene test;
    test.add(ground(60.0f));
    test.add(box({-1, 1, -1}, {1, 2, 1}));
    test.addLight(LightType::Directional, {1.0, 2.0, 0.7});
    test.eye = {0.5, 9.0, 6.0};
    Subject subject;
    subject.scene = test.scene;
    subject.camera = test.placedCamera();
    subject.width = 96;
    subject.height = 72;
    return subject;
}

TEST(JudgeToggles, AreCountedAgainstTheFrameThatTheTechniqueWasJudgedAtBefore) {
    const Subject subject = boxOverGround();
    const Moment first = subject.moment();
    Moment second = first;
    second.lights[0].direction = glm::normalize(glm::dvec3(1.0, -2.0, 0.4));
    Court court(subject);
    court.makeExact();
    const auto exactFirst = court.exact();
    EXPECT_EQ(court.verdict("always").lights[0].excessToggles, 0u) << "there is no frame before";
    court.verdict("seldom");
    for (int frame = 0; frame < 2; ++frame) {
        court.render(second);
        court.makeExact();
        ASSERT_NE(court.exact(), exactFirst);
        EXPECT_EQ(court.verdict("always").lights[0].excessToggles, 0u);
    }
    EXPECT_EQ(court.verdict("seldom").lights[0].excessToggles, 0u) << "the shadow has moved since it was judged";
    court.pixels.lights[0].reaches[96 * 3 + 5] ^= 1u;
    EXPECT_EQ(court.verdict("always").lights[0].excessToggles, 1u);
    EXPECT_EQ(court.verdict("always").lights[0].excessToggles, 0u) << "it stays as it is";
}

TEST(JudgeSamples, AreJudgedWhereTheyLie) {
    const Subject subject = boxOverGround();
    const int samples = context().maxSamples();
    ASSERT_GT(samples, 1);
    Court court(subject, samples);
    const std::size_t pixelCount = std::size_t(subject.width) * std::size_t(subject.height);
    ASSERT_EQ(court.pixels.lights[0].reaches.size(), std::size_t(samples) * pixelCount);
    EXPECT_EQ(court.verdict().hard(), 0u);
    EXPECT_LT(court.verdict().lights[0].band(), 20u);
    // One sample of every pixel that an outline crosses: at pixels' centres, all would be in doubt.
    court.makeExact();
    std::size_t flips = 0;
    for (std::size_t pixel = 0; pixel < pixelCount; ++pixel) {
        bool mixed = false;
        for (std::size_t s = 1; s < std::size_t(samples); ++s) {
            mixed = mixed || court.exact()[0][s * pixelCount + pixel] != court.exact()[0][pixel];
        }
        if (!mixed) continue;
        court.pixels.lights[0].reaches[(pixel % std::size_t(samples)) * pixelCount + pixel] ^= 1u;
        ++flips;
    }
    const FrameVerdict verdict = court.verdict();
    EXPECT_GT(flips, 30u);
    EXPECT_EQ(verdict.hard() + verdict.lights[0].band(), flips);
    EXPECT_GT(double(verdict.hard()), 0.8 * double(flips));
}

TEST(JudgeSamples, OutlinesAndBiasArePixels) {
    const Subject subject = boxOverGround();
    const std::size_t pixelCount = std::size_t(subject.width) * std::size_t(subject.height);
    double lengths[2];
    for (const bool many : {false, true}) {
        const int samples = many ? context().maxSamples() : 1;
        SCOPED_TRACE(samples);
        Court court(subject, samples);
        court.makeExact();
        // Ten whole pixels of the lit ground.
        for (std::size_t i = 0; i < court.pixels.lights[0].reaches.size(); ++i) {
            if (i % pixelCount >= 10) continue;
            ASSERT_EQ(court.exact()[0][i], 1u);
            court.pixels.lights[0].reaches[i] = 0;
        }
        const LightVerdict light = court.verdict().lights[0];
        EXPECT_EQ(light.hardFalseDark, 10u * unsigned(samples));
        EXPECT_EQ(light.largestComponent, 10u);
        EXPECT_EQ(light.largestExtent, 10);
        lengths[many] = light.boundaryLength;
        EXPECT_NEAR(light.signedBias() * light.boundaryLength, 10.0, 1e-9);
    }
    EXPECT_GT(lengths[0], 30.0);
    EXPECT_NEAR(lengths[1], lengths[0], 0.1 * lengths[0]);
}

TEST(JudgeCounts, WrongOnesAreFoundAndMultiplesOf256AreNot) {
    const Subject subject = boxOverGround();
    Court court(subject, 1, true);
    LightPlanes& light = court.pixels.lights[0];
    ASSERT_FALSE(light.countsAreWide);
    EXPECT_GT(*std::ranges::max_element(light.counts), 0u);
    LightVerdict verdict = court.verdict().lights[0];
    EXPECT_EQ(verdict.countsJudged, light.counts.size());
    EXPECT_EQ(verdict.hardCountErrors, 0u);
    const std::uint64_t before = verdict.countErrors;
    for (std::size_t i = 0; i < 20; ++i) light.counts[i] += 256;
    EXPECT_EQ(court.verdict().lights[0].countErrors, before);
    for (std::size_t i = 0; i < 5; ++i) light.counts[i] += 3;
    for (std::size_t i = 5; i < 7; ++i) light.counts[i] -= 4;
    verdict = court.verdict().lights[0];
    EXPECT_EQ(verdict.countErrors, before + 7);
    EXPECT_EQ(verdict.hardCountErrors, 7u);
    EXPECT_EQ(verdict.largestCountError, 4u) << "one below none is not 255 too many";
}

}  // namespace
}  // namespace umbrage::test
