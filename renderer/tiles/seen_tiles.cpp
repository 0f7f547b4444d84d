// SPDX-License-Identifier: Apache-2.0
#include "tiles/seen_tiles.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace umbrage {
namespace {

/// What one row of pixels is seen with.
struct RowView {
    const float* rayX;
    float rayY;
    bool perspective;
    float scale, offset;  // of SeenPicture's depths
    std::uint32_t noTriangle;
    float emptyDepth;
};

/// A surface's depth and the lights it faces, without a branch, so that the compiler makes SIMD of it.
/// @param planes  four values a triangle
/// @param facing  two
__attribute__((target_clones("avx512f", "avx2", "default"))) void seeRow(
    const RowView& view, std::size_t count, const std::uint32_t* __restrict triangles, const float* __restrict depths,
    const float* __restrict planes, const std::uint32_t* __restrict facing, float* __restrict outDepths,
    std::uint32_t* __restrict outLit) {
    constexpr float kTolerance = 0x1p-8f;  // share of its depth by which a surface may be off the depth buffer
    const float one = view.perspective ? 1.0f : 0.0f;
    for (std::size_t i = 0; i < count; ++i) {
        const float stored = depths[i] * view.scale + view.offset;
        const bool seen = triangles[i] != view.noTriangle && depths[i] != view.emptyDepth;
        const std::uint32_t triangle = seen ? triangles[i] : 0u;
        const float nx = planes[4u * triangle], ny = planes[4u * triangle + 1u], nz = planes[4u * triangle + 2u],
                    w = planes[4u * triangle + 3u];
        // Where a view ray (x, y, -1) meets the plane; of an orthographic eye (0, 0, -1) from (x, y).
        const float across = nx * view.rayX[i] + ny * view.rayY;
        const float exact = one != 0.0f ? (nz - across) / w : -(across + w) / nz;
        const float off = exact - stored, most = kTolerance * (stored < 0.0f ? -stored : stored);
        outDepths[i] = seen && off < most && -off < most ? exact : stored;
        const bool front = (one != 0.0f ? w : nz) > 0.0f;
        const std::uint32_t lit = facing[2u * triangle + (front ? 0u : 1u)];
        outLit[i] = seen ? lit : 0u;
    }
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

std::size_t SeenTiles::indexOf(int column, int row) const {
    const int block = row / kBlockSize * columns_ + column / kBlockSize;
    const int tile = row % kBlockSize / kTileSize * 8 + column % kBlockSize / kTileSize;
    return std::size_t(block * kBlockTiles + tile) * kTilePixels +
           std::size_t(row % kTileSize * kTileSize + column % kTileSize);
}

template <class Visit>
void SeenTiles::forTilesOfRow(int y, const Visit& visit) const {
    for (int x = 0; x < width_; x += kTileSize) visit(indexOf(x, y), x, std::min(kTileSize, width_ - x));
}

void SeenTiles::set(const SeenPicture& picture, const TileEye& eye) {
    eye_ = eye;
    if (picture.planes.empty()) {  // no triangles: nothing is lit
        std::ranges::fill(lit_, 0u);
        findBounds();
        return;
    }
    const auto ray = [](double rayScale, double at, int size) { return float(rayScale * (2.0 * at / size - 1.0)); };
    std::vector<float> rayX(static_cast<std::size_t>(width_));
    for (int x = 0; x < width_; ++x) rayX[std::size_t(x)] = ray(eye.rayScale.x, x + eye.sample.x, width_);
    const float* planes = &picture.planes.data()->x;
    const std::uint32_t* facing = &picture.facing.data()->x;
    const auto columns = std::size_t(width_);
    tbb::parallel_for(0, height_, [&](int y) {
        thread_local std::vector<float> depths;
        thread_local std::vector<std::uint32_t> lit;
        depths.resize(columns);
        lit.resize(columns);
        const RowView view{rayX.data(),
                           -ray(eye.rayScale.y, y + eye.sample.y, height_),
                           eye.perspective,
                           float(picture.depthScale),
                           float(picture.depthOffset),
                           picture.noTriangle,
                           picture.emptyDepth};
        const std::size_t first = std::size_t(y) * columns;
        seeRow(view, columns, &picture.triangles[first], &picture.depths[first], planes, facing, depths.data(),
               lit.data());
        forTilesOfRow(y, [&](std::size_t here, int x, int count) {
            std::copy_n(&depths[std::size_t(x)], count, &depths_[here]);
            std::copy_n(&lit[std::size_t(x)], count, &lit_[here]);
        });
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
    const glm::dvec2 from = eye.sample - 0.5;
    const double left = ndc(column, from.x, eye.width), right = ndc(column + kTileSize, from.x, eye.width);
    const double top = ndc(row, from.y, eye.height), bottom = ndc(row + kTileSize, from.y, eye.height);
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
    tbb::parallel_for(0, height_, [&](int y) {
        T* row = rows + std::size_t(y) * std::size_t(width_);
        forTilesOfRow(y, [&](std::size_t here, int x, int count) { std::copy_n(tiles + here, count, row + x); });
    });
}

template void SeenTiles::toRows(const std::uint32_t*, std::uint32_t*) const;
template void SeenTiles::toRows(const std::int32_t*, std::int32_t*) const;

}  // namespace umbrage
