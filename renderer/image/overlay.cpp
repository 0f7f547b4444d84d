// SPDX-License-Identifier: Apache-2.0
#include "image/overlay.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>

#include "image/bitmap_font.h"
#include "image/false_color.h"

namespace umbrage {
namespace {

constexpr float kDimmed = 0.35f;      // of the beauty picture's grey, where nothing is counted
constexpr float kSeenThrough = 0.2f;  // of its grey under the colours: enough to see where one is, scale still legible

// The smallest 1, 2 or 5 times a power of ten whose numbers stand clear of each other; whole where counts are whole.
float tickStep(float scaleMaximum, int barWidth) {
    const int labelWidth = textWidth(fmt::format("{:g}", scaleMaximum)) + kGlyphAdvance;
    const float leastStep = scaleMaximum * static_cast<float>(labelWidth) / static_cast<float>(barWidth);
    const float least = scaleMaximum < 1.0f ? leastStep : std::max(leastStep, 1.0f);
    const float power = std::pow(10.0f, std::floor(std::log10(least)));
    for (const float factor : {1.0f, 2.0f, 5.0f}) {
        if (factor * power >= least) return factor * power;
    }
    return 10.0f * power;
}

// All lengths in font pixels, `scale` picture pixels each.
struct LegendLayout {
    static constexpr int kMargin = 4, kPadding = 4, kBarHeight = 7, kTick = 2, kGap = 3;
    static constexpr int kSwatch = 9, kSwatchGap = 12, kLeastBar = 72, kMostTitle = 220;
    static constexpr int kHeight = 2 * kPadding + kGlyphHeight + kGap + kBarHeight + kTick + 1 + kGlyphHeight;

    int scale, swatchPitch, barWidth, width;

    LegendLayout(int pictureHeight, std::string_view title, std::string_view aboveLabel) {
        scale = std::max(1, (pictureHeight + 192) / 384);
        swatchPitch = std::max(kSwatch, textWidth(aboveLabel)) + kSwatchGap;
        barWidth = std::max(kLeastBar, std::min(textWidth(title), kMostTitle) - 2 * swatchPitch);
        width = 2 * kPadding + barWidth + 2 * swatchPitch;
    }

    bool fits(int pictureWidth, int pictureHeight) const {
        return (width + 2 * kMargin) * scale <= pictureWidth && (kHeight + 2 * kMargin) * scale <= pictureHeight / 2;
    }
};

void drawLegend(Canvas& canvas, int pictureWidth, int pictureHeight, const FalseColor& colors,
                const OverlayStyle& style) {
    using L = LegendLayout;
    const std::string aboveLabel = fmt::format(">{:g}", style.scaleMaximum);
    const LegendLayout layout(pictureHeight, style.title, aboveLabel);
    if (!layout.fits(pictureWidth, pictureHeight)) return;

    const int s = layout.scale;
    const int panelTop = pictureHeight - (L::kMargin + L::kHeight) * s;
    canvas.fill(L::kMargin * s, panelTop, layout.width * s, L::kHeight * s, kPanel);
    const int left = (L::kMargin + L::kPadding) * s;
    const int titleTop = panelTop + L::kPadding * s;
    canvas.text(left, titleTop, s, shortened(style.title, layout.width - 2 * L::kPadding));

    const int barTop = titleTop + (kGlyphHeight + L::kGap) * s;
    const int labelTop = barTop + (L::kBarHeight + L::kTick + 1) * s;
    const auto swatch = [&](int x, float count, int columns) {
        for (int column = 0; column < columns; ++column) {
            for (int row = 0; row < L::kBarHeight * s; ++row) {
                canvas.set(x + column, barTop + row, colors.at(count, x + column, barTop + row));
            }
        }
    };

    // Half a pixel in, so that neither end of the bar is an exact 0 or off the scale.
    const int barPixels = layout.barWidth * s;
    for (int column = 0; column < barPixels; ++column) {
        const float along = (static_cast<float>(column) + 0.5f) / static_cast<float>(barPixels);
        swatch(left + column, along * style.scaleMaximum, 1);
    }
    const float step = tickStep(style.scaleMaximum, layout.barWidth);
    for (int i = 0; static_cast<float>(i) * step <= style.scaleMaximum * 1.0001f; ++i) {
        const float value = static_cast<float>(i) * step;
        const int x = left + static_cast<int>(value / style.scaleMaximum * static_cast<float>(barPixels - s) + 0.5f);
        canvas.fill(x, barTop + L::kBarHeight * s, s, L::kTick * s, kInk);
        canvas.centredText(x + s / 2, labelTop, s, fmt::format("{:g}", value));
    }

    const int pitch = layout.swatchPitch * s, swatchPixels = L::kSwatch * s;
    const int aboveCentre = left + barPixels + pitch / 2 + L::kSwatchGap * s / 2;
    swatch(aboveCentre - swatchPixels / 2, 2.0f * style.scaleMaximum, swatchPixels);
    canvas.centredText(aboveCentre, labelTop, s, aboveLabel);
    const int belowCentre = aboveCentre + pitch;
    swatch(belowCentre - swatchPixels / 2, -1.0f, swatchPixels);
    canvas.centredText(belowCentre, labelTop, s, "<0");
}

}  // namespace

RgbPicture drawOverlay(int width, int height, std::span<const float> counts, std::span<const std::uint8_t> beautyRgb,
                       const OverlayStyle& style) {
    assert(counts.size() == std::size_t(width) * height && style.scaleMaximum > 0.0f);
    assert(beautyRgb.empty() || beautyRgb.size() == 3 * counts.size());
    const FalseColor colors(style.scaleMaximum);
    Canvas canvas(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const std::size_t i = std::size_t(y) * width + x;
            const bool counted = counts[i] != 0.0f && !std::isnan(counts[i]);
            const Rgb8 color = counted ? colors.at(counts[i], x, y) : Rgb8{};
            if (beautyRgb.empty()) {
                canvas.set(x, y, color);
                continue;
            }
            canvas.set(x, y, mixed(color, greyOf(&beautyRgb[3 * i]), counted ? kSeenThrough : kDimmed));
        }
    }
    drawLegend(canvas, width, height, colors, style);
    return std::move(canvas).take();
}

}  // namespace umbrage
