// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <thread>

#include "error.h"
#include "image/image.h"
#include "pictures.h"

namespace umbrage {
namespace {

using test::TemporaryFolder;
using testing::HasSubstr;
using testing::Not;

// An artist's environment must not decide these tests.
class DisplayTransformTest : public testing::Test {
protected:
    DisplayTransformTest() { unsetenv("OCIO"); }
    ~DisplayTransformTest() override { unsetenv("OCIO"); }
};

std::unique_ptr<DisplayTransform> make(const std::string& view, double exposureStops = 0.0) {
    return codec().displayTransform({"", "sRGB", view, exposureStops});
}

std::array<float, 4> applied(const DisplayTransform& transform, std::array<float, 4> rgba) {
    transform.apply(rgba);
    return rgba;
}

float grey(const DisplayTransform& transform, float value) {
    return applied(transform, {value, value, value, 1})[1];
}

float srgbCurve(float linear) {
    return linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1.0f / 2.4f) - 0.055f;
}

void expectRefused(const ColorRequest& request, const std::vector<std::string>& parts) {
    try {
        codec().displayTransform(request);
        ADD_FAILURE() << "was accepted";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::Input);
        for (const auto& part : parts) EXPECT_THAT(error.what(), HasSubstr(part));
    }
}

// Linear Rec.709 is named, but what the roles say differs from test to test.
std::string smallConfig(const std::string& roles) {
    return "ocio_profile_version: 2.1\nenvironment: {}\nstrictparsing: true\nroles: {default: raw" + roles +
           "}\nfile_rules:\n  - !<Rule> {name: Default, colorspace: raw}\n"
           "displays:\n  Monitor:\n    - !<View> {name: Half, colorspace: half}\n    - !<View> {name: Raw, colorspace: "
           "raw}\n"
           "colorspaces:\n  - !<ColorSpace> {name: reference}\n"
           "  - !<ColorSpace>\n    name: half\n    from_scene_reference: !<MatrixTransform> {matrix: [0.5, 0, 0, 0, 0, "
           "0.5, 0, 0, 0, 0, 0.5, 0, 0, 0, 0, 1]}\n"
           "  - !<ColorSpace> {name: raw, isdata: true}\n";
}

TEST_F(DisplayTransformTest, UntonemappedIsTheSrgbCurve) {
    const auto transform = make("Untonemapped");
    EXPECT_NEAR(grey(*transform, 0.18f), 0.461356f, 2e-6f);
    EXPECT_NEAR(grey(*transform, 1.0f), 1.0f, 2e-6f);
    const auto rgb = applied(*transform, {0.6f, 0.05f, 0.002f, 1.0f});
    EXPECT_NEAR(rgb[0], srgbCurve(0.6f), 1e-5f);
    EXPECT_NEAR(rgb[1], srgbCurve(0.05f), 1e-5f);
    EXPECT_NEAR(rgb[2], srgbCurve(0.002f), 1e-5f);
}

TEST_F(DisplayTransformTest, AcesSdrHasItsPublishedGreyAndWhite) {
    const auto transform = make("ACES SDR");
    EXPECT_NEAR(grey(*transform, 0.18f), 0.355954f, 2e-6f);
    EXPECT_NEAR(grey(*transform, 1.0f), 0.811971f, 2e-6f);
}

TEST_F(DisplayTransformTest, RawShowsTheNumbers) {
    const auto rgb = applied(*make("Raw"), {0.25f, 0.5f, 0.125f, 1.0f});
    EXPECT_EQ(rgb, (std::array{0.25f, 0.5f, 0.125f, 1.0f}));
}

TEST_F(DisplayTransformTest, ResultsAreClamped) {
    for (const char* view : {"ACES SDR", "Untonemapped", "Raw"}) {
        for (const auto& rgba :
             {std::array{1.0f, 0.0f, 0.0f, 1.0f}, {-0.5f, 40.0f, 3.0f, 1.0f}, {1e8f, 0.0f, -1e8f, 1.0f}}) {
            const auto result = applied(*make(view), rgba);
            for (int c = 0; c < 3; ++c) {
                EXPECT_GE(result[c], 0.0f) << view;
                EXPECT_LE(result[c], 1.0f) << view;
            }
        }
    }
}

