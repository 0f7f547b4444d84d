// SPDX-License-Identifier: Apache-2.0
#include "golden/perception.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace umbrage {
namespace {

/// The inverse of sRGB's transfer function (IEC 61966-2-1).
float linearOf(float encoded) {
    return encoded <= 0.04045f ? encoded / 12.92f : std::pow((encoded + 0.055f) / 1.055f, 2.4f);
}

std::array<const std::vector<float>*, 3> coloursOf(const StoredImage& image) {
    if (const auto* red = image.floats("R")) return {red, image.floats("G"), image.floats("B")};
    const auto* grey = image.floats("Y");
    return {grey, grey, grey};
}

bool same(float a, float b) {
    return a == b || (std::isnan(a) && std::isnan(b));
}

}  // namespace

bool hasColours(const StoredImage& image) {
    const auto colours = coloursOf(image);
    return std::all_of(colours.begin(), colours.end(), [](const auto* values) { return values != nullptr; });
}

Perception::Perception(const StoredImage& golden, const StoredImage& output, double pixelsPerDegree)
    : golden_(golden), output_(output), pixelsPerDegree_(pixelsPerDegree) {}

void Perception::see() {
    if (std::exchange(seen_, true)) return;
    const auto golden = coloursOf(golden_), output = coloursOf(output_);
    const bool encoded = golden_.displayEncoded;
    const std::size_t count = golden_.pixelCount();
    std::vector<std::uint8_t> spoiled(count);
    for (LinearPicture* picture : {&goldenColors_, &outputColors_}) {
        picture->width = golden_.data.width;
        picture->height = golden_.data.height;
        picture->rgb.resize(3 * count);
    }
    for (std::size_t c = 0; c < 3; ++c) {
        for (std::size_t i = 0; i < count; ++i) {
            const float a = (*golden[c])[i], b = (*output[c])[i];
            const bool finite = std::isfinite(a) && std::isfinite(b);
            if (!finite && !same(a, b)) spoiled[i] = 1;
            if (!finite) continue;  // both black
            goldenColors_.rgb[3 * i + c] = encoded ? linearOf(a) : a;
            outputColors_.rgb[3 * i + c] = a == b ? goldenColors_.rgb[3 * i + c] : encoded ? linearOf(b) : b;
        }
    }
    for (std::size_t i = 0; i < count; ++i) {
        if (!spoiled[i]) continue;
        spoiled_.push_back(i);
        std::copy_n(&goldenColors_.rgb[3 * i], 3, &outputColors_.rgb[3 * i]);  // counted once
    }
}

FlipMap Perception::withSpoiled(FlipMap map) const {
    for (const std::size_t i : spoiled_) map[i] = 1.0f;
    return map;
}

const FlipMap& Perception::flip() {
    see();
    if (!flip_) flip_ = withSpoiled(flipMap(goldenColors_, outputColors_, pixelsPerDegree_));
    return *flip_;
}

const FlipMap& Perception::hdrFlip() {
    see();
    if (!hdrFlip_) hdrFlip_ = withSpoiled(hdrFlipMap(goldenColors_, outputColors_, pixelsPerDegree_));
    return *hdrFlip_;
}

double Perception::yeeShare() {
    see();
    const std::size_t failures =
        codec().yeeFailures(goldenColors_.width, goldenColors_.height, goldenColors_.rgb, outputColors_.rgb);
    return std::min(1.0, double(failures + spoiled_.size()) / double(golden_.pixelCount()));
}

}  // namespace umbrage
