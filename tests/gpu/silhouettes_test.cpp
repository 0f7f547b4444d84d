// SPDX-License-Identifier: Apache-2.0
// What silhouette techniques have in common, beyond the masks that every test of shadows compares: counts, figures and
// pictures of the volumes are those of the default, bit by bit, as if it had drawn them. And the fault of one of them.
#include <algorithm>
#include <random>

#include "subjects.h"

namespace umbrage::test {
namespace {

struct Seen {
    FramePixels pixels;
    Statistics statistics;
};

Seen everythingOf(const Subject& subject, const std::string& silhouette, const std::string& count, int samples) {
    FrameSettings settings = subject.settings({{silhouette, count}});
    settings.samples = samples;
    FrameOutputs outputs;
    outputs.samples = outputs.counts = outputs.overdraw = outputs.figures = outputs.topCasters = outputs.hulls = true;
    outputs.aovs = {"silhouette", "contour", "cost"};
    const Moment moment = subject.moment();
    FrameRenderer renderer(subject.scene, moment, settings, context());
    Seen seen;
    seen.pixels = renderer.render(moment, subject.camera, outputs, 1, seen.statistics);
    return seen;
}

class Silhouettes : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(All, Silhouettes,
                         testing::Values("cpu", "vertex-reject", "vertex-reject-readback", "degenerate-quad",
                                         "geometry-shader"),
                         [](const auto& test) {
                             std::string name = test.param;
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name;
                         });

void expectAlike(const Subject& subject, const std::string& silhouette, const std::string& count, int samples) {
    SCOPED_TRACE(subject.name + " " + count);
    const Seen expected = everythingOf(subject, "compute", count, samples);
    const Seen seen = everythingOf(subject, silhouette, count, samples);
    for (std::size_t l = 0; l < expected.pixels.lights.size(); ++l) {
        const LightPlanes &a = expected.pixels.lights[l], &b = seen.pixels.lights[l];
        SCOPED_TRACE(a.id);
        EXPECT_EQ(a.reaches, b.reaches);
        EXPECT_EQ(a.counts, b.counts);
        for (const char* aov : {"silhouette", "cost"}) {
            EXPECT_EQ(a.aovs.find(aov)->second.values, b.aovs.find(aov)->second.values) << aov;
        }
        for (const Counter counter :
             {Counter("quads"), Counter("edges.silhouette"), Counter("edges.silhouette.twice")}) {
            const auto valueOf = [&](const Statistics& statistics) {
                const auto& values = statistics.file({}).frames.at(1).at({.light = a.id}).values;
                return values.at(counter.index());
            };
            EXPECT_EQ(valueOf(expected.statistics), valueOf(seen.statistics)) << counter.index();
        }
    }
    EXPECT_EQ(expected.pixels.overdrawFragments, seen.pixels.overdrawFragments);
    EXPECT_EQ(expected.pixels.overdrawUpdates, seen.pixels.overdrawUpdates);
    EXPECT_EQ(expected.pixels.aovs.find("contour")->second.values, seen.pixels.aovs.find("contour")->second.values);
    ASSERT_EQ(expected.pixels.topCasters.size(), seen.pixels.topCasters.size());
    for (std::size_t i = 0; i < expected.pixels.topCasters.size(); ++i) {
        EXPECT_EQ(expected.pixels.topCasters[i].path, seen.pixels.topCasters[i].path);
        EXPECT_EQ(expected.pixels.topCasters[i].pixels, seen.pixels.topCasters[i].pixels);
    }
}

TEST_P(Silhouettes, DrawTheSameQuadsWhateverTheyAreDrawnInto) {
    expectAlike(ours("noise-spheres", 160, 120), GetParam(), "z-fail", 1);
    expectAlike(ours("courtyard", 160, 120), GetParam(), "z-pass", 1);
}

TEST_P(Silhouettes, DrawTheSameQuadsOfSoupsForEverySample) {
    for (const std::size_t i : {0u, 3u, 7u}) {
        expectAlike(subjects()[i], GetParam(), "z-pass", context().maxSamples());
    }
}

std::uint64_t hardErrorsOf(const Subject& subject, const std::string& silhouette, Fault fault) {
    FrameSettings settings = subject.settings({{silhouette, "z-pass"}});
    settings.fault = fault;
    const Moment moment = subject.moment();
    FrameRenderer renderer(subject.scene, moment, settings, context());
    FrameOutputs outputs;
    outputs.samples = true;
    Statistics statistics;
    const FramePixels pixels = renderer.render(moment, subject.camera, outputs, 1, statistics);
    Judge judge(subject.scene, subject.width, subject.height, toleranceOf(context().subPixelBits()), 2);
    judge.setFrame(moment, subject.camera, renderer, pixels);
    VerdictPlanes planes;
    return judge.judge(pixels, silhouette, planes).hard();
}

TEST(SilhouetteFaults, TheFirstPublishedExtrusionOfDegenerateQuadsIsCaught) {
    const Subject subject = ours("knight", 160, 120);
    EXPECT_EQ(hardErrorsOf(subject, "degenerate-quad", Fault::None), 0u);
    EXPECT_GT(hardErrorsOf(subject, "degenerate-quad", Fault::OriginExtrusion), 100u);
}

TEST(SilhouetteFaults, LostEdgesAndWrongFacingsAreCaught) {
    const Subject subject = ours("knight", 160, 120);
    for (const char* silhouette : {"compute", "vertex-reject", "vertex-reject-readback"}) {
        EXPECT_GT(hardErrorsOf(subject, silhouette, Fault::MissingEdge), 0u) << silhouette;
    }
    for (const char* silhouette : {"vertex-reject", "degenerate-quad", "geometry-shader"}) {
        EXPECT_GT(hardErrorsOf(subject, silhouette, Fault::WrongFacing), 0u) << silhouette;
    }
}

}  // namespace
}  // namespace umbrage::test
