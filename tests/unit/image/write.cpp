// SPDX-License-Identifier: Apache-2.0
#define IMATH_HALF_NO_LOOKUP_TABLE  // the table is in a library that nothing else here needs
#include <Imath/half.h>
#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "error.h"
#include "image/image.h"
#include "pictures.h"

namespace umbrage {
namespace {

using test::Bytes;
using test::TemporaryFolder;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// One interleaved float image; the vector must outlive it.
ImageFile floatImage(int width, int height, const std::vector<std::string>& names, PixelType type,
                     const std::vector<float>& values) {
    ImageFile image{width, height, {}, {}};
    for (std::size_t c = 0; c < names.size(); ++c) {
        image.channels.push_back({names[c], type, values.data() + c, static_cast<int>(names.size())});
    }
    return image;
}

std::vector<std::string> pngNames(std::size_t channelCount) {
    const std::vector<std::string> names[] = {{"Y"}, {"Y", "A"}, {"R", "G", "B"}, {"R", "G", "B", "A"}};
    return names[channelCount - 1];
}

DecodedImage decodeFile(const std::filesystem::path& file) {
    return codec().decode(test::asSpan(test::readBytes(file)), file.string());
}

std::string textOf(const std::filesystem::path& file) {
    const Bytes bytes = test::readBytes(file);
    return {bytes.begin(), bytes.end()};
}

void expectRefused(const std::filesystem::path& file, const ImageFile& image, const std::string& part) {
    try {
        codec().write(file, image);
        ADD_FAILURE() << "was written";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::Output);
        EXPECT_EQ(error.where(), file.string());
        EXPECT_THAT(error.what(), HasSubstr(part));
    }
    EXPECT_FALSE(std::filesystem::exists(file));
}

TEST(WritePng, EveryCodeOf8And16BitsSurvivesInEveryNumberOfChannels) {
    const TemporaryFolder folder;
    for (const PixelType type : {PixelType::UInt8, PixelType::UInt16}) {
        const int codes = type == PixelType::UInt8 ? 256 : 65536;
        for (std::size_t channelCount = 1; channelCount <= 4; ++channelCount) {
            std::vector<float> values(std::size_t(codes) * channelCount);
            for (std::size_t i = 0; i < values.size(); ++i) {
                values[i] = static_cast<float>(i * 7 % codes) / static_cast<float>(codes - 1);
            }
            codec().write(folder / "codes.png", floatImage(256, codes / 256, pngNames(channelCount), type, values));
            const auto image = decodeFile(folder / "codes.png");
            ASSERT_EQ(image.type, type);
            ASSERT_EQ(image.channelCount, static_cast<int>(channelCount));
            for (std::size_t i = 0; i < values.size(); ++i) {
                std::uint16_t code = 0;
                std::memcpy(&code, &image.pixels[i * (codes > 256 ? 2 : 1)], codes > 256 ? 2 : 1);
                ASSERT_EQ(code, i * 7 % codes) << i;
            }
        }
    }
}

TEST(WritePng, HalvesRoundUpAndTheRestIsClamped) {
    const TemporaryFolder folder;
    const std::vector<float> values{0.5f / 255, 0.499f / 255, 1.5f / 255, 0.5f, -3.0f, 7.0f, -0.0f};
    codec().write(folder / "round.png", floatImage(7, 1, {"Y"}, PixelType::UInt8, values));
    const auto image = decodeFile(folder / "round.png");
    std::vector<int> codes;
    for (const std::byte byte : image.pixels) codes.push_back(std::to_integer<int>(byte));
    EXPECT_THAT(codes, ElementsAre(1, 0, 2, 128, 0, 255, 0));
}

TEST(WritePng, BytesAreStoredAsTheyAre) {
    const TemporaryFolder folder;
    const Bytes rgb{1, 2, 3, 253, 254, 255};
    ImageFile image{2, 1, {}, {}};
    for (int c = 0; c < 3; ++c) image.channels.push_back({pngNames(3)[c], PixelType::UInt8, rgb.data() + c, 3});
    codec().write(folder / "bytes.png", image);
    const auto decoded = decodeFile(folder / "bytes.png");
    EXPECT_TRUE(std::equal(rgb.begin(), rgb.end(), decoded.pixels.begin(), decoded.pixels.end(),
                           [](std::uint8_t a, std::byte b) { return std::byte{a} == b; }));
}

TEST(WritePng, IsTaggedSrgbAndHoldsItsMetadataAsText) {
    const TemporaryFolder folder;
    const std::vector<float> values(3, 0.5f);
    ImageFile image = floatImage(1, 1, pngNames(3), PixelType::UInt8, values);
    image.metadata = {{"umbrage:camera", "/Courtyard/Cam"}, {"umbrage:exposure", 1.5}, {"umbrage:samples", 4}};
    codec().write(folder / "tags.png", image);
    const std::string text = textOf(folder / "tags.png");
    EXPECT_THAT(text, HasSubstr("sRGB"));
    EXPECT_THAT(text, HasSubstr(std::string("umbrage:camera\0/Courtyard/Cam", 29)));
    EXPECT_THAT(text, HasSubstr(std::string("umbrage:exposure\0"
                                            "1.5",
                                            20)));
    EXPECT_THAT(text, HasSubstr(std::string("umbrage:samples\0"
                                            "4",
                                            17)));
}

TEST(WritePng, RefusesNanAndInfinityAndSaysWhere) {
    const TemporaryFolder folder;
    for (const float bad : {kNan, kInfinity, -kInfinity}) {
        std::vector<float> values(3 * 12, 0.25f);
        values[3 * 7 + 1] = bad;  // (3, 1) of 4x3, green
        for (const PixelType type : {PixelType::UInt8, PixelType::UInt16}) {
            expectRefused(folder / "bad.png", floatImage(4, 3, pngNames(3), type, values), "channel G");
            expectRefused(folder / "bad.png", floatImage(4, 3, pngNames(3), type, values), "pixel (3, 1)");
        }
    }
    EXPECT_EQ(folder.entryCount(), 0u);
}

TEST(WritePng, RefusesWhatPngCannotHold) {
    const TemporaryFolder folder;
    const std::vector<float> values(5, 0.5f);
    const std::uint32_t integer = 7;
    expectRefused(folder / "five.png", floatImage(1, 1, {"a", "b", "c", "d", "e"}, PixelType::UInt8, values), "PNG");
    expectRefused(folder / "half.png", floatImage(1, 1, {"Y"}, PixelType::Half, values), "PNG");
    expectRefused(folder / "uint.png", {1, 1, {{"Y", PixelType::UInt32, &integer, 1}}, {}}, "PNG");
    expectRefused(folder / "mixed.png",
                  {1, 1, {{"Y", PixelType::UInt8, values.data()}, {"A", PixelType::UInt16, values.data()}}, {}}, "PNG");
}

TEST(WriteExr, HalfFloatAndUintChannelsKeepTheirTypesNamesAndValues) {
    const TemporaryFolder folder;
    const std::vector<float> rgba{0.1f, 2.0f, -3.0f, 1.0f, 1e-7f, 70000.0f, kNan, 0.5f};
    const std::vector<float> depth{1234.56789f, kInfinity};
    const std::vector<std::uint32_t> counts{0xFFFFFFFFu, 16777217u};
    ImageFile image = floatImage(2, 1, {"R", "G", "B", "A"}, PixelType::Half, rgba);
    image.channels.push_back({"Z", PixelType::Float, depth.data(), 1});
    image.channels.push_back({"stencil.Lamp", PixelType::UInt32, counts.data(), 1});
    image.channels.push_back({"N.X", PixelType::Half, depth.data(), 1});
    codec().write(folder / "mixed.exr", image);

    const auto exr = test::readExr(folder / "mixed.exr");
    const auto halfAt = [&](const char* name, int x) {
        return static_cast<float>(exr.value<half>(name, OIIO::TypeDesc::HALF, x, 0));
    };
    ASSERT_EQ(exr.spec.nchannels, 7);
    EXPECT_EQ(halfAt("R", 0), static_cast<float>(half(0.1f)));
    EXPECT_EQ(halfAt("B", 0), -3.0f);
    EXPECT_EQ(halfAt("G", 1), 65504.0f) << "finite values must stay finite";
    EXPECT_TRUE(std::isnan(halfAt("B", 1)));
    EXPECT_EQ(halfAt("A", 1), 0.5f);
    EXPECT_EQ(exr.value<float>("Z", OIIO::TypeDesc::FLOAT, 0, 0), 1234.56789f);
    EXPECT_EQ(exr.value<float>("Z", OIIO::TypeDesc::FLOAT, 1, 0), kInfinity);
    EXPECT_EQ(exr.value<std::uint32_t>("stencil.Lamp", OIIO::TypeDesc::UINT32, 0, 0), 0xFFFFFFFFu);
    EXPECT_EQ(exr.value<std::uint32_t>("stencil.Lamp", OIIO::TypeDesc::UINT32, 1, 0), 16777217u);
    EXPECT_EQ(halfAt("N.X", 1), kInfinity);
}

TEST(WriteExr, HoldsManyChannels) {
    const TemporaryFolder folder;
    const std::vector<float> values{3.0f, 1.0f, 4.0f, 1.0f};
    ImageFile image{2, 2, {}, {}};
    for (int i = 0; i < 70; ++i) {
        image.channels.push_back({"shadow.Lamp_" + std::to_string(i), PixelType::Half, values.data(), 1});
    }
    codec().write(folder / "many.exr", image);
    const auto exr = test::readExr(folder / "many.exr");
    EXPECT_EQ(exr.spec.nchannels, 70);
    EXPECT_EQ(static_cast<float>(exr.value<half>("shadow.Lamp_69", OIIO::TypeDesc::HALF, 0, 1)), 4.0f);
}

TEST(WriteExr, CarriesColourSpaceAndMetadata) {
    const TemporaryFolder folder;
    const std::vector<float> values(3, 0.5f);
    ImageFile image = floatImage(1, 1, pngNames(3), PixelType::Half, values);
    image.metadata = {{"umbrage:camera", "/Courtyard/Cam"}, {"umbrage:exposure", 1.1}, {"umbrage:samples", 4}};
    codec().write(folder / "tags.exr", image);
    const auto spec = test::readExr(folder / "tags.exr").spec;
    EXPECT_EQ(spec.get_string_attribute("umbrage:camera"), "/Courtyard/Cam");
    EXPECT_EQ(spec.get_int_attribute("umbrage:samples"), 4);
    const auto* exposure = spec.find_attribute("umbrage:exposure");
    ASSERT_TRUE(exposure);
    EXPECT_EQ(exposure->type(), OIIO::TypeDesc(OIIO::TypeDesc::DOUBLE));
    EXPECT_EQ(exposure->get<double>(), 1.1);
    EXPECT_EQ(spec.get_string_attribute("colorInteropID"), "lin_rec709_scene");
    const auto* chromaticities = spec.find_attribute("chromaticities");
    ASSERT_TRUE(chromaticities);
    EXPECT_FLOAT_EQ(chromaticities->get_float_indexed(0), 0.64f);
    EXPECT_FLOAT_EQ(chromaticities->get_float_indexed(7), 0.329f);
}

TEST(WriteExr, DataHasNoChromaticities) {
    const TemporaryFolder folder;
    const std::vector<float> values{1.0f};
    codec().write(folder / "depth.exr", floatImage(1, 1, {"Z"}, PixelType::Float, values));
    const auto spec = test::readExr(folder / "depth.exr").spec;
    EXPECT_EQ(spec.get_string_attribute("colorInteropID"), "data");
    EXPECT_FALSE(spec.find_attribute("chromaticities"));
}

TEST(WriteExr, RefusesTypesItDoesNotHave) {
    const TemporaryFolder folder;
    const std::vector<float> values{1.0f};
    const std::uint8_t byte = 1;
    expectRefused(folder / "x.exr", floatImage(1, 1, {"Y"}, PixelType::UInt8, values), "channel Y");
    expectRefused(folder / "x.exr", floatImage(1, 1, {"Y"}, PixelType::UInt32, values), "channel Y");
    expectRefused(folder / "x.exr", {1, 1, {{"Y", PixelType::UInt8, &byte, 1}}, {}}, "channel Y");
}

TEST(Write, EqualImagesAreEqualBytesWithoutTimeOrHost) {
    const TemporaryFolder folder;
    std::vector<float> values(64 * 64 * 3);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<float>(i % 251) / 251.0f;
    for (const std::string kind : {"png", "exr"}) {
        const PixelType type = kind == "png" ? PixelType::UInt8 : PixelType::Half;
        ImageFile image = floatImage(64, 64, pngNames(3), type, values);
        image.metadata = {{"Software", "umbrage"}};
        codec().write(folder / ("one." + kind), image);
        codec().write(folder / ("two." + kind), image);
        EXPECT_EQ(test::readBytes(folder / ("one." + kind)), test::readBytes(folder / ("two." + kind)));
        const std::string text = textOf(folder / ("one." + kind));
        for (const char* stamp : {"capDate", "DateTime", "tIME", "HostComputer"})
            EXPECT_THAT(text, Not(HasSubstr(stamp)));
    }
}

TEST(Write, RefusesNothingTwinsAndUnknownKinds) {
    const TemporaryFolder folder;
    const std::vector<float> values{1.0f, 1.0f};
    for (const char* name : {"a.png", "a.exr"}) {
        expectRefused(folder / name, {1, 1, {}, {}}, "nothing to write");
        expectRefused(folder / name, {0, 1, {{"Y", PixelType::UInt8, values.data(), 1}}, {}}, "nothing to write");
        expectRefused(folder / name, floatImage(1, 1, {"Y", "Y"}, PixelType::UInt8, values), "two channels called 'Y'");
    }
    expectRefused(folder / "a.jpg", floatImage(1, 1, {"Y"}, PixelType::UInt8, values), ".jpg");
}

TEST(Write, MakesTheFolder) {
    const TemporaryFolder folder;
    const std::vector<float> values{1.0f};
    codec().write(folder / "a/b/c.png", floatImage(1, 1, {"Y"}, PixelType::UInt8, values));
    EXPECT_TRUE(std::filesystem::exists(folder / "a/b/c.png"));
}

}  // namespace
}  // namespace umbrage
