// SPDX-License-Identifier: Apache-2.0
#include "image/codec/decode.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>

#include "error.h"
#include "image/codec/encoded_header.h"

namespace umbrage {
namespace {

Error undecodable(const std::string& name, const EncodedHeader& header, const std::string& reason) {
    return {ErrorKind::Input, name, fmt::format("the {} picture is damaged: {}", header.format, reason),
            "export the picture again from its source"};
}

std::string reasonOf(const OIIO::ImageInput& input) {
    std::string reason = input.geterror();
    while (!reason.empty() && (reason.back() == '\n' || reason.back() == '.')) reason.pop_back();
    return reason.empty() ? "the decoder gives no reason" : reason;
}

DecodedImage decodeWithOiio(std::span<const std::byte> encoded, const EncodedHeader& header, const std::string& place,
                            OIIO::ParamValueList* attributes = nullptr) {
    // glTF's alpha is not premultiplied, and colour spaces are the material's business: pixels come as they are stored.
    OIIO::ImageSpec hints;
    hints.attribute("oiio:UnassociatedAlpha", 1);
    OIIO::Filesystem::IOMemReader memory(encoded.data(), encoded.size());
    const auto input = OIIO::ImageInput::create(std::string(header.format));
    if (!input) {
        throw Error(ErrorKind::Input, place,
                    fmt::format("this build of OpenImageIO cannot read {} ({})", header.format, OIIO::geterror()));
    }

    OIIO::ImageSpec spec;
    input->set_ioproxy(&memory);
    if (!input->open("memory." + std::string(header.format), spec, hints)) {
        throw undecodable(place, header, reasonOf(*input));
    }
    if (spec.width != header.width || spec.height != header.height || spec.nchannels < 1 || spec.nchannels > 4) {
        throw undecodable(place, header,
                          fmt::format("it decodes to {}x{} with {} channels, but declares {}x{}", spec.width,
                                      spec.height, spec.nchannels, header.width, header.height));
    }

    DecodedImage image;
    image.width = spec.width;
    image.height = spec.height;
    image.channelCount = spec.nchannels;
    const bool wide = spec.format == OIIO::TypeDesc::UINT16;
    image.type = wide ? PixelType::UInt16 : PixelType::UInt8;
    image.pixels.resize(std::size_t(spec.width) * spec.height * spec.nchannels * (wide ? 2 : 1));
    if (!input->read_image(0, 0, 0, spec.nchannels, wide ? OIIO::TypeDesc::UINT16 : OIIO::TypeDesc::UINT8,
                           image.pixels.data())) {
        throw undecodable(place, header, reasonOf(*input));
    }
    if (attributes) *attributes = spec.extra_attribs;
    return image;
}

/// The same WebP with the mark of its alpha taken away: bit 4 of VP8X's flags, bit 28 of VP8L's header.
std::vector<std::byte> withoutAlphaMark(std::span<const std::byte> webp) {
    constexpr std::size_t kChunkLetter = 15, kExtendedFlags = 20, kLosslessFlags = 24;
    constexpr std::byte kAlpha{0x10};
    std::vector<std::byte> bytes(webp.begin(), webp.end());
    const bool extended = bytes[kChunkLetter] == std::byte{'X'};
    bytes[extended ? kExtendedFlags : kLosslessFlags] &= ~kAlpha;
    return bytes;
}

}  // namespace

DecodedImage decodeImage(std::span<const std::byte> encoded, std::string_view name, OIIO::ParamValueList* attributes) {
    const std::string place(name);
    const EncodedHeader header = readEncodedHeader(encoded, place);
    DecodedImage image = decodeWithOiio(encoded, header, place, attributes);
    if (header.format == "webp" && image.channelCount == 4) {
        // OpenImageIO 2.4 premultiplies WebP whatever it is asked, which loses dark and transparent colours for good.
        // It leaves a picture without alpha alone, so the colours come from such a copy.
        const DecodedImage colors = decodeWithOiio(withoutAlphaMark(encoded), header, place);
        if (colors.channelCount != 3) throw undecodable(place, header, "its alpha is marked twice");
        for (std::size_t i = 0; i < colors.pixels.size() / 3; ++i) {
            std::copy_n(&colors.pixels[3 * i], 3, &image.pixels[4 * i]);
        }
    }
    return image;
}

}  // namespace umbrage
