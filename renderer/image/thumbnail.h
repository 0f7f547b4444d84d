// SPDX-License-Identifier: Apache-2.0
// Small pictures, to find a frame by.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "image/image.h"

namespace umbrage {

inline constexpr int kThumbnailWidth = 160;

struct Thumbnail {
    int width = 0, height = 0;
    std::vector<float> rgba;

    /// Its display values as a PNG file.
    std::string png() const;
};

/// At most `mostWide` pixels wide, each the mean of those it stands for.
/// @param rgba  width x height interleaved pixels
Thumbnail thumbnailOf(int width, int height, std::span<const float> rgba, int mostWide = kThumbnailWidth);

/// Of a decoded picture; grey ones become colours.
Thumbnail thumbnailOf(const DecodedImage& image);

}  // namespace umbrage