TEST_F(DisplayTransformTest, ExposureComesFirst) {
    for (const char* view : {"ACES SDR", "Untonemapped", "Raw"}) {
        EXPECT_EQ(grey(*make(view, 2.0), 0.05f), grey(*make(view), 0.2f)) << view;
        EXPECT_EQ(grey(*make(view, -1.0), 0.5f), grey(*make(view), 0.25f)) << view;
    }
    EXPECT_NE(make("Raw", 1.0)->cacheId(), make("Raw")->cacheId());
}

TEST_F(DisplayTransformTest, AlphaIsUntouched) {
    for (const char* view : {"ACES SDR", "Untonemapped", "Raw"}) {
        for (const float alpha : {0.0f, 0.3f, 7.0f}) EXPECT_EQ(applied(*make(view, 1.0), {1, 2, 3, alpha})[3], alpha);
    }
}

TEST_F(DisplayTransformTest, APixelThatIsNotFiniteBecomesNanAndItsNeighboursDoNot) {
    const float bad[] = {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
                         -std::numeric_limits<float>::infinity()};
    for (const char* view : {"ACES SDR", "Untonemapped", "Raw"}) {
        for (const float value : bad) {
            std::array<float, 12> rgba{0.5f, 0.5f, 0.5f, 1, 0.5f, value, 0.5f, 1, 0.5f, 0.5f, 0.5f, 1};
            const auto transform = make(view);
            transform->apply(rgba);
            for (int c = 4; c < 7; ++c) EXPECT_TRUE(std::isnan(rgba[c])) << view;
            EXPECT_EQ(rgba[7], 1.0f);
            EXPECT_EQ(rgba[1], grey(*transform, 0.5f));
            EXPECT_EQ(rgba[9], rgba[1]);
        }
    }
}

TEST_F(DisplayTransformTest, ThreadsAndBlocksGiveTheSamePixels) {
    constexpr std::size_t kPixelCount = 20000;
    const auto transform = make("ACES SDR");
    std::vector<float> whole(kPixelCount * 4);
    for (std::size_t i = 0; i < whole.size(); ++i) whole[i] = static_cast<float>(i * 7919 % 4001) / 2000.0f;
    std::vector<float> parts = whole;
    transform->apply(whole);
    {
        std::vector<std::jthread> threads;
        for (std::size_t first = 0; first < kPixelCount; first += 1237) {
            const std::size_t count = std::min<std::size_t>(1237, kPixelCount - first);
            threads.emplace_back(
                [&, first, count] { transform->apply(std::span(parts).subspan(4 * first, 4 * count)); });
        }
    }
    EXPECT_EQ(parts, whole);
}

TEST_F(DisplayTransformTest, AnEmptyImageIsNoProblem) {
    EXPECT_NO_THROW(make("ACES SDR")->apply({}));
}

TEST_F(DisplayTransformTest, TheShippedFileIsTheBuiltInConfiguration) {
    const std::string path = std::string(UMBRAGE_SOURCE_DIR) + "/configs/umbrage.ocio";
    for (const char* view : {"ACES SDR", "Untonemapped", "Raw"}) {
        const auto fromFile = codec().displayTransform({path, "sRGB", view, 0.0});
        EXPECT_EQ(fromFile->cacheId(), make(view)->cacheId());
        EXPECT_THAT(fromFile->description(), HasSubstr(path));
        EXPECT_THAT(make(view)->description(), HasSubstr("built-in"));
    }
}

