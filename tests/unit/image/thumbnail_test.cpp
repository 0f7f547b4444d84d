// SPDX-License-Identifier: Apache-2.0
#include "image/thumbnail.h"

#include <gmock/gmock.h>

#include "image/canvas.h"

namespace umbrage {
namespace {

using testing::ElementsAre;

TEST(Thumbnail, IsAtMost160WideAndKeepsItsShape) {
    const auto sizeOf = [](int width, int height) {
        const Thumbnail t =
            thumbnailOf(width, height, std::vector<float>(std::size_t(width) * std::size_t(height) * 4));
        EXPECT_EQ(t.rgba.size(), std::size_t(t.width) * std::size_t(t.height) * 4);
        return std::pair(t.width, t.height);
    };
    EXPECT_EQ(sizeOf(1024, 768), std::pair(160, 120));
    EXPECT_EQ(sizeOf(64, 48), std::pair(64, 48));
    EXPECT_EQ(sizeOf(4000, 3), std::pair(160, 1));
    EXPECT_EQ(sizeOf(1, 1), std::pair(1, 1));
    EXPECT_EQ(sizeOf(160, 1000), std::pair(160, 1000));
}

TEST(Thumbnail, EveryPixelCountsOnce) {
    constexpr int kWidth = 400, kHeight = 300;  // 2.5 pixels for one
    std::vector<float> rgba(kWidth * kHeight * 4, 1.0f);
    for (std::size_t i = 0; i < rgba.size(); i += 4) rgba[i] = i / 4 % kWidth < kWidth / 2 ? 0.0f : 1.0f;
    const Thumbnail t = thumbnailOf(kWidth, kHeight, rgba);
    ASSERT_EQ(t.width, 160);
    ASSERT_EQ(t.height, 120);
    for (int x = 0; x < t.width; ++x) EXPECT_EQ(t.rgba[std::size_t(x) * 4], x < 80 ? 0.0f : 1.0f) << x;
    EXPECT_EQ(t.rgba[1], 1.0f);
}

TEST(Thumbnail, AsPngComesBack) {
    Thumbnail t{2, 1, {1.0f, 0.0f, 0.2f, 1.0f, 0.0f, 1.0f, 0.0f, 1.0f}};
    const std::string png = t.png();
    const DecodedImage image = codec().decode(std::as_bytes(std::span(png)), "t.png");
    ASSERT_EQ(image.width, 2);
    ASSERT_EQ(image.channelCount, 3);
    const auto byte = [](int value) { return std::byte(value); };
    EXPECT_THAT(image.pixels, ElementsAre(byte(255), byte(0), byte(51), byte(0), byte(255), byte(0)));
    EXPECT_EQ(thumbnailOf(image).rgba, t.rgba);
}

TEST(Thumbnail, OfAGreyPictureOf16Bits) {
    DecodedImage image{1, 1, 1, PixelType::UInt16, {std::byte(0xff), std::byte(0xff)}};
    EXPECT_THAT(thumbnailOf(image).rgba, ElementsAre(1.0f, 1.0f, 1.0f, 1.0f));
}

TEST(Canvas, BlendsByCoverage) {
    Canvas canvas(2, 1);
    canvas.set(0, 0, {100, 100, 100});
    canvas.blend(0, 0, {200, 0, 100}, 0.5f);
    canvas.blend(1, 0, {9, 9, 9}, 0.0f);
    EXPECT_THAT(std::move(canvas).take().rgb, ElementsAre(150, 50, 100, 0, 0, 0));
}

}  // namespace
}  // namespace umbrage
