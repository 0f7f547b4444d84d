// SPDX-License-Identifier: Apache-2.0
// Folders of real files: every outcome, devices, and accepting.
#include "golden/compare_folders.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "error.h"
#include "golden/accept.h"
#include "image/image.h"

namespace umbrage {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class Folders : public testing::Test {
protected:
    void SetUp() override {
        root_ = fs::temp_directory_path() /
                (std::string("umbrage-golden-") + testing::UnitTest::GetInstance()->current_test_info()->name());
        fs::remove_all(root_);
        golden = root_ / "golden";
        output = root_ / "output";
        fs::create_directories(golden);
        fs::create_directories(output);
    }
    void TearDown() override { fs::remove_all(root_); }

    static void write(const fs::path& file, float value, int width = 8, const char* channel = "Y") {
        std::vector<float> values(std::size_t(width) * 8, 0.25f);
        values[9] = value;
        codec().write(file, {width, 8, {{channel, PixelType::Float, values.data(), 1}}, {}});
    }
    static void note(const fs::path& folder, const std::string& renderer,
                     const std::map<std::string, ManifestImage>& images, const std::string& job = "0123456789abcdef") {
        writeManifest(folder, {{renderer, "4.5", "avx2", "0.1.0", job}, images});
    }
    /// name -> outcome
    std::map<std::string, Outcome> outcomes(const CompareOptions& options = {}) const {
        std::map<std::string, Outcome> made;
        for (const ImageResult& image : comparePictures(golden, output, options).images) {
            made[image.name] = image.outcome;
        }
        return made;
    }