TEST_F(DisplayTransformTest, TheRequestWinsOverTheEnvironmentAndThatOverTheBuiltIn) {
    const TemporaryFolder folder;
    const auto environment = (folder / "environment.ocio").string(), requested = (folder / "requested.ocio").string();
    writeWhole(environment, smallConfig(", scene_linear: reference"));
    writeWhole(requested, smallConfig(", scene_linear: half"));
    setenv("OCIO", environment.c_str(), 1);
    EXPECT_THAT(codec().displayTransform({"", "Monitor", "Half", 0.0})->description(),
                HasSubstr("environment.ocio ($OCIO)"));
    EXPECT_THAT(codec().displayTransform({requested, "Monitor", "Half", 0.0})->description(),
                HasSubstr("requested.ocio"));
    setenv("OCIO", "", 1);
    EXPECT_THAT(make("Raw")->description(), HasSubstr("built-in"));
}

TEST_F(DisplayTransformTest, SceneLinearIsTakenForRec709WithoutAnInterchangeRoleAndThatIsSaid) {
    const TemporaryFolder folder;
    const auto path = (folder / "plain.ocio").string();
    writeWhole(path, smallConfig(", scene_linear: reference"));
    const auto transform = codec().displayTransform({path, "Monitor", "Half", 0.0});
    EXPECT_EQ(applied(*transform, {0.5f, 0.25f, 1.0f, 1.0f}), (std::array{0.25f, 0.125f, 0.5f, 1.0f}));
    EXPECT_THAT(transform->description(), HasSubstr("taken for linear Rec.709"));
}

TEST_F(DisplayTransformTest, AnInterchangeRoleIsReachedThroughAces) {
    const TemporaryFolder folder;
    const auto path = (folder / "aces.ocio").string();
    writeWhole(path, smallConfig(", aces_interchange: reference"));
    const auto transform = codec().displayTransform({path, "Monitor", "Half", 0.0});
    const auto red = applied(*transform, {1.0f, 0.0f, 0.0f, 1.0f});  // Rec.709's red in ACES2065-1, halved
    EXPECT_NEAR(red[0], 0.5f * 0.439633f, 2e-5f);
    EXPECT_NEAR(red[1], 0.5f * 0.089776f, 2e-5f);
    EXPECT_NEAR(red[2], 0.5f * 0.017541f, 2e-5f);
    EXPECT_NEAR(grey(*transform, 0.8f), 0.4f, 1e-5f);
    EXPECT_THAT(transform->description(), Not(HasSubstr("taken for")));
}

TEST_F(DisplayTransformTest, EmptyNamesAreTheConfigurationsDefaults) {
    const auto transform = codec().displayTransform({"", "", "", 0.0});
    EXPECT_THAT(transform->description(), HasSubstr("display sRGB, view ACES SDR"));
}

TEST_F(DisplayTransformTest, UnknownNamesListWhatThereIs) {
    expectRefused({"", "P3", "ACES SDR", 0.0}, {"no display 'P3'", "offers: sRGB"});
    expectRefused({"", "sRGB", "Filmic", 0.0}, {"no view", "'Filmic'", "ACES SDR, Untonemapped, Raw"});
}

TEST_F(DisplayTransformTest, AnUnusableConfigurationIsNamed) {
    const TemporaryFolder folder;
    expectRefused({(folder / "missing.ocio").string(), "sRGB", "Raw", 0.0}, {"missing.ocio", "cannot be used"});
    writeWhole(folder / "bad.ocio", "ocio_profile_version: 2.9\n");
    expectRefused({(folder / "bad.ocio").string(), "sRGB", "Raw", 0.0}, {"bad.ocio", "cannot be used"});
    writeWhole(folder / "roleless.ocio", smallConfig(""));
    expectRefused({(folder / "roleless.ocio").string(), "Monitor", "Half", 0.0}, {"aces_interchange", "scene_linear"});
    setenv("OCIO", "/nowhere/studio.ocio", 1);
    expectRefused({"", "sRGB", "Raw", 0.0}, {"/nowhere/studio.ocio ($OCIO)"});
}

}  // namespace
}  // namespace umbrage
