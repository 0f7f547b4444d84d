// SPDX-License-Identifier: Apache-2.0
// Pictures for people: rectangles and lines of text on 8-bit RGB.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "image/false_color.h"
#include "image/image.h"

namespace umbrage {

inline constexpr Rgb8 kPanel{16, 16, 16}, kInk{235, 235, 235};

/// Rows from the top.
struct RgbPicture {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgb;

    /// Refers to the picture's bytes.
    ImageFile file(Metadata metadata) const;
};

/// Black at first. Everything drawn lies inside.
class Canvas {
public:
    Canvas(int width, int height);
    explicit Canvas(RgbPicture picture) : picture_(std::move(picture)) {}

    int width() const { return picture_.width; }
    int height() const { return picture_.height; }

    void set(int x, int y, const Rgb8& color);
    /// @param coverage  0: nothing changes, 1: as set()
    void blend(int x, int y, const Rgb8& color, float coverage);
    void fill(int x, int y, int width, int height, const Rgb8& color);
    /// With the upper left corner at (x, y); `scale` pixels for one of the font's.
    void text(int x, int y, int scale, std::string_view line, const Rgb8& color = kInk);
    void centredText(int centre, int y, int scale, std::string_view line);

    RgbPicture take() && { return std::move(picture_); }

private:
    RgbPicture picture_;
};

/// The line, or as much of it as fits in `width` pixels of the font and dots.
std::string shortened(std::string_view line, int width);

/// Luminance of three display values.
float greyOf(const std::uint8_t* rgb);

/// @param greyShare  0: the colour alone, 1: the grey alone
Rgb8 mixed(const Rgb8& color, float grey, float greyShare);

/// Display values as bytes; what is not a number is black.
/// @param rgba  interleaved, as DisplayTransform::apply() leaves them
std::vector<std::uint8_t> rgbBytes(std::span<const float> rgba);

}  // namespace umbrage
