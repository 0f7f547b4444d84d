// SPDX-License-Identifier: Apache-2.0
#include "image/false_color.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "image/srgb.h"

namespace umbrage {
namespace {

constexpr float kDarkest = 0.34f, kLightest = 0.92f;  // OKLab lightness: off black and off white
constexpr float kFirstHueDegrees = 305.0f, kLastHueDegrees = 103.0f;
constexpr float kChroma = 0.145f;
constexpr Rgb8 kBelow{214, 64, 48}, kBelowStripe{255, 190, 176};
constexpr Rgb8 kAbove{255, 255, 255}, kAboveStripe{120, 120, 120};

std::uint8_t displayCode(float linear) {
    return static_cast<std::uint8_t>(displayEncoded(std::clamp(linear, 0.0f, 1.0f)) * 255.0f + 0.5f);
}

std::array<float, 3> linearFromOklab(float lightness, float a, float b) {
    const auto cube = [](float v) { return v * v * v; };
    const float l = cube(lightness + 0.3963377774f * a + 0.2158037573f * b);
    const float m = cube(lightness - 0.1055613458f * a - 0.0638541728f * b);
    const float s = cube(lightness - 0.0894841775f * a - 1.2914855480f * b);
    return {4.0767416621f * l - 3.3077115913f * m + 0.2309699292f * s,
            -1.2684380046f * l + 2.6097574011f * m - 0.3413193965f * s,
            -0.0041960863f * l - 0.7034186147f * m + 1.7076147010f * s};
}

// Chroma shrinks until the colour exists on an sRGB display, so that clipping bends neither hue nor lightness.
Rgb8 displayable(float lightness, float hueRadians) {
    for (float chroma = kChroma;; chroma -= 0.005f) {
        const auto rgb = linearFromOklab(lightness, chroma * std::cos(hueRadians), chroma * std::sin(hueRadians));
        const auto [low, high] = std::minmax_element(rgb.begin(), rgb.end());
        if ((*low >= 0.0f && *high <= 1.0f) || chroma <= 0.0f) {
            return {displayCode(rgb[0]), displayCode(rgb[1]), displayCode(rgb[2])};
        }
    }
}

}  // namespace

FalseColor::FalseColor(float scaleMaximum) : scaleMaximum_(scaleMaximum) {
    constexpr float kRadiansPerDegree = 0.017453292f;
    for (std::size_t i = 0; i < table_.size(); ++i) {
        const float t = static_cast<float>(i) / static_cast<float>(table_.size() - 1);
        const float hueDegrees = std::lerp(kFirstHueDegrees, kLastHueDegrees, t);
        table_[i] = displayable(std::lerp(kDarkest, kLightest, t), hueDegrees * kRadiansPerDegree);
    }
}

Rgb8 FalseColor::at(float count, int x, int y) const {
    const bool stripe = ((x + y) & 3) == 0;
    if (count < 0.0f) return stripe ? kBelowStripe : kBelow;
    if (count > scaleMaximum_) return stripe ? kAboveStripe : kAbove;
    const float last = static_cast<float>(table_.size() - 1);
    return table_[static_cast<std::size_t>(count / scaleMaximum_ * last + 0.5f)];
}

}  // namespace umbrage
