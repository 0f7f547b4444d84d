// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "error.h"
#include "image/codec/oiio_output.h"

namespace umbrage {
namespace {

// Measured on frame 12 of knights, hall and courtyard, 1024x768, processor time, median of 5 in turn. Filter "sub":
// level 1 takes 10, 18 and 21 ms for 321, 718 and 941 KB; 4: 14, 28 and 32 ms for 264, 627 and 879 KB; 6: 34, 74 and
// 110 ms for 223, 575 and 833 KB. libpng's own choice, five filters tried on every row and level 6, takes 44, 96 and
// 132 ms for 209, 500 and 790 KB. Filter "up" is no better in all: 9, 16 and 21 ms for 297, 630 and 1049 KB.
constexpr int kDeflateLevel = 1;
constexpr int kFilterSub = 0x10;  // PNG_FILTER_SUB

Error notFinite(const std::filesystem::path& file, const ImageFile& image, const Channel2D& channel) {
    const float* values = std::get<const float*>(channel.pixels);
    std::size_t bad = 0;
    while (std::isfinite(values[bad * channel.stride])) ++bad;
    return {ErrorKind::Output, file.string(),
            fmt::format("channel {} holds {} at pixel ({}, {}), which PNG cannot store", channel.name,
                        values[bad * channel.stride], bad % image.width, bad / image.width),
            "write EXR to look at it"};
}

template <class Stored>
std::vector<Stored> stored(const std::filesystem::path& file, const ImageFile& image) {
    constexpr float kScale = std::numeric_limits<Stored>::max();
    const std::size_t pixelCount = std::size_t(image.width) * image.height;
    const std::size_t channelCount = image.channels.size();
    std::vector<Stored> result(pixelCount * channelCount);
    for (std::size_t c = 0; c < channelCount; ++c) {
        const Channel2D& channel = image.channels[c];
        if (const auto* bytes = std::get_if<const std::uint8_t*>(&channel.pixels)) {
            for (std::size_t i = 0; i < pixelCount; ++i) result[i * channelCount + c] = (*bytes)[i * channel.stride];
            continue;
        }
        const float* values = std::get<const float*>(channel.pixels);
        bool finite = true;
        for (std::size_t i = 0; i < pixelCount; ++i) {
            const float value = values[i * channel.stride];
            finite = finite && std::isfinite(value);
            // Ours rather than the library's, so that a file's bytes do not hang on its version: halves round up. The
            // order of the comparisons sends a NaN to 0 rather than into an undefined conversion.
            const float clamped = value > 0.0f ? std::min(value, 1.0f) : 0.0f;
            result[i * channelCount + c] = static_cast<Stored>(clamped * kScale + 0.5f);
        }
        if (!finite) throw notFinite(file, image, channel);
    }
    return result;
}

}  // namespace

EncodedFile encodePng(const std::filesystem::path& file, const ImageFile& image) {
    checkImage(file, image);
    const PixelType type = image.channels.front().type;
    const bool wide = type == PixelType::UInt16;
    const bool alike = std::all_of(image.channels.begin(), image.channels.end(), [&](const Channel2D& channel) {
        const bool bytes = std::holds_alternative<const std::uint8_t*>(channel.pixels);
        return channel.type == type && (std::holds_alternative<const float*>(channel.pixels) || (bytes && !wide));
    });
    if (image.channels.size() > 4 || !alike || (type != PixelType::UInt8 && !wide)) {
        throw Error(ErrorKind::Output, file.string(), "PNG stores 1 to 4 channels of 8 or 16 bits, all alike",
                    "write EXR");
    }

    OIIO::ImageSpec spec(image.width, image.height, static_cast<int>(image.channels.size()),
                         wide ? OIIO::TypeDesc::UINT16 : OIIO::TypeDesc::UINT8);
    spec.alpha_channel = spec.nchannels % 2 == 0 ? spec.nchannels - 1 : -1;
    spec.attribute("oiio:UnassociatedAlpha", 1);  // alpha comes and goes as it is
    spec.attribute("oiio:ColorSpace", "sRGB");
    spec.attribute("png:compressionLevel", kDeflateLevel);
    spec.attribute("png:filter", kFilterSub);
    for (const auto& [name, value] : image.metadata) {  // text is all that PNG has
        const auto asText = [](const auto& v) { return fmt::format("{}", v); };
        spec.attribute(name, std::visit(asText, value));
    }
    return wide ? encodeWithOiio(file, "png", spec, stored<std::uint16_t>(file, image).data())
                : encodeWithOiio(file, "png", spec, stored<std::uint8_t>(file, image).data());
}

}  // namespace umbrage
