// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <cstring>
#include <functional>

#include "error.h"
#include "image/image.h"
#include "pictures.h"

namespace umbrage {
namespace {

using test::Bytes;
using testing::ElementsAre;
using testing::HasSubstr;

DecodedImage decode(const Bytes& bytes) {
    return codec().decode(test::asSpan(bytes), "picture.bin");
}

std::vector<int> bytesOf(const DecodedImage& image) {
    std::vector<int> values;
    for (const std::byte byte : image.pixels) values.push_back(std::to_integer<int>(byte));
    return values;
}

void expectRefused(const Bytes& bytes, const std::string& part) {
    try {
        decode(bytes);
        ADD_FAILURE() << "was decoded";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::Input);
        EXPECT_EQ(error.where(), "picture.bin");
        EXPECT_THAT(error.what(), HasSubstr(part));
    }
}

// A gradient with structure, which all three formats can hold.
Bytes gradient(int width, int height, int channelCount) {
    Bytes pixels;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            for (int c = 0; c < channelCount; ++c)
                pixels.push_back(static_cast<std::uint8_t>(40 + 5 * x + 3 * y + 20 * c));
        }
    }
    return pixels;
}

TEST(Decode, RgbPngKeepsEveryByte) {
    const auto image = decode(test::makePng({.width = 2, .rows = {0, 1, 2, 3, 254, 255, 0}}));
    EXPECT_EQ(image.width, 2);
    EXPECT_EQ(image.height, 1);
    EXPECT_EQ(image.channelCount, 3);
    EXPECT_EQ(image.type, PixelType::UInt8);
    EXPECT_THAT(bytesOf(image), ElementsAre(1, 2, 3, 254, 255, 0));
}

TEST(Decode, RowsComeFromTheTop) {
    const auto image = decode(test::makePng({.height = 2, .colorType = 0, .rows = {0, 10, 0, 20}}));
    EXPECT_THAT(bytesOf(image), ElementsAre(10, 20));
}

TEST(Decode, ColourUnderTransparencyIsNotPremultiplied) {
    const auto image = decode(test::makePng({.width = 2, .colorType = 6, .rows = {0, 200, 100, 50, 0, 9, 8, 7, 128}}));
    EXPECT_EQ(image.channelCount, 4);
    EXPECT_THAT(bytesOf(image), ElementsAre(200, 100, 50, 0, 9, 8, 7, 128));
}

TEST(Decode, SixteenBitsStaySixteen) {
    const auto image =
        decode(test::makePng({.bitDepth = 16, .colorType = 6, .rows = {0, 0x12, 0x34, 0, 1, 0xFF, 0xFE, 0, 2}}));
    ASSERT_EQ(image.type, PixelType::UInt16);
    ASSERT_EQ(image.pixels.size(), 8u);
    std::uint16_t values[4];
    std::memcpy(values, image.pixels.data(), sizeof values);
    EXPECT_THAT(values, ElementsAre(0x1234, 0x0001, 0xFFFE, 0x0002));
}

TEST(Decode, GreyAndAlphaAreTwoChannels) {
    const auto image = decode(test::makePng({.width = 2, .colorType = 4, .rows = {0, 77, 0, 33, 255}}));
    EXPECT_EQ(image.channelCount, 2);
    EXPECT_THAT(bytesOf(image), ElementsAre(77, 0, 33, 255));
}

TEST(Decode, OneBitGreyBecomesBlackAndWhite) {
    const auto image = decode(test::makePng({.width = 4, .bitDepth = 1, .colorType = 0, .rows = {0, 0b10100000}}));
    EXPECT_EQ(image.channelCount, 1);
    EXPECT_THAT(bytesOf(image), ElementsAre(255, 0, 255, 0));
}

TEST(Decode, PaletteIsLookedUp) {
    const auto image = decode(test::makePng(
        {.width = 2, .bitDepth = 1, .colorType = 3, .rows = {0, 0b01000000}, .palette = {9, 8, 7, 200, 100, 50}}));
    EXPECT_EQ(image.channelCount, 3);
    EXPECT_THAT(bytesOf(image), ElementsAre(9, 8, 7, 200, 100, 50));
}

TEST(Decode, TransparentPaletteKeepsItsColours) {
    const auto image = decode(test::makePng({.width = 2,
                                             .bitDepth = 8,
                                             .colorType = 3,
                                             .rows = {0, 0, 1},
                                             .palette = {9, 8, 7, 200, 100, 50},
                                             .transparency = {0, 128}}));
    EXPECT_EQ(image.channelCount, 4);
    EXPECT_THAT(bytesOf(image), ElementsAre(9, 8, 7, 0, 200, 100, 50, 128));
}

TEST(Decode, AGammaChunkChangesNothing) {
    const Bytes linear{0, 1, 0x86, 0xA0};  // 1.0
    const auto image = decode(test::makePng({.rows = {0, 100, 150, 200}, .gamma = linear}));
    EXPECT_THAT(bytesOf(image), ElementsAre(100, 150, 200));
}

TEST(Decode, JpegIsCloseToItsSource) {
    for (const int channelCount : {1, 3}) {
        const Bytes source = gradient(24, 16, channelCount);
        const auto image = decode(test::encodeWithOiio("jpeg", 24, 16, channelCount, source, "jpeg:98"));
        ASSERT_EQ(image.channelCount, channelCount);
        ASSERT_EQ(image.pixels.size(), source.size());
        for (std::size_t i = 0; i < source.size(); ++i) {
            ASSERT_NEAR(std::to_integer<int>(image.pixels[i]), source[i], 12) << i;
        }
    }
}

TEST(Decode, JpegOrientationIsNotApplied) {
    const auto image = decode(test::encodeWithOiio("jpeg", 24, 16, 3, gradient(24, 16, 3), "", 6));
    EXPECT_EQ(image.width, 24);
    EXPECT_EQ(image.height, 16);
}

