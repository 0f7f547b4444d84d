// SPDX-License-Identifier: Apache-2.0
// Agreement with Debian's idiff on what it gets right: pictures of one size, with the same channels, all of them finite
// and without alpha, by which it would multiply a PNG's colours first.
#include <gmock/gmock.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <regex>

#include "golden/metrics.h"
#include "stored.h"

namespace umbrage {
namespace {

namespace fs = std::filesystem;

class Idiff : public testing::Test {
protected:
    void SetUp() override {
        if (std::system("idiff --help > /dev/null 2>&1") != 0) GTEST_SKIP() << "idiff is missing (packages.txt)";
        std::string name = (fs::temp_directory_path() / "umbrage-idiff-XXXXXX").string();
        ASSERT_NE(mkdtemp(name.data()), nullptr);
        folder_ = name;
    }
    void TearDown() override {
        if (!folder_.empty()) fs::remove_all(folder_);
    }

    /// Two pictures of the same seeded noise, the second with some of its values moved; written, and read by us.
    void makePair(const std::string& extension, PixelType type, const std::vector<std::string>& names,
                  float brightest) {
        golden_ = folder_ / ("golden." + extension);
        output_ = folder_ / ("output." + extension);
        std::mt19937 random(31);
        const auto noise = [&] { return float(random() % 65536) / 65536.0f; };
        std::vector<float> values(std::size_t(kWidth) * kHeight * names.size());
        for (float& value : values) value = brightest * noise();
        write(golden_, type, names, values);
        for (float& value : values) {
            if (random() % 5 == 0) value = std::min(brightest, value + 0.2f * brightest * noise());
        }
        write(output_, type, names, values);
    }

    double figure(const std::string& name, double tolerance = 0.0) const {
        const Measured measured = this->measured(name, tolerance);
        EXPECT_EQ(measured.figures.size(), 1u);
        return measured.figures.front().value;
    }
    Measured measured(const std::string& name, double tolerance = 0.0) const {
        return measure(codec().read(golden_), codec().read(output_), {.tolerance = tolerance}, std::vector{name});
    }

    std::string idiff(const std::string& options) const {
        const std::string command = "idiff " + options + " " + golden_.string() + " " + output_.string() + " 2>&1";
        std::FILE* pipe = ::popen(command.c_str(), "r");
        std::string text;
        std::array<char, 4096> part;
        while (const std::size_t count = std::fread(part.data(), 1, part.size(), pipe)) text.append(part.data(), count);
        ::pclose(pipe);
        return text;
    }

    static double number(const std::string& text, const std::string& pattern) {
        std::smatch match;
        const bool found = std::regex_search(text, match, std::regex(pattern));
        EXPECT_TRUE(found) << pattern << " in\n" << text;
        return found ? std::stod(match[1]) : -1.0;
    }

    void expectAgreement(double tolerance) const {
        constexpr double kPrinted = 2e-5;  // idiff prints six digits
        const std::string text = idiff("-fail " + std::to_string(tolerance));
        const auto expectNear = [&](double ours, const std::string& pattern) {
            const double theirs = number(text, pattern);
            EXPECT_GT(theirs, 0.0);
            EXPECT_NEAR(ours, theirs, kPrinted * theirs) << pattern;
        };
        expectNear(figure("mean-abs"), "Mean error = (\\S+)");
        expectNear(figure("rmse"), "RMS error = (\\S+)");
        expectNear(figure("psnr"), "Peak SNR = (\\S+)");
        expectNear(figure("max-abs"), "Max error  = (\\S+)");
        EXPECT_EQ(std::lround(figure("fraction", tolerance) * kWidth * kHeight),
                  number(text, "(\\d+) pixels \\(\\S+ over " + std::string(std::to_string(tolerance).substr(0, 4))));
    }

    static constexpr int kWidth = 61, kHeight = 47;
    fs::path folder_, golden_, output_;

private:
    static void write(const fs::path& file, PixelType type, const std::vector<std::string>& names,
                      const std::vector<float>& values) {
        ImageFile image{kWidth, kHeight, {}, {}};
        for (std::size_t c = 0; c < names.size(); ++c) {
            image.channels.push_back({names[c], type, values.data() + c, int(names.size())});
        }
        codec().write(file, image);
    }
};

TEST_F(Idiff, AgreesOnPng) {
    makePair("png", PixelType::UInt8, {"R", "G", "B"}, 1.0f);
    expectAgreement(0.05);
    makePair("png", PixelType::UInt16, {"R", "G", "B"}, 1.0f);
    expectAgreement(0.05);
    makePair("png", PixelType::UInt8, {"Y"}, 1.0f);
    expectAgreement(0.15);
}

TEST_F(Idiff, AgreesOnExr) {
    makePair("exr", PixelType::Float, {"R", "G", "B", "Z"}, 1.0f);
    expectAgreement(0.05);
    const auto [x, y] = measured("max-abs").worst;  // in other pictures several pixels may differ alike
    EXPECT_EQ(x, number(idiff(""), "@ \\((\\d+),"));
    EXPECT_EQ(y, number(idiff(""), "@ \\(\\d+, (\\d+)"));
    makePair("exr", PixelType::Half, {"N.X", "N.Y", "N.Z"}, 1.0f);
    expectAgreement(0.15);
}

TEST_F(Idiff, AgreesOnYee) {
    makePair("exr", PixelType::Float, {"R", "G", "B"}, 1.0f);
    const double theirs = number(idiff("-p"), "(\\d+) pixels \\(\\S+ failed the perceptual test");
    EXPECT_GT(theirs, 0.0);
    EXPECT_LT(theirs, kWidth * kHeight);
    EXPECT_EQ(std::lround(figure("yee") * kWidth * kHeight), theirs);
}

// What it gets wrong, and why our figures are not OpenImageIO's. (idiff 2.4 calls this pair equal.)
TEST_F(Idiff, IsNotFollowedWhereAllIsNan) {
    makePair("exr", PixelType::Float, {"Z"}, 1.0f);
    const std::vector<float> nans(std::size_t(kWidth) * kHeight, std::numeric_limits<float>::quiet_NaN());
    codec().write(output_, {kWidth, kHeight, {{"Z", PixelType::Float, nans.data(), 1}}, {}});
    EXPECT_EQ(figure("max-abs"), std::numeric_limits<double>::infinity());
    EXPECT_EQ(figure("fraction", 1e30), 1.0);
}

}  // namespace
}  // namespace umbrage