    fs::path root_, golden, output;
};

TEST_F(Folders, EveryPictureOfEitherSideHasAnOutcome) {
    for (const char* name : {"same.0001.exr", "sub/same.0002.exr", "other.0001.exr", "gone.0001.exr", "large.0001.exr",
                             "named.0001.exr", "nan.0001.exr", "broken.0001.exr"}) {
        write(golden / name, 0.5f);
        if (std::string(name) != "gone.0001.exr") write(output / name, 0.5f);
    }
    write(output / "other.0001.exr", 0.75f);
    write(output / "large.0001.exr", 0.5f, 9);
    write(output / "named.0001.exr", 0.5f, 8, "Z");
    write(output / "nan.0001.exr", std::nanf(""));
    write(output / "new.0001.exr", 0.5f);
    std::ofstream(output / "broken.0001.exr") << "no picture";
    std::ofstream(output / "notes.txt") << "not compared";
    const auto found = outcomes();
    EXPECT_EQ(found.size(), 9u);
    EXPECT_EQ(found.at("same.0001.exr"), Outcome::Pass);
    EXPECT_EQ(found.at("sub/same.0002.exr"), Outcome::Pass);
    EXPECT_EQ(found.at("other.0001.exr"), Outcome::Fail);
    EXPECT_EQ(found.at("gone.0001.exr"), Outcome::MissingOutput);
    EXPECT_EQ(found.at("large.0001.exr"), Outcome::SizeMismatch);
    EXPECT_EQ(found.at("named.0001.exr"), Outcome::ChannelMismatch);
    EXPECT_EQ(found.at("nan.0001.exr"), Outcome::NonFinite);
    EXPECT_EQ(found.at("new.0001.exr"), Outcome::MissingGolden);
    EXPECT_EQ(found.at("broken.0001.exr"), Outcome::Unreadable);
    const Comparison comparison = comparePictures(golden, output, {});
    EXPECT_FALSE(comparison.passes());
    EXPECT_TRUE(fs::exists(output / "new.0001.exr")) << "the candidate stays";
    EXPECT_THAT(comparison.notes.front(), HasSubstr("no manifest.json"));
}

TEST_F(Folders, WhatTheManifestDoesNotKnowIsExtraAndOtherFramesAreSkipped) {
    for (const char* name : {"a.0001.exr", "a.0002.exr"}) write(golden / name, 0.5f);
    for (const char* name : {"a.0001.exr", "old.0001.exr"}) write(output / name, 0.5f);
    note(golden, "llvmpipe", {{"a.0001.exr", {"a", 1}}, {"a.0002.exr", {"a", 2}}});
    note(output, "llvmpipe", {{"a.0001.exr", {"a", 1}}});
    auto found = outcomes();
    EXPECT_EQ(found.at("a.0001.exr"), Outcome::Pass);
    EXPECT_EQ(found.at("a.0002.exr"), Outcome::MissingOutput);
    EXPECT_EQ(found.at("old.0001.exr"), Outcome::ExtraOutput);
    CompareOptions options;
    options.asked = {{"a.0001.exr", {"a", 1}}};
    EXPECT_EQ(outcomes(options).at("a.0002.exr"), Outcome::Skipped);
}

TEST_F(Folders, NothingIsNoPass) {
    EXPECT_THROW(comparePictures(golden, output, {}), Error);
    EXPECT_THROW(comparePictures(golden / "none", output, {}), Error);
}

TEST_F(Folders, AnotherDeviceIsRefusedOrJudgedByItsPair) {
    write(golden / "a.0001.exr", 0.5f);
    write(output / "a.0001.exr", 0.53f);
    note(golden, "llvmpipe (LLVM 15.0.6, 256 bits)", {{"a.0001.exr", {"a", 1}}});
    note(output, "llvmpipe (LLVM 15.0.6, 128 bits)", {{"a.0001.exr", {"a", 1}}});
    CompareOptions options;
    try {
        comparePictures(golden, output, options);
        FAIL() << "was not refused";
    } catch (const Error& error) {
        EXPECT_THAT(error.message(), HasSubstr("256 bits"));
        EXPECT_THAT(error.message(), HasSubstr("128 bits"));
        EXPECT_THAT(error.hint(), HasSubstr("--other-device"));
    }
    options.otherDevice = true;
    EXPECT_EQ(outcomes(options).at("a.0001.exr"), Outcome::Fail) << "one pixel of 64, by the rules for any pair";
    write(output / "a.0001.exr", 0.51f);
    EXPECT_EQ(outcomes(options).at("a.0001.exr"), Outcome::Pass);
    write(output / "a.0001.exr", 0.5f, 9);
    EXPECT_EQ(outcomes(options).at("a.0001.exr"), Outcome::SizeMismatch) << "gates stay closed";
    write(output / "a.0001.exr", 0.53f);
    GoldenRule strict;
    strict.pattern = "default";
    strict.all = {{{"close", "max-abs", 0.01, {}}}};
    options.rules.devices = {{"llvmpipe*512 bits*", "*", {}}, {"llvmpipe*256 bits*", "llvmpipe*128 bits*", {strict}}};
    const Comparison comparison = comparePictures(golden, output, options);
    EXPECT_TRUE(comparison.foreignDevice);
    EXPECT_EQ(comparison.images[0].outcome, Outcome::Fail);
    EXPECT_EQ(comparison.images[0].decision->rule, "close");
}

TEST_F(Folders, TwoPicturesAreComparedToo) {
    write(golden / "a.exr", 0.5f);
    write(output / "b.exr", 0.5f);
    const Comparison comparison = comparePictures(golden / "a.exr", output / "b.exr", {});
    ASSERT_EQ(comparison.images.size(), 1u);
    EXPECT_EQ(comparison.images[0].outcome, Outcome::Pass);
    EXPECT_THROW(comparePictures(golden, output / "b.exr", {}), Error);
}

TEST_F(Folders, TheNumberOfThreadsChangesNothing) {
    for (int i = 0; i < 20; ++i) {
        const std::string name = "a." + std::to_string(1000 + i) + ".exr";
        write(golden / name, 0.5f);
        write(output / name, i % 3 ? 0.5f : 0.6f);
    }
    CompareOptions one, four;
    one.threads = 1;
    four.threads = 4;
    std::size_t calls = 0;
    four.progress = [&](std::size_t, std::size_t count) { calls += count == 20; };
    EXPECT_EQ(outcomes(one), outcomes(four));
    EXPECT_EQ(calls, 20u);
}

TEST_F(Folders, AcceptingListsWhatChangesAndTouchesNothingElse) {
    for (const char* name : {"same.0001.exr", "changed.0001.exr", "gone.0001.exr"}) write(golden / name, 0.5f);
    for (const char* name : {"same.0001.exr", "new.0001.exr"}) write(output / name, 0.5f);
    write(output / "changed.0001.exr", 0.75f);
    note(output, "llvmpipe",
         {{"same.0001.exr", {"same", 1}}, {"new.0001.exr", {"new", 1}}, {"changed.0001.exr", {"changed", 1}}});
    const auto before = fs::last_write_time(golden / "same.0001.exr");
    const AcceptPlan plan = planAccept(golden, output, {});
    EXPECT_EQ(plan.unchanged, 1u);
    ASSERT_EQ(plan.changes.size(), 3u);
    EXPECT_EQ(plan.changes[0].name, "changed.0001.exr");
    EXPECT_EQ(plan.changes[0].kind, GoldenChange::Kind::Changed);
    EXPECT_THAT(plan.changes[0].difference, HasSubstr("max-abs 0.25"));
    EXPECT_EQ(plan.changes[1].kind, GoldenChange::Kind::Removed);
    EXPECT_EQ(plan.changes[2].kind, GoldenChange::Kind::Added);
    accept(plan);
    EXPECT_TRUE(comparePictures(golden, output, {}).passes());
    EXPECT_EQ(fs::last_write_time(golden / "same.0001.exr"), before);
    EXPECT_FALSE(fs::exists(golden / "gone.0001.exr"));
    EXPECT_EQ(readManifest(golden)->images.size(), 3u);
    EXPECT_TRUE(planAccept(golden, output, {}).changes.empty());
}

TEST_F(Folders, GoldensThatTheJobDoesNotMakeAreKept) {
    for (const char* name : {"a.0001.exr", "a.0002.exr"}) write(golden / name, 0.5f);
    write(output / "a.0001.exr", 0.75f);
    const AcceptPlan plan = planAccept(golden, output, std::map<std::string, ManifestImage>{{"a.0001.exr", {"a", 1}}});
    ASSERT_EQ(plan.changes.size(), 1u);
    accept(plan);
    EXPECT_TRUE(fs::exists(golden / "a.0002.exr"));
}

TEST_F(Folders, AManifestGrowsWithTheSameJobAndStartsAnewWithAnother) {
    const auto with = [](const char* job, const char* image) {
        return Manifest{{"r", "v", "", "0.1.0", job}, {{image, {"a", 1}}}};
    };
    updateManifest(output, with("one", "a.0001.exr"));
    updateManifest(output, with("one", "a.0002.exr"));
    EXPECT_EQ(readManifest(output)->images.size(), 2u);
    updateManifest(output, with("two", "a.0003.exr"));
    EXPECT_EQ(readManifest(output)->images.size(), 1u);
    std::ofstream(output / kManifestName) << "{";
    EXPECT_THROW(readManifest(output), Error);
    updateManifest(output, with("two", "a.0003.exr"));
    EXPECT_EQ(readManifest(output)->from.job, "two");
}

TEST(NamedImage, TellsAovAndFrame) {
    EXPECT_EQ(namedImage("sub/overdraw.0042.exr").aov, "overdraw");
    EXPECT_EQ(namedImage("sub/overdraw.0042.exr").frame, 42);
    EXPECT_EQ(namedImage("shadow.Lamp.0042.exr").aov, "shadow.Lamp");
    EXPECT_EQ(namedImage("picture.png").aov, "");
    EXPECT_EQ(namedImage(".png").aov, "");
    EXPECT_EQ(namedImage("a.99999999999999.png").aov, "");
}

TEST(Fingerprint, DependsOnContentsAndNotOnPlaces) {
    const fs::path root = fs::temp_directory_path() / "umbrage-fingerprint";
    fs::create_directories(root / "a");
    fs::create_directories(root / "b");
    std::ofstream(root / "a/scene.gltf") << "one";
    std::ofstream(root / "b/scene.gltf") << "one";
    const std::vector<fs::path> a{root / "a/scene.gltf"}, b{root / "b/scene.gltf"};
    EXPECT_EQ(fingerprintOf("shape", a, "color"), fingerprintOf("shape", b, "color"));
    EXPECT_NE(fingerprintOf("shape", a, "color"), fingerprintOf("other", a, "color"));
    EXPECT_NE(fingerprintOf("shape", a, "color"), fingerprintOf("shape", a, "other"));
    std::ofstream(root / "b/scene.gltf") << "two";
    EXPECT_NE(fingerprintOf("shape", a, "color"), fingerprintOf("shape", b, "color"));
    fs::remove_all(root);
}

}  // namespace
}  // namespace umbrage
