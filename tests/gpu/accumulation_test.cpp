// SPDX-License-Identifier: Apache-2.0
// Antialiasing by accumulation: pictures taken off the pixels' centres are as exact as others, and their mean is what
// pixels cover.
#include <set>

#include "frame/accumulate.h"
#include "sheets.h"
#include "subjects.h"

namespace umbrage::test {
namespace {

PlacedMoment placed(const Subject& subject) {
    return {subject.moment(), subject.camera};
}

FramePixels accumulated(const PlacedMoment& now, const Scene& scene, const FrameSettings& settings,
                        const FrameOutputs& outputs = {}) {
    FrameRenderer renderer(scene, now.moment, settings, context());
    Statistics statistics;
    return renderAccumulated(renderer, now, outputs, 1, statistics);
}

/// Root of the mean square of the differences in red, green and blue, each at most 1.
double rmse(const std::vector<float>& a, const std::vector<float>& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (i % 4 == 3) continue;
        sum += std::pow(double(std::min(a[i], 1.0f)) - double(std::min(b[i], 1.0f)), 2.0);
    }
    return std::sqrt(sum / (0.75 * double(a.size())));
}

class Shifted : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Techniques, Shifted, testing::ValuesIn(techniqueNames()), [](const auto& one) {
    std::string name = one.param;
    std::ranges::replace_if(
        name, [](char c) { return c == ':' || c == '-'; }, '_');
    return name;
});

// Of both kinds of cameras, with the light's volumes before, around and beside the eye.
TEST_P(Shifted, MasksAreExactAtEveryShift) {
    const Technique technique = Technique::named(GetParam());
    const auto* row = std::ranges::find(kCounts, std::string_view(technique.count), &CountName::name);
    if (row->exact == Exact::Never) GTEST_SKIP() << "not exact unshifted";
    for (const Subject& subject : subjects()) {
        FrameSettings settings = subject.settings();
        choose(technique, settings);
        Judge judge(subject.scene, subject.width, subject.height, toleranceOf(context().subPixelBits()), 2);
        const Moment moment = subject.moment();
        FrameRenderer renderer(subject.scene, moment, settings, context());
        FrameOutputs outputs;
        outputs.samples = true;
        PlacedCamera camera = subject.camera;
        for (int picture = 0; picture < 2; ++picture) {
            camera.shiftPixels = accumulationShift(picture, 16, 1);
            Statistics statistics;
            const FramePixels pixels = renderer.render(moment, camera, outputs, 1, statistics);
            judge.setFrame(moment, camera, renderer, pixels);
            VerdictPlanes planes;
            for (const LightVerdict& light : judge.judge(pixels, GetParam(), planes).lights) {
                EXPECT_EQ(light.hard(), 0u) << subject.name << " picture " << picture;
            }
        }
    }
}

TEST(Accumulation, OneIsInTheMiddleAndMoreFillColumnsRowsAndCells) {
    for (const int samples : {1, 4}) {
        EXPECT_EQ(accumulationShift(0, 1, samples), glm::dvec2(0.0));
        for (const int count : {2, 16, 64, 256}) {
            std::set<int> columns, rows, cells;
            const int side = count == 2 ? 1 : int(std::sqrt(count));
            glm::dvec2 mean(0.0);
            for (int i = 0; i < count; ++i) {
                const glm::dvec2 shift = accumulationShift(i, count, samples) * std::sqrt(double(samples));
                EXPECT_TRUE(i > 0 || std::abs(glm::length(shift) - std::sqrt(0.5) / count) < 1e-12);
                const glm::dvec2 place = shift + 0.5;
                columns.insert(int(std::floor(place.x * count)));
                rows.insert(int(std::floor(place.y * count)));
                cells.insert(int(place.y * side) * side + int(place.x * side));
                mean += shift;
            }
            EXPECT_EQ(int(columns.size()), count);
            EXPECT_EQ(int(rows.size()), count);
            EXPECT_EQ(int(cells.size()), side * side);
            EXPECT_TRUE(*columns.begin() == 0 && *columns.rbegin() == count - 1);
            EXPECT_NEAR(glm::length(mean), 0.0, 1e-9);
        }
    }
}

TEST(Accumulation, OfOneIsThePicture) {
    const Subject subject = ours("knight", 128, 96);
    const FramePixels one = accumulated(placed(subject), subject.scene, subject.settings());
    EXPECT_EQ(one.radiance, picture(subject).radiance);
}

// A whole pixel's shift is the neighbour's picture.
TEST(Accumulation, AShiftOfAPixelIsTheNextPixel) {
    for (const bool perspective : {true, false}) {
        Subject subject = ours("knight", 96, 64);
        subject.camera.camera.perspective = perspective;
        subject.camera.camera.ymag = 1.5;
        if (!perspective) subject.camera.camera.zfar = 100.0;
        const FramePixels still = picture(subject);
        subject.camera.shiftPixels = {1.0, -1.0};
        const FramePixels moved = picture(subject);
        std::size_t same = 0, all = 0;
        for (int y = 1; y < subject.height; ++y) {
            for (int x = 0; x + 1 < subject.width; ++x, ++all) {
                const auto at = std::size_t(y * subject.width + x), next = at + 1 - std::size_t(subject.width);
                bool equal = moved.seen.triangles[at] == still.seen.triangles[next];
                for (std::size_t l = 0; l < still.lights.size(); ++l) {
                    equal = equal && moved.lights[l].reaches[at] == still.lights[l].reaches[next];
                }
                for (std::size_t c = 0; c < 3; ++c) {
                    const float a = moved.radiance[4 * at + c], b = still.radiance[4 * next + c];
                    equal = equal && std::abs(a - b) <= 1e-3f * (1.0f + std::abs(b));
                }
                same += equal;
            }
        }
        EXPECT_GE(double(same), 0.999 * double(all)) << (perspective ? "perspective" : "orthographic");
    }
}

