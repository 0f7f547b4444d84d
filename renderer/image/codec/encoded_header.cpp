// SPDX-License-Identifier: Apache-2.0
#include "image/codec/encoded_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

#include "error.h"

namespace umbrage {
namespace {

constexpr std::int64_t kMaximumSide = 16384;  // no GL 4.5 device of today takes larger textures

// Any file may declare this much, so that tiny files of one flat colour are never refused.
constexpr std::int64_t kAlwaysPlausiblePixels = std::int64_t{4} << 20;

// Pixels one byte can encode at best. PNG: deflate reaches 1032:1, at 1 bit a pixel. JPEG: a block of 64 pixels needs
// at least one bit. WebP's arithmetic coder has no such limit; the number only asks for some relation to the file.
constexpr std::int64_t kPngPixelsPerByte = 1032 * 8;
constexpr std::int64_t kJpegPixelsPerByte = 512;
constexpr std::int64_t kWebpPixelsPerByte = 4096;

class Bytes {
public:
    Bytes(std::span<const std::byte> data, const std::string& name) : data_(data), name_(name) {}

    std::size_t size() const { return data_.size(); }

    std::uint32_t at(std::size_t offset) const {
        if (offset >= data_.size()) throw cutShort();
        return std::to_integer<std::uint32_t>(data_[offset]);
    }
    std::uint32_t big16(std::size_t o) const { return at(o) << 8 | at(o + 1); }
    std::uint32_t big32(std::size_t o) const { return big16(o) << 16 | big16(o + 2); }
    std::uint32_t little16(std::size_t o) const { return at(o) | at(o + 1) << 8; }
    std::uint32_t little24(std::size_t o) const { return little16(o) | at(o + 2) << 16; }
    std::uint32_t little32(std::size_t o) const { return little16(o) | little16(o + 2) << 16; }

    bool has(std::size_t offset, std::string_view text) const {
        return offset + text.size() <= data_.size() &&
               std::equal(text.begin(), text.end(), data_.begin() + static_cast<std::ptrdiff_t>(offset),
                          [](char c, std::byte b) { return static_cast<std::byte>(c) == b; });
    }

    Error refused(const std::string& message) const {
        return {ErrorKind::Input, name_, message, "export the picture again from its source"};
    }
    Error cutShort() const { return refused(fmt::format("the picture is cut short at {} bytes", data_.size())); }

private:
    std::span<const std::byte> data_;
    const std::string& name_;
};

struct DeclaredSize {
    std::int64_t width = 0, height = 0;
};

// Walks all chunks to the end mark: libpng would report what is missing on stderr.
DeclaredSize pngSize(const Bytes& bytes) {
    if (bytes.size() < 33) throw bytes.cutShort();
    if (!bytes.has(12, "IHDR")) throw bytes.refused("the picture's PNG does not begin with its header");
    std::size_t at = 8;
    while (!bytes.has(at + 4, "IEND")) at += std::size_t{12} + bytes.big32(at);
    bytes.big32(at + 8);  // its check sum is there too
    return {bytes.big32(16), bytes.big32(20)};
}

// Walks all segments to the end marker: libjpeg paints what is missing grey and says nothing.
DeclaredSize jpegSize(const Bytes& bytes) {
    constexpr std::uint32_t kEndOfImage = 0xD9, kStartOfScan = 0xDA;
    DeclaredSize size;
    bool inScan = false;
    for (std::size_t at = 2;;) {
        if (bytes.at(at) != 0xFF) {
            if (!inScan) throw bytes.refused("the picture's JPEG segments are damaged");
            ++at;
            continue;
        }
        const std::uint32_t marker = bytes.at(at + 1);
        const bool restart = marker >= 0xD0 && marker <= 0xD7;
        if (marker == 0xFF) {  // fill byte
            ++at;
        } else if (marker == 0x00 || marker == 0x01 || restart) {  // a stuffed zero, or markers that stand alone
            at += 2;
        } else if (marker == kEndOfImage) {
            break;
        } else {
            const bool frame = marker >= 0xC0 && marker <= 0xCF && marker != 0xC4 && marker != 0xC8 && marker != 0xCC;
            if (frame) size = {bytes.big16(at + 7), bytes.big16(at + 5)};
            inScan = marker == kStartOfScan;
            at += 2 + bytes.big16(at + 2);
        }
    }
    return size;
}

DeclaredSize webpSize(const Bytes& bytes) {
    if (std::uint64_t{bytes.little32(4)} + 8 > bytes.size()) throw bytes.cutShort();
    if (bytes.has(12, "VP8X")) return {bytes.little24(24) + 1, bytes.little24(27) + 1};
    if (bytes.has(12, "VP8L")) {
        const std::uint32_t packed = bytes.little32(21);
        return {(packed & 0x3FFF) + 1, (packed >> 14 & 0x3FFF) + 1};
    }
    if (bytes.has(12, "VP8 ")) return {bytes.little16(26) & 0x3FFF, bytes.little16(28) & 0x3FFF};
    throw bytes.refused("the picture's WebP does not begin with pixels");
}

}  // namespace

EncodedHeader readEncodedHeader(std::span<const std::byte> encoded, const std::string& name) {
    const Bytes bytes(encoded, name);
    std::string_view format;
    DeclaredSize size;
    std::int64_t pixelsPerByte = 0;
    if (bytes.has(0, "\x89PNG\r\n\x1a\n")) {
        format = "png", size = pngSize(bytes), pixelsPerByte = kPngPixelsPerByte;
    } else if (bytes.has(0, "\xFF\xD8\xFF")) {
        format = "jpeg", size = jpegSize(bytes), pixelsPerByte = kJpegPixelsPerByte;
    } else if (bytes.has(0, "RIFF") && bytes.has(8, "WEBP")) {
        format = "webp", size = webpSize(bytes), pixelsPerByte = kWebpPixelsPerByte;
    } else {
        throw Error(ErrorKind::Input, name, "the picture is neither PNG, JPEG nor WebP",
                    "convert it to one of these; KTX2 textures are not supported");
    }

    if (size.width < 1 || size.height < 1) throw bytes.refused("the picture has no pixels");
    if (size.width > kMaximumSide || size.height > kMaximumSide) {
        throw Error(ErrorKind::Input, name,
                    fmt::format("the picture declares {}x{} pixels, more than {} on a side", size.width, size.height,
                                kMaximumSide),
                    "scale it down");
    }
    const auto length = static_cast<std::int64_t>(encoded.size());
    if (size.width * size.height > kAlwaysPlausiblePixels + pixelsPerByte * length) {
        throw bytes.refused(fmt::format("the picture declares {}x{} pixels, which {} bytes cannot hold", size.width,
                                        size.height, length));
    }
    return {format, static_cast<int>(size.width), static_cast<int>(size.height)};
}

}  // namespace umbrage
