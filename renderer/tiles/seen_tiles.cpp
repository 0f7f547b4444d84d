// SPDX-License-Identifier: Apache-2.0
#include "tiles/seen_tiles.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace umbrage {
namespace {

/// Share of its depth by which a surface may be off the depth buffer.
constexpr float kTolerance = 0x1p-8f;

/// Depth of a plane where a view ray (x, y, -1) meets it.
float depthOnPlane(const glm::vec4& plane, float x, float y, bool perspective) {
    if (perspective) return (plane.z - plane.x * x - plane.y * y) / plane.w;
    return -(plane.x * x + plane.y * y + plane.w) / plane.z;
}

}  // namespace

SeenTiles::SeenTiles(int width, int height)
    : width_(width),
      height_(height),
      columns_((width + kBlockSize - 1) / kBlockSize),
      rows_((height + kBlockSize - 1) / kBlockSize),
      depths_(std::size_t(columns_) * std::size_t(rows_) * kBlockPixels),
      lit_(depths_.size()) {}

template <class Visit>
void SeenTiles::forTileRows(const Visit& visit) const {
    tbb::parallel_for(0, rows_, [&](int blockRow) {
        const int bottom = std::min(height_, (blockRow + 1) * kBlockSize);
        for (int y = blockRow * kBlockSize; y < bottom; ++y) {
            const int row = y % kBlockSize;
            for (int x = 0; x < width_; x += kTileSize) {
                const int block = blockRow * columns_ + x / kBlockSize;
                const int tile = row / kTileSize * 8 + x % kBlockSize / kTileSize;
                visit(std::size_t(block * kBlockTiles + tile) * kTilePixels + std::size_t(row % kTileSize * kTileSize),
                      x, y, std::min(kTileSize, width_ - x));
            }
        }
    });
}

void SeenTiles::set(const SeenPicture& picture, const TileEye& eye) {
    const float scale = float(picture.depthScale), offset = float(picture.depthOffset);
    const auto ray = [](double rayScale, double at, int size) { return float(rayScale * (2.0 * at / size - 1.0)); };
    std::vector<float> rayX(static_cast<std::size_t>(width_));
    for (int x = 0; x < width_; ++x) rayX[std::size_t(x)] = ray(eye.rayScale.x, x + eye.sample.x, width_);
    forTileRows([&](std::size_t here, int x, int y, int count) {
        const float rayY = -ray(eye.rayScale.y, y + eye.sample.y, height_);
        const std::size_t there = std::size_t(y) * std::size_t(width_) + std::size_t(x);
        for (std::size_t i = 0; i < std::size_t(count); ++i) {
            const std::uint32_t triangle = picture.triangles[there + i];
            const float depth = picture.depths[there + i], stored = depth * scale + offset;
            if (triangle == picture.noTriangle || depth == picture.emptyDepth) {
                depths_[here + i] = stored;
                lit_[here + i] = 0;
                continue;
            }
            const glm::vec4 plane = picture.planes[triangle];
            const float exact = depthOnPlane(plane, rayX[std::size_t(x) + i], rayY, eye.perspective);
            depths_[here + i] = std::abs(exact - stored) < kTolerance * std::abs(stored) ? exact : stored;
            const glm::uvec2 sides = picture.facing[triangle];
            lit_[here + i] = (eye.perspective ? plane.w : plane.z) > 0.0f ? sides.x : sides.y;
        }
    });
}

void SeenTiles::lightAll() {
    std::ranges::fill(lit_, ~0u);
}

template <class T>
void SeenTiles::toRows(const T* tiles, T* rows) const {
    forTileRows([&](std::size_t here, int x, int y, int count) {
        std::copy_n(tiles + here, count, rows + std::size_t(y) * std::size_t(width_) + std::size_t(x));
    });
}

template void SeenTiles::toRows(const std::uint32_t*, std::uint32_t*) const;
template void SeenTiles::toRows(const std::int32_t*, std::int32_t*) const;

}  // namespace umbrage
