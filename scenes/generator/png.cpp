// SPDX-License-Identifier: Apache-2.0
#include "png.h"

#include <zlib.h>

#include <cstdlib>
#include <stdexcept>
#include <string_view>

namespace generator {
namespace {

std::string bigEndian(std::uint32_t value) {
    std::string bytes;
    for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift & 0xffu);
    return bytes;
}

std::string chunk(const std::string& type, const std::string& data) {
    const std::string body = type + data;
    const auto crc = crc32(0, reinterpret_cast<const Bytef*>(body.data()), static_cast<uInt>(body.size()));
    return bigEndian(static_cast<std::uint32_t>(data.size())) + body + bigEndian(static_cast<std::uint32_t>(crc));
}

int paeth(int left, int up, int corner) {
    const int guess = left + up - corner;
    const int a = std::abs(guess - left), b = std::abs(guess - up), c = std::abs(guess - corner);
    return a <= b && a <= c ? left : b <= c ? up : corner;
}

}  // namespace

std::string pngOf(const Picture& picture) {
    const std::size_t channels = picture.alpha.empty() ? 3 : 4;
    std::vector<std::uint8_t> pixels;
    for (std::size_t i = 0; i < picture.rgb.size(); ++i) {
        pixels.push_back(picture.rgb[i]);
        if (channels == 4 && i % 3 == 2) pixels.push_back(picture.alpha[i / 3]);
    }
    const std::size_t stride = static_cast<std::size_t>(picture.size) * channels;
    std::string rows;
    for (int y = 0; y < picture.size; ++y) {
        rows += '\4';  // the Paeth filter: best for these noisy pictures
        const std::uint8_t* row = &pixels[y * stride];
        for (std::size_t x = 0; x < stride; ++x) {
            const int left = x >= channels ? row[x - channels] : 0, up = y > 0 ? row[x - stride] : 0;
            const int corner = x >= channels && y > 0 ? row[x - stride - channels] : 0;
            rows += static_cast<char>(row[x] - paeth(left, up, corner));
        }
    }
    uLongf length = compressBound(rows.size());
    std::string packed(length, '\0');
    if (compress2(reinterpret_cast<Bytef*>(packed.data()), &length, reinterpret_cast<const Bytef*>(rows.data()),
                  rows.size(), 9) != Z_OK)
        throw std::runtime_error("zlib could not compress a picture");
    packed.resize(length);

    const std::string size = bigEndian(static_cast<std::uint32_t>(picture.size));
    std::string header = size + size + std::string("\x08\x02\x00\x00\x00", 5);  // 8 bits, RGB, not interlaced
    if (channels == 4) header[9] = '\6';                                        // RGBA
    return "\x89PNG\r\n\x1a\n" + chunk("IHDR", header) + chunk("IDAT", packed) + chunk("IEND", "");
}

}  // namespace generator