TEST(Decode, LosslessWebpKeepsColourUnderAlpha) {
    for (const bool extended : {false, true}) {
        for (const int alpha : {0, 1, 100, 255}) {
            const auto image = decode(test::makeWebp({180, 90, 40, static_cast<std::uint8_t>(alpha)}, 7, extended));
            EXPECT_EQ(image.width, 2);
            EXPECT_EQ(image.channelCount, 4);
            EXPECT_THAT(bytesOf(image), ElementsAre(180, 90, 40, alpha, 180, 7, 40, alpha)) << extended;
        }
    }
}

TEST(Decode, LossyWebpIsNotPremultiplied) {
    Bytes source;
    for (int i = 0; i < 32 * 32; ++i) source.insert(source.end(), {128, 128, 128, 128});
    const auto image = decode(test::encodeWithOiio("webp", 32, 32, 4, source, "webp:90"));
    ASSERT_EQ(image.channelCount, 4);
    // The writer divided by alpha: sRGB 128 is 0.216 linear, by 0.502 is 0.430, which is sRGB 175.
    for (std::size_t i = 0; i < source.size(); ++i) {
        ASSERT_NEAR(std::to_integer<int>(image.pixels[i]), i % 4 == 3 ? 128 : 175, 4) << i;
    }
}

TEST(Decode, LossyWebpHasThreeChannels) {
    const auto image = decode(test::encodeWithOiio("webp", 24, 16, 3, gradient(24, 16, 3), "webp:90"));
    EXPECT_EQ(image.width, 24);
    EXPECT_EQ(image.height, 16);
    EXPECT_EQ(image.channelCount, 3);
}

struct Sample {
    std::string name;
    Bytes bytes;
};

std::vector<Sample> oneOfEach() {
    Bytes rows;
    for (int y = 0; y < 16; ++y) {
        rows.push_back(0);
        for (int x = 0; x < 24 * 4; ++x) rows.push_back(static_cast<std::uint8_t>(x * 3 + y));
    }
    return {{"png", test::makePng({.width = 24, .height = 16, .colorType = 6, .rows = rows})},
            {"jpeg", test::encodeWithOiio("jpeg", 24, 16, 3, gradient(24, 16, 3))},
            {"webp lossless", test::encodeWithOiio("webp", 24, 16, 4, gradient(24, 16, 4), "lossless")},
            {"webp", test::encodeWithOiio("webp", 24, 16, 3, gradient(24, 16, 3), "webp:80")}};
}

TEST(Decode, APictureCutShortAnywhereIsRefused) {
    for (const Sample& sample : oneOfEach()) {
        const std::size_t end = sample.bytes.size() - (sample.name == "png" ? 4 : 0);  // the end mark's checksum
        for (std::size_t length = 0; length < end; ++length) {
            SCOPED_TRACE(sample.name + " cut at " + std::to_string(length) + " of " + std::to_string(end));
            expectRefused(Bytes(sample.bytes.begin(), sample.bytes.begin() + static_cast<std::ptrdiff_t>(length)),
                          "picture");
        }
    }
}

TEST(Decode, ADamagedByteIsRefusedOrChangesPixelsOnly) {
    for (const Sample& sample : oneOfEach()) {
        for (std::size_t at = 0; at < sample.bytes.size(); ++at) {
            for (const int damage : {0x01, 0x80, 0xFF}) {
                Bytes damaged = sample.bytes;
                damaged[at] = static_cast<std::uint8_t>(damaged[at] ^ damage);
                try {
                    const auto image = decode(damaged);
                    EXPECT_EQ(image.pixels.size(), std::size_t(image.width) * image.height * image.channelCount *
                                                       (image.type == PixelType::UInt16 ? 2 : 1));
                } catch (const Error& error) {
                    EXPECT_EQ(error.kind(), ErrorKind::Input) << sample.name << " at " << at;
                }
            }
        }
    }
}

TEST(Decode, AClaimedSizeThatTheBytesCannotHoldIsRefusedBeforeAnythingIsAllocated) {
    expectRefused(test::makePng({.width = 100000, .height = 100000, .rows = {0}}), "100000x100000");
    expectRefused(test::makePng({.width = 16000, .height = 16000, .rows = {0}}), "cannot hold");

    Bytes jpeg = test::encodeWithOiio("jpeg", 24, 16, 3, gradient(24, 16, 3));
    const Bytes frame{0xFF, 0xC0, 0x00, 0x11, 0x08};
    const auto at = std::search(jpeg.begin(), jpeg.end(), frame.begin(), frame.end());
    ASSERT_NE(at, jpeg.end());
    std::fill_n(at + 5, 4, std::uint8_t{0x3F});
    expectRefused(jpeg, "16191x16191");

    const Bytes webp{'R', 'I', 'F', 'F', 18, 0, 0, 0,    'W',  'E',  'B',  'P',  'V',
                     'P', '8', 'L', 5,   0,  0, 0, 0x2F, 0xFF, 0xFF, 0xFF, 0x0F, 0};
    expectRefused(webp, "16384x16384");
}

TEST(Decode, NoPixelsAreRefused) {
    expectRefused(test::makePng({.width = 0, .rows = {0}}), "no pixels");
}

TEST(Decode, OtherBytesAreRefused) {
    expectRefused({}, "neither PNG, JPEG nor WebP");
    expectRefused({'G', 'I', 'F', '8', '9', 'a', 1, 0, 1, 0}, "neither PNG, JPEG nor WebP");
    expectRefused(Bytes(1000, 0xAB), "neither PNG, JPEG nor WebP");
}

}  // namespace
}  // namespace umbrage
