// SPDX-License-Identifier: Apache-2.0
#include "golden/packed_picture.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <stdexcept>

#include "report/page/page_text.h"

namespace umbrage {
namespace {

constexpr std::array kTypeNames{"u8", "u16", "f16", "f32"};
constexpr std::array<std::size_t, 4> kTypeBytes{1, 2, 2, 4};

/// Whether value is k / most, as far as a float can tell.
bool isCode(float value, float most) {
    const float scaled = value * most;
    return value >= 0.0f && value <= 1.0f && std::abs(scaled - std::round(scaled)) <= most * 2e-7f;
}

std::uint32_t bitsOf(float value, PackedType type) {
    switch (type) {
        case PackedType::UInt8:
            return std::uint32_t(std::lround(value * 255.0f));
        case PackedType::UInt16:
            return std::uint32_t(std::lround(value * 65535.0f));
        case PackedType::Half:
            return *exactHalf(value);
        case PackedType::Float:
            break;
    }
    return std::bit_cast<std::uint32_t>(value);
}

std::string planesOf(const PagePicture& picture, PackedType type) {
    const std::size_t pixels = std::size_t(picture.width) * std::size_t(picture.height);
    const std::size_t channels = picture.channels.size(), bytes = kTypeBytes[std::size_t(type)];
    std::string planes(pixels * channels * bytes, '\0');
    for (std::size_t c = 0; c < channels; ++c) {
        for (std::size_t p = 0; p < pixels; ++p) {
            const std::uint32_t bits = bitsOf(picture.values[p * channels + c], type);
            for (std::size_t b = 0; b < bytes; ++b) {
                planes[(c * bytes + b) * pixels + p] = char(std::uint8_t(bits >> (8 * b)));
            }
        }
    }
    return planes;
}

std::string fromLeft(const std::string& planes, std::size_t width) {
    std::string differences = planes;
    for (std::size_t i = 1; i < planes.size(); ++i) {
        const std::size_t before = i % width != 0 ? i - 1 : i - width;
        differences[i] = char(std::uint8_t(planes[i]) - std::uint8_t(planes[before]));
    }
    return differences;
}

std::string fromGolden(const std::string& planes, const std::string& golden) {
    std::string differences = planes;
    for (std::size_t i = 0; i < planes.size(); ++i) {
        differences[i] = char(std::uint8_t(planes[i]) - std::uint8_t(golden[i]));
    }
    return differences;
}

std::string deflated(const std::string& bytes) {
    uLongf size = compressBound(uLong(bytes.size()));
    std::string packed(size, '\0');
    const int result = compress2(reinterpret_cast<Bytef*>(packed.data()), &size,
                                 reinterpret_cast<const Bytef*>(bytes.data()), uLong(bytes.size()), 6);
    if (result != Z_OK) throw std::bad_alloc();  // the only way to fail with room enough
    packed.resize(size);
    return packed;
}

PackedPicture packedAs(const PagePicture& picture, PackedType type, const char* from, const std::string& bytes) {
    return {{{"width", picture.width},
             {"height", picture.height},
             {"channels", picture.channels},
             {"type", kTypeNames[std::size_t(type)]},
             {"display", picture.isDisplayEncoded},
             {"from", from}},
            base64(bytes)};
}

}  // namespace

std::optional<std::uint16_t> exactHalf(float value) {
    const auto bits = std::bit_cast<std::uint32_t>(value);
    const auto sign = std::uint16_t(bits >> 16 & 0x8000u);
    if (std::isnan(value)) return std::uint16_t(sign | 0x7e00u);
    if (std::isinf(value)) return std::uint16_t(sign | 0x7c00u);
    const float size = std::abs(value);
    if (size < 0x1p-14f) {  // whole multiples of the smallest half
        const float steps = size * 0x1p24f;
        if (steps != std::floor(steps)) return std::nullopt;
        return std::uint16_t(sign | std::uint16_t(steps));
    }
    if (size > 65504.0f || (bits & 0x1fffu) != 0) return std::nullopt;
    const std::uint32_t exponent = (bits >> 23 & 0xffu) - 127 + 15;
    return std::uint16_t(sign | exponent << 10 | (bits >> 13 & 0x3ffu));
}

PackedType packedType(const std::vector<float>& values, bool isDisplayEncoded) {
    const auto all = [&](const auto& holds) { return std::all_of(values.begin(), values.end(), holds); };
    if (isDisplayEncoded && all([](float v) { return isCode(v, 255.0f); })) return PackedType::UInt8;
    if (all([](float v) { return exactHalf(v).has_value(); })) return PackedType::Half;
    if (isDisplayEncoded && all([](float v) { return isCode(v, 65535.0f); })) return PackedType::UInt16;
    return PackedType::Float;
}

PackedPictures packed(const PagePictures& pictures) {
    PackedPictures result;
    std::string goldenPlanes;
    PackedType goldenType = PackedType::Float;
    if (const auto& golden = pictures.golden) {
        goldenType = packedType(golden->values, golden->isDisplayEncoded);
        goldenPlanes = planesOf(*golden, goldenType);
        result.golden =
            packedAs(*golden, goldenType, "left", deflated(fromLeft(goldenPlanes, std::size_t(golden->width))));
    }
    if (const auto& output = pictures.output) {
        const PackedType type = packedType(output->values, output->isDisplayEncoded);
        const std::string planes = planesOf(*output, type);
        const std::string alone = deflated(fromLeft(planes, std::size_t(output->width)));
        const bool sameShape = pictures.golden && type == goldenType && pictures.golden->width == output->width &&
                               planes.size() == goldenPlanes.size();
        const std::string change = sameShape ? deflated(fromGolden(planes, goldenPlanes)) : "";
        const bool isChange = sameShape && change.size() < alone.size();
        result.output = packedAs(*output, type, isChange ? "golden" : "left", isChange ? change : alone);
    }
    return result;
}

}  // namespace umbrage
