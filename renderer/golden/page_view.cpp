// SPDX-License-Identifier: Apache-2.0
#include "golden/page_view.h"

#include <algorithm>
#include <cmath>

#include "image/srgb.h"

namespace umbrage {
namespace {

int channelNamed(const PagePicture& picture, const char* name) {
    const auto found = std::find(picture.channels.begin(), picture.channels.end(), name);
    return found == picture.channels.end() ? -1 : int(found - picture.channels.begin());
}

}  // namespace

PageView viewOf(const PagePicture& picture) {
    PageView view;
    view.alpha = channelNamed(picture, "A");
    const int red = channelNamed(picture, "R"), green = channelNamed(picture, "G"), blue = channelNamed(picture, "B");
    const bool isColor = red >= 0 && green >= 0 && blue >= 0;
    if (isColor) {
        view.shown = {red, green, blue};
    } else if (picture.channels.size() >= 3) {
        view.shown = {0, 1, 2};
    }
    view.isEncoded = isColor && !picture.isDisplayEncoded;
    if (isColor || picture.isDisplayEncoded) return view;

    float low = INFINITY, high = -INFINITY;
    const std::size_t channels = picture.channels.size();
    for (std::size_t pixel = 0; channels > 0 && pixel < picture.values.size(); pixel += channels) {
        for (const int c : view.shown) {
            const float value = picture.values[pixel + std::size_t(c)];
            if (!std::isfinite(value)) continue;
            low = std::min(low, value);
            high = std::max(high, value);
        }
    }
    if (low < high) {
        view.low = low;
        view.high = high;
    } else if (std::isfinite(low)) {  // all the same: 0 is black, all else white
        view.low = std::min(low, 0.0f);
        view.high = low > 0.0f ? low : view.low + 1.0f;
    }
    return view;
}

std::vector<float> displayRgba(const PagePicture& picture, const PageView& view) {
    const std::size_t channels = picture.channels.size();
    const std::size_t pixels = std::size_t(picture.width) * std::size_t(picture.height);
    std::vector<float> rgba;
    rgba.reserve(pixels * 4);
    for (std::size_t p = 0; p < pixels; ++p) {
        const float* values = &picture.values[p * channels];
        const bool isNumber = std::none_of(view.shown.begin(), view.shown.end(),
                                           [&](int c) { return std::isnan(values[std::size_t(c)]); });
        for (std::size_t i = 0; i < 3; ++i) {
            const float share = (values[view.shown[i]] - view.low) / (view.high - view.low);
            const float clamped = std::clamp(share, 0.0f, 1.0f);
            rgba.push_back(!isNumber ? (i == 1 ? 0.0f : 1.0f) : view.isEncoded ? displayEncoded(clamped) : clamped);
        }
        rgba.push_back(view.alpha < 0 ? 1.0f : values[view.alpha]);
    }
    return rgba;
}

}  // namespace umbrage
