// SPDX-License-Identifier: Apache-2.0
#include "image/codec/exr_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>

#include "error.h"

namespace umbrage {
namespace {

constexpr std::int64_t kMaximumSide = 16384;
constexpr std::int64_t kMaximumOrigin = std::int64_t{1} << 30;  // beyond it sums of window corners leave int
constexpr std::size_t kMaximumChannels = 1024;

// Any file may declare this many bytes of pixels. Beyond, deflate's best ratio, 1032:1, is that of ZIP, ZIPS, PXR24 and
// the tables of DWA; DWA's flat blocks shrink once more before, and PIZ's runs reach 464:1.
constexpr std::int64_t kAlwaysPlausibleBytes = std::int64_t{64} << 20;
constexpr std::int64_t kBytesPerByte = 4096;

constexpr std::uint32_t kLongNames = 0x400, kTiled = 0x200, kDeep = 0x800, kManyParts = 0x1000;

class Cursor {
public:
    Cursor(std::span<const std::byte> data, const std::string& name) : data_(data), name_(name) {}

    template <class T>
    T take() {
        T value;
        std::memcpy(&value, bytes(sizeof value).data(), sizeof value);
        return value;
    }
    std::span<const std::byte> bytes(std::size_t count) {
        if (count > data_.size() - at_) throw refused("the EXR's header is cut short");
        at_ += count;
        return data_.subspan(at_ - count, count);
    }
    std::string text() {
        std::string result;
        while (const char c = take<char>()) {
            result += c;
            if (result.size() > 255) throw refused("a name in the EXR's header has no end");
        }
        return result;
    }
    Error refused(const std::string& message, const std::string& hint = "render or export the picture again") const {
        return {ErrorKind::Input, name_, message, hint};
    }

private:
    static_assert(std::endian::native == std::endian::little, "EXR is little-endian");
    std::span<const std::byte> data_;
    const std::string& name_;
    std::size_t at_ = 0;
};

PixelWindow windowOf(Cursor& value, const Cursor& file, const char* what) {
    const std::int64_t left = value.take<std::int32_t>(), top = value.take<std::int32_t>();
    const std::int64_t right = value.take<std::int32_t>(), bottom = value.take<std::int32_t>();
    const std::int64_t width = right - left + 1, height = bottom - top + 1;
    if (width < 1 || height < 1) throw file.refused(fmt::format("the EXR's {} window is empty", what));
    if (width > kMaximumSide || height > kMaximumSide || std::max(std::abs(left), std::abs(top)) > kMaximumOrigin) {
        throw file.refused(fmt::format("the EXR's {} window is {}x{} pixels at ({}, {}), out of bounds: {} on a side",
                                       what, width, height, left, top, kMaximumSide),
                           "crop or scale it");
    }
    return {int(left), int(top), int(width), int(height)};
}

void addChannels(Cursor& list, const Cursor& file, ExrHeader& header) {
    constexpr std::size_t kSizes[] = {4, 2, 4};  // uint, half, float
    for (std::string name; !(name = list.text()).empty();) {
        const auto type = list.take<std::uint32_t>();
        list.bytes(4);  // linearity and reserved
        const auto xSampling = list.take<std::int32_t>(), ySampling = list.take<std::int32_t>();
        if (type >= std::size(kSizes)) throw file.refused(fmt::format("EXR channel {} has an unknown type", name));
        if (xSampling != 1 || ySampling != 1) {
            throw file.refused(fmt::format("EXR channel {} is subsampled, which is not supported", name),
                               "store every pixel of it");
        }
        if (++header.channelCount > kMaximumChannels) {
            throw file.refused(fmt::format("the EXR has more than {} channels", kMaximumChannels));
        }
        header.pixelBytes += kSizes[type];
    }
}

}  // namespace

ExrHeader readExrHeader(std::span<const std::byte> encoded, const std::string& name) {
    Cursor file(encoded, name);
    file.bytes(kExrMagic.size());
    const auto version = file.take<std::uint32_t>();
    if (version & (kManyParts | kDeep)) {
        throw file.refused("EXR files of several parts, and deep ones, are not supported",
                           "store one flat part a file");
    }
    if ((version & ~(kLongNames | kTiled)) != 2) throw file.refused("the EXR is of an unknown version");

    ExrHeader header;
    std::int64_t tileWidth = 1, tileHeight = 1;
    for (std::string attribute; !(attribute = file.text()).empty();) {
        file.text();  // the type, which the standard's attributes have given
        const auto value = file.bytes(file.take<std::uint32_t>());
        Cursor cursor(value, name);
        if (attribute == "channels") addChannels(cursor, file, header);
        if (attribute == "dataWindow") header.data = windowOf(cursor, file, "data");
        if (attribute == "displayWindow") header.display = windowOf(cursor, file, "display");
        if (attribute == "tiles") tileWidth = cursor.take<std::uint32_t>(), tileHeight = cursor.take<std::uint32_t>();
    }
    if (header.channelCount == 0 || header.data.width == 0 || header.display.width == 0) {
        throw file.refused("the EXR's header lacks channels or windows");
    }
    if (std::max(tileWidth, tileHeight) > kMaximumSide) throw file.refused("the EXR's tiles are out of bounds");

    // A decoder holds a whole tile, also where the picture is smaller.
    const std::int64_t width = std::max<std::int64_t>(header.data.width, tileWidth);
    const std::int64_t height = std::max<std::int64_t>(header.data.height, tileHeight);
    const std::int64_t declared = width * height * std::int64_t(header.pixelBytes);
    if (declared > kAlwaysPlausibleBytes + kBytesPerByte * std::int64_t(encoded.size())) {
        throw file.refused(
            fmt::format("the EXR declares {} bytes of pixels, which {} bytes cannot hold", declared, encoded.size()));
    }
    return header;
}

}  // namespace umbrage
