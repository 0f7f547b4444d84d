// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "report/error_picture.h"

namespace umbrage {
namespace {

/// Sums over rectangles of a plane, in constant time each.
class Sums {
public:
    template <class Weight>
    Sums(int width, int height, Weight weight) : stride_(std::size_t(width) + 1) {
        sums_.resize(stride_ * (std::size_t(height) + 1));
        for (int y = 0; y < height; ++y) {
            std::uint64_t row = 0;
            for (int x = 0; x < width; ++x) {
                row += weight(std::size_t(y) * std::size_t(width) + std::size_t(x));
                at(x + 1, y + 1) = at(x + 1, y) + row;
            }
        }
    }

    std::uint64_t of(const PixelRectangle& r) {
        return at(r.x + r.width, r.y + r.height) + at(r.x, r.y) - at(r.x + r.width, r.y) - at(r.x, r.y + r.height);
    }

private:
    std::uint64_t& at(int x, int y) { return sums_[std::size_t(y) * stride_ + std::size_t(x)]; }

    std::size_t stride_;
    std::vector<std::uint64_t> sums_;
};

}  // namespace

PixelRectangle worstPlace(std::span<const SampleVerdict> verdicts, int width, int height, int wantedWidth,
                          int wantedHeight) {
    const int w = std::min(width, wantedWidth), h = std::min(height, wantedHeight);
    const bool anyHard = std::any_of(verdicts.begin(), verdicts.end(), isHard);
    const auto counts = [&](std::size_t i) {
        return anyHard ? isHard(verdicts[i]) : verdicts[i] != SampleVerdict::Right;
    };
    Sums sums(width, height, counts);
    PixelRectangle densest{0, 0, w, h};
    std::uint64_t most = 0;
    for (int y = 0; y + h <= height; ++y) {
        for (int x = 0; x + w <= width; ++x) {
            const PixelRectangle candidate{x, y, w, h};
            const std::uint64_t found = sums.of(candidate);
            if (found > most) {
                most = found;
                densest = candidate;
            }
        }
    }
    if (most == 0) return {(width - w) / 2, (height - h) / 2, w, h};

    int left = width, right = 0, top = height, bottom = 0;
    for (int y = densest.y; y < densest.y + h; ++y) {
        for (int x = densest.x; x < densest.x + w; ++x) {
            if (!counts(std::size_t(y) * std::size_t(width) + std::size_t(x))) continue;
            left = std::min(left, x);
            right = std::max(right, x);
            top = std::min(top, y);
            bottom = std::max(bottom, y);
        }
    }
    return {std::clamp((left + right + 1 - w) / 2, 0, width - w), std::clamp((top + bottom + 1 - h) / 2, 0, height - h),
            w, h};
}

}  // namespace umbrage
