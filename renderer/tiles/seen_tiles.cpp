// SPDX-License-Identifier: Apache-2.0
#include "tiles/seen_tiles.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

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
      lit_(depths_.size()),
      farthest_(depths_.size() / kTilePixels),
      boxes_(farthest_.size()),
      tileColumns_(columns_ * (kBlockSize / kTileSize)) {}

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
    eye_ = eye;
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
    findBounds();
}

namespace {

/// Least and greatest of a coordinate that is a share of the distance, or for an orthographic eye the same anywhere.
void spread(double from, double to, double near, double far, bool perspective, float& low, float& high) {
    const double a = perspective ? near : 1.0, b = perspective ? far : 1.0;
    const auto [least, most] = std::minmax({from * a, from * b, to * a, to * b});
    low = float(least), high = float(most);
}

/// Around the pixels of a tile, from the nearest to the farthest depth in it, in view space.
TileBox boxOf(const TileEye& eye, int column, int row, float nearest, float farthest) {
    const auto ndc = [](int pixel, double within, int size) { return 2.0 * (pixel + within) / size - 1.0; };
    // Half a pixel more on either side than the samples need.
    const double left = ndc(column, 0.0, eye.width), right = ndc(column + kTileSize, 0.0, eye.width);
    const double top = ndc(row, 0.0, eye.height), bottom = ndc(row + kTileSize, 0.0, eye.height);
    const double near = eye.perspective ? 1.0 / nearest : -nearest, far = eye.perspective ? 1.0 / farthest : -farthest;
    TileBox box;
    spread(left * eye.rayScale.x, right * eye.rayScale.x, near, far, eye.perspective, box.low[0], box.high[0]);
    spread(-bottom * eye.rayScale.y, -top * eye.rayScale.y, near, far, eye.perspective, box.low[1], box.high[1]);
    box.low[2] = -float(far), box.high[2] = -float(near);
    return box;
}

}  // namespace

/// Once all pixels are set.
void SeenTiles::findBounds() {
    tbb::parallel_for(0, columns_ * rows_, [&](int block) {
        for (int tile = 0; tile < kBlockTiles; ++tile) {
            const std::size_t at = std::size_t(block * kBlockTiles + tile), first = at * kTilePixels;
            float farthest = std::numeric_limits<float>::infinity(), nearest = -farthest;
            for (std::size_t i = first; i < first + kTilePixels; ++i) {
                farthest = std::min(farthest, lit_[i] != 0 ? depths_[i] : std::numeric_limits<float>::infinity());
                nearest = std::max(nearest, lit_[i] != 0 ? depths_[i] : -std::numeric_limits<float>::infinity());
            }
            const int x = block % columns_ * 8 + tile % 8, y = block / columns_ * 8 + tile / 8;
            farthest_[std::size_t(y) * std::size_t(tileColumns_) + std::size_t(x)] = farthest;
            boxes_[at] = nearest < farthest ? TileBox{} : boxOf(eye_, x * kTileSize, y * kTileSize, nearest, farthest);
        }
    });
}

bool SeenTiles::isBefore(const glm::dvec2& low, const glm::dvec2& high, float depth) const {
    const auto tileAt = [](double pixel, int tiles) { return int(std::clamp(pixel / kTileSize, 0.0, tiles - 1.0)); };
    if (high.x < 0.0 || high.y < 0.0 || low.x > width_ || low.y > height_) return false;
    const int left = tileAt(low.x, tileColumns_), right = tileAt(high.x, tileColumns_);
    const int tileRows = rows_ * (kBlockSize / kTileSize);
    for (int y = tileAt(low.y, tileRows); y <= tileAt(high.y, tileRows); ++y) {
        const float* row = &farthest_[std::size_t(y) * std::size_t(tileColumns_)];
        for (int x = left; x <= right; ++x) {
            if (depth > row[x]) return true;
        }
    }
    return false;
}

void SeenTiles::lightAll() {
    std::ranges::fill(lit_, ~0u);
    findBounds();
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
