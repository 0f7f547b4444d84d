// SPDX-License-Identifier: Apache-2.0
// Figures of made-up verdicts, radiance errors, and names of techniques.
#include "judge/verdict.h"

#include <gmock/gmock.h>

#include <cmath>

#include "error.h"
#include "judge/components.h"
#include "judge/judge.h"
#include "judge/tolerance.h"
#include "judge/verify.h"

namespace umbrage {
namespace {

/// Shows linear values as they are, from 0 to 1.
class Linear : public DisplayTransform {
public:
    void apply(std::span<float> rgba) const override {
        for (std::size_t i = 0; i < rgba.size(); ++i) {
            if (i % 4 != 3) rgba[i] = std::clamp(rgba[i], 0.0f, 1.0f);
        }
    }
    std::string description() const override { return "linear"; }
    std::string cacheId() const override { return "linear"; }
};

TEST(LightVerdict, BiasIsHowFarTheOutlineLiesOutside) {
    LightVerdict light;
    EXPECT_EQ(light.signedBias(), 0.0) << "no outline, no bias";
    light.boundaryLength = 100.0;
    light.bandFalseDark = 3;
    light.hardFalseDark = 4;
    EXPECT_DOUBLE_EQ(light.signedBias(), 0.07);
    light.bandFalseLit = 9;
    light.hardFalseLit = 1;
    EXPECT_DOUBLE_EQ(light.signedBias(), -0.03);
}

TEST(LightVerdict, HardAndBandAreToldApart) {
    LightVerdict light;
    EXPECT_EQ(light.bandRate(), 0.0) << "nothing faces the light";
    light.litFacing = 1000;
    light.primary = 1;
    light.grazing = 2;
    light.boundary = 3;
    light.hardFalseDark = 10;
    light.hardFalseLit = 20;
    EXPECT_EQ(light.band(), 6u);
    EXPECT_EQ(light.hard(), 30u);
    EXPECT_DOUBLE_EQ(light.bandRate(), 0.006);
    for (const SampleVerdict v :
         {SampleVerdict::Right, SampleVerdict::Primary, SampleVerdict::Grazing, SampleVerdict::Boundary}) {
        EXPECT_FALSE(isHard(v));
    }
    EXPECT_TRUE(isHard(SampleVerdict::FalseDark));
    EXPECT_TRUE(isHard(SampleVerdict::FalseLit));
}

TEST(FrameVerdict, SumsItsLights) {
    FrameVerdict frame;
    EXPECT_EQ(frame.hard(), 0u);
    frame.lights.resize(2);
    frame.lights[0].hardFalseDark = 1;
    frame.lights[1].hardFalseLit = 2;
    frame.lights[1].hardCountErrors = 5;
    EXPECT_EQ(frame.hard(), 3u);
    EXPECT_EQ(frame.hardCounts(), 5u);
}

TEST(Tolerance, FollowsTheDevicesGrid) {
    EXPECT_EQ(toleranceOf(8).lateralPixels, 1.0 / 128);
    EXPECT_EQ(toleranceOf(4).lateralPixels, 1.0 / 8);
}

TEST(Techniques, AreNamedBySilhouetteAndCount) {
    ASSERT_FALSE(allTechniques().empty());
    EXPECT_EQ(allTechniques().front().name(), "compute:z-pass") << "the default pair is the first of all";
    EXPECT_EQ(parseTechniques("all").size(), allTechniques().size());
    const std::vector<Technique> two = parseTechniques("cpu:z-fail,compute:z-pass");
    ASSERT_EQ(two.size(), 2u);
    EXPECT_EQ(two[0].silhouette, "cpu");
    EXPECT_EQ(two[0].count, "z-fail");
    EXPECT_EQ(two[1].name(), "compute:z-pass");
}

TEST(Techniques, UnknownOnesAreUsageErrorsThatListTheNames) {
    for (const char* text : {"", ",", "cpu", "cpu:z-pass,", "z-pass:cpu", "all,cpu:z-pass"}) {
        try {
            parseTechniques(text);
            ADD_FAILURE() << '"' << text << "\" was taken";
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::Usage);
            EXPECT_THAT(error.what(), testing::HasSubstr("compute:z-pass"));
        }
    }
}

TEST(CompareRadiance, EqualPicturesHaveNoError) {
    const std::vector<float> picture{0.1f, 0.2f, 3.0f, 1.0f};
    const RadianceError error = compareRadiance(picture, picture, Linear());
    EXPECT_EQ(error.largest, 0.0);
    EXPECT_EQ(error.rms, 0.0);
    EXPECT_EQ(error.largestCode, 0);
    EXPECT_EQ(error.rmsCode, 0.0);
}

TEST(CompareRadiance, GoesOverAllColoursAndLeavesAlphaOut) {
    const std::vector<float> exact{0.0f, 0.0f, 0.0f, 1.0f, 1.0f, 1.0f, 5.0f, 1.0f};
    const std::vector<float> other{0.0f, 0.6f, 0.0f, 0.0f, 1.0f, 1.0f, 2.0f, 1.0f};
    const RadianceError error = compareRadiance(other, exact, Linear());
    EXPECT_FLOAT_EQ(float(error.largest), 3.0f);
    EXPECT_NEAR(error.rms, std::sqrt((0.36 + 9.0) / 6.0), 1e-6);
    EXPECT_EQ(error.largestCode, 153) << "5 and 2 look the same";
    EXPECT_NEAR(error.rmsCode, 153.0 / std::sqrt(6.0), 1e-9);
}

TEST(CompareRadiance, APictureThatIsNoNumberSomewhereIsNotRight) {
    const std::vector<float> exact{0.1f, 0.1f, 0.1f, 1.0f};
    std::vector<float> broken = exact;
    broken[1] = std::nanf("");
    EXPECT_FALSE(compareRadiance(broken, exact, Linear()).largest < 1e30);
    broken[1] = INFINITY;
    EXPECT_FALSE(compareRadiance(broken, exact, Linear()).largest < 1e30);
}

std::vector<bool> marked(const std::string& picture) {
    std::vector<bool> marks;
    for (const char c : picture) marks.push_back(c == '#');
    return marks;
}

TEST(Components, HangTogetherThroughCornersAndNotThroughTheFramesEdge) {
    const Component diagonal = largestComponent(marked("#...#"
                                                       ".#..."
                                                       "..#.."),
                                                5, 3);
    EXPECT_EQ(diagonal.pixels, 3u);
    EXPECT_EQ(diagonal.extent, 3);
    const Component ends = largestComponent(marked("....#"
                                                   "#...."),
                                            5, 2);
    EXPECT_EQ(ends.pixels, 1u);
    EXPECT_EQ(largestComponent(marked("......"), 3, 2).pixels, 0u);
}

TEST(Components, TheExtentIsTheLongerSideOfTheLargest) {
    const Component streak = largestComponent(marked("#######."
                                                     "........"
                                                     ".##....."
                                                     ".##....."),
                                              8, 4);
    EXPECT_EQ(streak.pixels, 7u);
    EXPECT_EQ(streak.extent, 7);
}

}  // namespace
}  // namespace umbrage
