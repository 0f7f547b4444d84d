// SPDX-License-Identifier: Apache-2.0
#include "image/thumbnail.h"

#include <algorithm>
#include <cassert>

#include "image/canvas.h"

namespace umbrage {

std::string Thumbnail::png() const {
    return codec().png(RgbPicture{width, height, rgbBytes(rgba)}.file({}));
}

Thumbnail thumbnailOf(int width, int height, std::span<const float> rgba, int mostWide) {
    assert(rgba.size() == std::size_t(width) * std::size_t(height) * 4);
    Thumbnail small;
    small.width = std::min(width, mostWide);
    small.height = std::max(1, int((std::int64_t(height) * small.width + width / 2) / width));
    const auto edge = [](int i, int from, int to) { return int(std::int64_t(i) * to / from); };
    for (int y = 0; y < small.height; ++y) {
        for (int x = 0; x < small.width; ++x) {
            double sum[4] = {};
            const int left = edge(x, small.width, width), right = edge(x + 1, small.width, width);
            const int top = edge(y, small.height, height), bottom = edge(y + 1, small.height, height);
            for (int row = top; row < bottom; ++row) {
                for (int column = left; column < right; ++column) {
                    const float* pixel = &rgba[(std::size_t(row) * std::size_t(width) + std::size_t(column)) * 4];
                    for (int c = 0; c < 4; ++c) sum[c] += pixel[c];
                }
            }
            for (const double value : sum) small.rgba.push_back(float(value / ((right - left) * (bottom - top))));
        }
    }
    return small;
}

Thumbnail thumbnailOf(const DecodedImage& image) {
    const bool wide = image.type == PixelType::UInt16;
    const auto valueAt = [&](std::size_t i) {
        if (!wide) return float(std::to_integer<int>(image.pixels[i])) / 255.0f;
        return float(reinterpret_cast<const std::uint16_t*>(image.pixels.data())[i]) / 65535.0f;
    };
    std::vector<float> rgba;
    const std::size_t channels = std::size_t(image.channelCount);
    for (std::size_t i = 0; i < std::size_t(image.width) * std::size_t(image.height); ++i) {
        for (std::size_t c = 0; c < 3; ++c) rgba.push_back(valueAt(i * channels + (channels < 3 ? 0 : c)));
        rgba.push_back(1.0f);
    }
    return thumbnailOf(image.width, image.height, rgba);
}

}  // namespace umbrage