/// A white sheet before black whose left border cuts pixels.
struct HalfCovered {
    Sheets sheets;
    double border = 0.0;  // in pixels

    explicit HalfCovered(double at, bool perspective) : border(at) {
        Material white;
        white.unlit = true;
        sheets.settings.width = 16, sheets.settings.height = 12;
        sheets.test.camera.perspective = perspective;
        sheets.test.camera.ymag = 2.0;
        if (!perspective) sheets.test.camera.zfar = 10.0;
        sheets.add(white, 8.0f);
        const Eye eye = makeEye(sheets.test.placedCamera(), 16, 12);
        const double distance = perspective ? sheets.test.eye.z : 1.0;
        for (glm::vec3& p : sheets.lastMesh().positions) {
            if (p.x < 0.0f) p.x = float((2.0 * at / 16.0 - 1.0) * eye.rayScale.x * distance);
        }
    }
    FramePixels render(int samples, int accumulation) {
        sheets.settings.samples = samples;
        sheets.settings.accumulation = accumulation;
        return accumulated({evaluate(sheets.test.scene, {}, 0.0), sheets.test.placedCamera()}, sheets.test.scene,
                           sheets.settings);
    }
};

TEST(Accumulation, OfSixteenCoversLikeThePixel) {
    for (const bool perspective : {true, false}) {
        for (const double at : {5.1, 5.25, 5.5, 5.85}) {
            HalfCovered subject(at, perspective);
            const FramePixels pixels = subject.render(1, 16);
            EXPECT_EQ(pixels.radiance[subject.sheets.index(4, 5)], 0.0f);
            EXPECT_EQ(pixels.radiance[subject.sheets.index(6, 5)], 1.0f);
            EXPECT_NEAR(pixels.radiance[subject.sheets.index(5, 5)], 6.0 - at, 1.0 / 32.0 + 1e-3) << at;
        }
    }
}

TEST(Accumulation, TogetherWithSamplesCoversLikeThePixel) {
    HalfCovered subject(5.25, true);
    EXPECT_EQ(subject.render(4, 1).radiance[subject.sheets.index(5, 5)], 0.75f);
    const FramePixels pixels = subject.render(4, 16);
    EXPECT_NEAR(pixels.radiance[subject.sheets.index(5, 5)], 0.75, 1.0 / 32.0);
    EXPECT_EQ(pixels.radiance[subject.sheets.index(3, 5)], 0.0f);
}

// Shadows' borders, too: four samples a pixel are half as far from the truth as one or less, and so are four pictures.
TEST(Accumulation, ComesNearerLikeSamples) {
    const Subject subject = ours("knight", 96, 64);
    FrameOutputs outputs;
    outputs.shadows = true;
    const auto made = [&](int samples, int accumulation) {
        FrameSettings settings = subject.settings();
        settings.samples = samples;
        settings.accumulation = accumulation;
        return accumulated(placed(subject), subject.scene, settings, outputs);
    };
    const FramePixels reference = made(1, 256);
    const double one = rmse(made(1, 1).radiance, reference.radiance),
                 four = rmse(made(4, 1).radiance, reference.radiance);
    const double pictures = rmse(made(1, 4).radiance, reference.radiance);
    const FramePixels both = made(4, 16);
    EXPECT_LT(four, 0.6 * one);
    EXPECT_LT(pictures, 0.6 * one);
    EXPECT_LT(pictures, 1.5 * four);
    EXPECT_LT(rmse(both.radiance, reference.radiance), 0.25 * one);
    double difference = 0.0, partly = 0.0;
    for (std::size_t i = 0; i < both.lights[0].shadow.size(); ++i) {
        const double share = reference.lights[0].shadow[i];
        difference = std::max(difference, std::abs(double(both.lights[0].shadow[i]) - share));
        partly += share > 0.0 && share < 1.0;
    }
    EXPECT_LT(difference, 0.2);
    EXPECT_GT(partly, 100.0);
}

TEST(Accumulation, DataIsOfTheFirstPictureAndLightAddsUp) {
    const Subject subject = ours("knight", 64, 48);
    FrameOutputs outputs;
    outputs.geometry = outputs.counts = true;
    outputs.aovs = {"ids", "light", "ambient", "emissive"};
    FrameSettings settings = subject.settings();
    PlacedMoment first = placed(subject);
    first.camera.shiftPixels = accumulationShift(0, 3, 1);
    FrameRenderer renderer(subject.scene, first.moment, settings, context());
    Statistics statistics;
    const FramePixels one = renderer.render(first.moment, first.camera, outputs, 1, statistics);
    settings.accumulation = 3;
    const FramePixels three = accumulated(placed(subject), subject.scene, settings, outputs);
    EXPECT_NE(three.radiance, one.radiance);
    EXPECT_EQ(three.normalAndDepth, one.normalAndDepth);
    EXPECT_EQ(three.aovs.at("ids").integers, one.aovs.at("ids").integers);
    for (std::size_t l = 0; l < one.lights.size(); ++l) EXPECT_EQ(three.lights[l].counts, one.lights[l].counts);
    for (std::size_t i = 0; i < three.radiance.size() / 4; ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            double sum = 0.0;
            for (const char* name : {"ambient", "emissive"}) sum += three.aovs.at(name).values[3 * i + c];
            for (const LightPlanes& light : three.lights) sum += light.aovs.at("light").values[3 * i + c];
            ASSERT_NEAR(three.radiance[4 * i + c], sum, 1e-3 * (1.0 + sum)) << i;
        }
    }
}

}  // namespace
}  // namespace umbrage::test
