// SPDX-License-Identifier: Apache-2.0
#define IMATH_HALF_NO_LOOKUP_TABLE  // the table is in a library that nothing else here needs
#include <Imath/half.h>
#include <gmock/gmock.h>
#include <sys/stat.h>

#include <limits>
#include <random>

#include "error.h"
#include "image/image.h"
#include "pictures.h"

namespace umbrage {
namespace {

using test::Bytes;
using test::TemporaryFolder;
using testing::ElementsAre;
using testing::HasSubstr;

using Floats = std::vector<float>;
using Integers = std::vector<std::uint32_t>;

std::filesystem::path written(const TemporaryFolder& folder, const std::string& name, const Bytes& bytes) {
    writeWhole(folder / name, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    return folder / name;
}

/// An EXR by OpenImageIO, so that our own writer is not believed.
struct ExrParts {
    OIIO::ImageSpec spec;
    std::vector<std::byte> pixels;  // native
};

Bytes makeExr(const ExrParts& parts) {
    Bytes bytes;
    OIIO::Filesystem::IOVecOutput memory(bytes);
    const auto output = OIIO::ImageOutput::create("openexr");
    if (!output->set_ioproxy(&memory) || !output->open("test.exr", parts.spec) ||
        !output->write_image(OIIO::TypeDesc::UNKNOWN, parts.pixels.data()) || !output->close()) {
        throw std::runtime_error(output->geterror());
    }
    return bytes;
}

template <class T>
void append(std::vector<std::byte>& bytes, T value) {
    const auto* first = reinterpret_cast<const std::byte*>(&value);
    bytes.insert(bytes.end(), first, first + sizeof value);
}

/// Two pixels of a half, a float and a uint channel, in an order that is not the alphabet's.
ExrParts mixedParts() {
    ExrParts parts;
    parts.spec = OIIO::ImageSpec(2, 1, 3, OIIO::TypeDesc::FLOAT);
    parts.spec.channelnames = {"shadow.Lamp", "Z", "id"};
    parts.spec.channelformats = {OIIO::TypeDesc::HALF, OIIO::TypeDesc::FLOAT, OIIO::TypeDesc::UINT32};
    for (const auto& [shadow, z, id] : {std::tuple{0.5f, 1.1f, 4294967295u}, {65504.0f, -1e30f, 16777217u}}) {
        append(parts.pixels, half(shadow));
        append(parts.pixels, z);
        append(parts.pixels, id);
    }
    return parts;
}

ExrParts flatParts(int width, int height) {
    ExrParts parts{OIIO::ImageSpec(width, height, 1, OIIO::TypeDesc::FLOAT), {}};
    parts.spec.channelnames = {"Z"};
    parts.pixels.resize(parts.spec.image_bytes());
    return parts;
}

TEST(Read, ExrChannelsAreByNameWithEveryBit) {
    const TemporaryFolder folder;
    const StoredImage image = codec().read(written(folder, "mixed.exr", makeExr(mixedParts())));
    EXPECT_EQ(image.data, (PixelWindow{0, 0, 2, 1}));
    EXPECT_EQ(image.display, image.data);
    EXPECT_FALSE(image.displayEncoded);
    ASSERT_EQ(image.channels.size(), 3u);
    EXPECT_EQ(image.channels[0].name, "Z");
    EXPECT_EQ(image.channels[1].name, "id");
    EXPECT_EQ(image.channels[2].name, "shadow.Lamp");
    EXPECT_EQ(image.channel("Z")->type, PixelType::Float);
    EXPECT_EQ(image.channel("id")->type, PixelType::UInt32);
    EXPECT_EQ(image.channel("shadow.Lamp")->type, PixelType::Half);
    EXPECT_THAT(*image.floats("Z"), ElementsAre(1.1f, -1e30f));
    EXPECT_THAT(*image.floats("shadow.Lamp"), ElementsAre(0.5f, 65504.0f));
    EXPECT_THAT(std::get<Integers>(image.channel("id")->values), ElementsAre(4294967295u, 16777217u));
    EXPECT_EQ(image.floats("id"), nullptr);
    EXPECT_EQ(image.channel("R"), nullptr);
}

TEST(Read, ExrKeepsNansAndInfinities) {
    const TemporaryFolder folder;
    ExrParts parts = flatParts(3, 1);
    const float values[] = {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), -0.0f};
    std::memcpy(parts.pixels.data(), values, sizeof values);
    const StoredImage image = codec().read(written(folder, "bad.exr", makeExr(parts)));
    const Floats& z = *image.floats("Z");
    EXPECT_TRUE(std::isnan(z[0]));
    EXPECT_EQ(z[1], std::numeric_limits<float>::infinity());
    EXPECT_TRUE(std::signbit(z[2]));
}

TEST(Read, ExrWindowsHaveTheirOrigins) {
    const TemporaryFolder folder;
    ExrParts parts = flatParts(3, 2);
    parts.spec.x = -5, parts.spec.y = 7;
    parts.spec.full_x = -10, parts.spec.full_y = 1, parts.spec.full_width = 40, parts.spec.full_height = 30;
    const StoredImage image = codec().read(written(folder, "window.exr", makeExr(parts)));
    EXPECT_EQ(image.data, (PixelWindow{-5, 7, 3, 2}));
    EXPECT_EQ(image.display, (PixelWindow{-10, 1, 40, 30}));
    EXPECT_EQ(image.floats("Z")->size(), 6u);
}

TEST(Read, EveryCompressionAndTiles) {
    const TemporaryFolder folder;
    for (const char* compression : {"none", "rle", "zip", "zips", "piz", "pxr24"}) {
        for (const int tile : {0, 16}) {
            ExrParts parts = flatParts(70, 50);
            for (int i = 0; i < 70 * 50; ++i) {
                const float value = float(i / 7) / 4.0f;  // 24 bits hold it: pxr24 stores no more
                std::memcpy(&parts.pixels[4 * i], &value, 4);
            }
            parts.spec.attribute("compression", compression);
            parts.spec.tile_width = parts.spec.tile_height = tile;
            const StoredImage image = codec().read(written(folder, "c.exr", makeExr(parts)));
            const Floats& z = *image.floats("Z");
            ASSERT_EQ(z.size(), 3500u);
            for (int i = 0; i < 3500; ++i) ASSERT_EQ(z[i], float(i / 7) / 4.0f) << compression << ' ' << tile;
        }
    }
}

TEST(Read, FlatPicturesAreNeverImplausible) {
    const TemporaryFolder folder;
    for (const char* compression : {"rle", "zip", "piz", "pxr24", "dwaa", "dwab"}) {
        ExrParts parts = flatParts(4096, 4096);
        parts.spec.set_format(OIIO::TypeDesc::HALF);
        parts.pixels.resize(parts.spec.image_bytes());
        parts.spec.attribute("compression", compression);
        const StoredImage image = codec().read(written(folder, "flat.exr", makeExr(parts)));
        EXPECT_EQ(image.pixelCount(), 4096u * 4096u) << compression;
    }
}

TEST(Read, WhatTheCodecWritesComesBack) {
    const TemporaryFolder folder;
    const Floats rgb{0.1f, 1.5f, -2.0f, 1e-3f, 0.0f, 7.0f};
    const Integers counts{3, 4000000000u};
    ImageFile file{2, 1, {}, {{"umbrage:frame", 12}, {"umbrage:scene", std::string("court")}, {"umbrage:fps", 23.976}}};
    for (int c = 0; c < 3; ++c)
        file.channels.push_back({std::string("RGB").substr(c, 1), PixelType::Float, &rgb[c], 3});
    file.channels.push_back({"stencil.Lamp", PixelType::UInt32, counts.data(), 1});
    codec().write(folder / "all.exr", file);
    const StoredImage image = codec().read(folder / "all.exr");
    EXPECT_THAT(*image.floats("R"), ElementsAre(0.1f, 1e-3f));
    EXPECT_THAT(*image.floats("G"), ElementsAre(1.5f, 0.0f));
    EXPECT_THAT(*image.floats("B"), ElementsAre(-2.0f, 7.0f));
    EXPECT_THAT(std::get<Integers>(image.channel("stencil.Lamp")->values), ElementsAre(3u, 4000000000u));
    for (const auto& entry : file.metadata) EXPECT_THAT(image.metadata, testing::Contains(entry));
}

TEST(Read, PngIsInDisplayValues) {
    const TemporaryFolder folder;
    const StoredImage rgba = codec().read(written(
        folder, "8.png", test::makePng({.width = 2, .colorType = 6, .rows = {0, 255, 51, 0, 102, 9, 8, 7, 0}})));
    EXPECT_TRUE(rgba.displayEncoded);
    EXPECT_EQ(rgba.data, (PixelWindow{0, 0, 2, 1}));
    EXPECT_EQ(rgba.channel("R")->type, PixelType::UInt8);
    EXPECT_THAT(*rgba.floats("R"), ElementsAre(1.0f, 9.0f / 255.0f));
    EXPECT_THAT(*rgba.floats("G"), ElementsAre(0.2f, 8.0f / 255.0f));
    EXPECT_THAT(*rgba.floats("B"), ElementsAre(0.0f, 7.0f / 255.0f));
    EXPECT_THAT(*rgba.floats("A"), ElementsAre(0.4f, 0.0f));

    const StoredImage grey = codec().read(written(
        folder, "16.png", test::makePng({.bitDepth = 16, .colorType = 4, .rows = {0, 0x12, 0x34, 0xFF, 0xFF}})));
    ASSERT_EQ(grey.channels.size(), 2u);
    EXPECT_EQ(grey.channel("Y")->type, PixelType::UInt16);
    EXPECT_THAT(*grey.floats("Y"), ElementsAre(float(0x1234) / 65535.0f));
    EXPECT_THAT(*grey.floats("A"), ElementsAre(1.0f));
}

TEST(Read, PngKeepsItsTexts) {
    const TemporaryFolder folder;
    const Floats grey{0.5f};
    codec().write(folder / "t.png", {1, 1, {{"Y", PixelType::UInt8, grey.data(), 1}}, {{"umbrage:scene", "court"}}});
    const Metadata metadata = codec().read(folder / "t.png").metadata;
    EXPECT_THAT(metadata, testing::Contains(Metadata::value_type{"umbrage:scene", std::string("court")}));
}

void expectRefused(const std::filesystem::path& file, const std::string& part) {
    try {
        codec().read(file);
        ADD_FAILURE() << "was read";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::Input);
        EXPECT_EQ(error.where(), file.string());
        EXPECT_THAT(error.what(), HasSubstr(part));
    }
}

TEST(Read, NoFileIsNamed) {
    const TemporaryFolder folder;
    expectRefused(folder / "none.exr", "no such file");
    expectRefused(folder.path(), "not a file");
    ASSERT_EQ(::mkfifo((folder / "pipe.exr").c_str(), 0600), 0);
    expectRefused(folder / "pipe.exr", "not a file");
    expectRefused(written(folder, "empty.exr", {}), "neither PNG nor EXR");
    expectRefused(written(folder, "text.png", {'t', 'e', 'x', 't'}), "neither PNG nor EXR");
    expectRefused(written(folder, "a.png", test::encodeWithOiio("jpeg", 8, 8, 3, Bytes(192))), "neither PNG nor EXR");
}

/// Where the value of an attribute begins.
std::size_t valueOf(const Bytes& exr, const std::string& attribute, const std::string& type) {
    std::string header = attribute + '\0' + type + '\0';
    const auto found = std::search(exr.begin(), exr.end(), header.begin(), header.end());
    if (found == exr.end()) throw std::runtime_error("no attribute " + attribute);
    return std::size_t(found - exr.begin()) + header.size() + 4;
}

Bytes patched(Bytes exr, std::size_t at, std::int32_t value) {
    std::memcpy(&exr[at], &value, sizeof value);
    return exr;
}

TEST(Read, WhatAnExrClaimsIsBounded) {
    const TemporaryFolder folder;
    const Bytes exr = makeExr(flatParts(8, 8));
    const std::size_t window = valueOf(exr, "dataWindow", "box2i");
    const std::size_t display = valueOf(exr, "displayWindow", "box2i");
    const std::size_t channels = valueOf(exr, "channels", "chlist");
    const auto refused = [&](const Bytes& bytes, const std::string& part) {
        expectRefused(written(folder, "hostile.exr", bytes), part);
    };
    refused(patched(exr, window + 8, 999999), "out of bounds");
    refused(patched(exr, window + 8, -1), "data window is empty");
    refused(patched(exr, window + 8, 2147483647), "out of bounds");
    refused(patched(patched(exr, window, -2147483647), window + 8, -2147483640), "out of bounds");
    refused(patched(patched(exr, window + 8, 16383), window + 12, 16383), "cannot hold");
    refused(patched(exr, display + 12, 100000), "display window");
    refused(patched(exr, channels + 2, 77), "unknown type");
    refused(patched(exr, channels + 10, 2), "subsampled");
    refused(patched(exr, window - 4, 2147483647), "cut short");
    refused(patched(exr, 4, 2 | 0x1000), "several parts");
    refused(patched(exr, 4, 2 | 0x800), "deep");
    refused(patched(exr, 4, 3), "unknown version");

    ExrParts tiled = flatParts(8, 8);
    tiled.spec.tile_width = tiled.spec.tile_height = 16;
    const Bytes tiles = makeExr(tiled);
    const std::size_t tile = valueOf(tiles, "tiles", "tiledesc");
    refused(patched(tiles, tile, 2000000000), "tiles");
    refused(patched(patched(tiles, tile, 16384), tile + 4, 16384), "cannot hold");
}

// Nothing is read as a picture that is not there in full, and no damage ends in anything but an Error.
TEST(Read, EveryTruncationIsRefused) {
    const TemporaryFolder folder;
    const Bytes exr = makeExr(mixedParts());
    const Bytes png = test::makePng({.width = 2, .rows = {0, 1, 2, 3, 254, 255, 0}});
    for (const Bytes& whole : {exr, png}) {
        for (std::size_t length = 0; length < whole.size(); ++length) {
            expectRefused(written(folder, "cut", Bytes(whole.begin(), whole.begin() + std::ptrdiff_t(length))), "");
        }
    }
}

TEST(Read, DamageIsAnErrorOrAPicture) {
    const TemporaryFolder folder;
    ExrParts parts = flatParts(40, 40);
    parts.spec.attribute("compression", "zip");
    const Bytes whole = makeExr(parts);
    std::mt19937 random(11);
    int refused = 0;
    for (int round = 0; round < 2000; ++round) {
        Bytes bytes = whole;
        for (int i = 0; i < 3; ++i) bytes[random() % bytes.size()] = std::uint8_t(random());
        try {
            const StoredImage image = codec().read(written(folder, "damaged.exr", bytes));
            for (const StoredChannel& channel : image.channels) {
                std::visit([&](const auto& values) { EXPECT_EQ(values.size(), image.pixelCount()); }, channel.values);
            }
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::Input);
            ++refused;
        }
    }
    EXPECT_GT(refused, 200);
}

}  // namespace
}  // namespace umbrage
