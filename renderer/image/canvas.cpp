// SPDX-License-Identifier: Apache-2.0
#include "image/canvas.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "image/bitmap_font.h"

namespace umbrage {

ImageFile RgbPicture::file(Metadata metadata) const {
    const std::uint8_t* p = rgb.data();
    return {width,
            height,
            {{"R", PixelType::UInt8, p, 3}, {"G", PixelType::UInt8, p + 1, 3}, {"B", PixelType::UInt8, p + 2, 3}},
            std::move(metadata)};
}

Canvas::Canvas(int width, int height)
    : picture_{width, height, std::vector<std::uint8_t>(std::size_t(width) * std::size_t(height) * 3)} {}

void Canvas::set(int x, int y, const Rgb8& color) {
    assert(x >= 0 && y >= 0 && x < width() && y < height());
    std::copy(color.begin(), color.end(), picture_.rgb.begin() + (std::ptrdiff_t(y) * width() + x) * 3);
}

void Canvas::blend(int x, int y, const Rgb8& color, float coverage) {
    const std::uint8_t* below = &picture_.rgb[(std::size_t(y) * std::size_t(width()) + std::size_t(x)) * 3];
    Rgb8 result;
    for (std::size_t c = 0; c < 3; ++c) {
        result[c] = static_cast<std::uint8_t>(std::lround(below[c] + (color[c] - below[c]) * coverage));
    }
    set(x, y, result);
}

void Canvas::fill(int x, int y, int width, int height, const Rgb8& color) {
    for (int row = y; row < y + height; ++row) {
        for (int column = x; column < x + width; ++column) set(column, row, color);
    }
}

void Canvas::text(int x, int y, int scale, std::string_view line, const Rgb8& color) {
    for (std::size_t i = 0; i < line.size(); ++i) {
        const int left = x + static_cast<int>(i) * kGlyphAdvance * scale;
        for (int gy = 0; gy < kGlyphHeight; ++gy) {
            for (int gx = 0; gx < kGlyphWidth; ++gx) {
                if (glyphCovers(line[i], gx, gy)) fill(left + gx * scale, y + gy * scale, scale, scale, color);
            }
        }
    }
}

void Canvas::centredText(int centre, int y, int scale, std::string_view line) {
    text(centre - textWidth(line) * scale / 2, y, scale, line);
}

std::string shortened(std::string_view line, int width) {
    if (textWidth(line) <= width) return std::string(line);
    return std::string(line.substr(0, static_cast<std::size_t>(std::max(0, width / kGlyphAdvance - 3)))) + "...";
}

float greyOf(const std::uint8_t* rgb) {
    return 0.2126f * rgb[0] + 0.7152f * rgb[1] + 0.0722f * rgb[2];
}

Rgb8 mixed(const Rgb8& color, float grey, float greyShare) {
    Rgb8 result;
    for (std::size_t c = 0; c < 3; ++c) {
        result[c] = static_cast<std::uint8_t>(color[c] * (1.0f - greyShare) + grey * greyShare + 0.5f);
    }
    return result;
}

std::vector<std::uint8_t> rgbBytes(std::span<const float> rgba) {
    std::vector<std::uint8_t> bytes;
    bytes.reserve(rgba.size() / 4 * 3);
    for (std::size_t i = 0; i < rgba.size(); ++i) {
        if (i % 4 == 3) continue;
        const float value = std::isnan(rgba[i]) ? 0.0f : std::clamp(rgba[i], 0.0f, 1.0f);
        bytes.push_back(std::uint8_t(std::lround(value * 255.0f)));
    }
    return bytes;
}

}  // namespace umbrage
