// SPDX-License-Identifier: Apache-2.0
// See count_band.h. Included by one file for each instruction set. Nothing here may come from the standard library: the
// linker keeps one copy of what several files instantiate.

#include "lanes.inl"

namespace umbrage {
namespace {

constexpr int kTileVectors = kTilePixels / kLanes, kBlockVectors = kBlockTiles / kLanes;

constexpr Floats kCount{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
constexpr Floats kColumn{0, 1, 2, 3, 4, 5, 6, 7, 0, 1, 2, 3, 4, 5, 6, 7};
constexpr Floats kRow{0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1};

inline float least(float a, float b) {
    return a < b ? a : b;
}

inline float most(float a, float b) {
    return a > b ? a : b;
}

/// A function over squares of pixels, in float.
struct OverSquares {
    float x, y;         // per pixel
    float least, most;  // over a square, from its first pixel
    float margin;

    OverSquares(const TilePolygon& polygon, int i, float pixels)
        : x(float(polygon.functions[i].x)), y(float(polygon.functions[i].y)), margin(polygon.margins[i]) {
        const float across = x * (pixels - 1.0f), down = y * (pixels - 1.0f);
        least = umbrage::least(across, 0.0f) + umbrage::least(down, 0.0f);
        most = umbrage::most(across, 0.0f) + umbrage::most(down, 0.0f);
    }
};

inline double valueAt(const PixelFunction& f, int column, int row) {
    return f.x * column + f.y * row + f.c;
}

/// Squares that a polygon touches where it may be before something, and those that it covers wholly before everything.
struct Touched {
    std::uint32_t some, all;
};

/// @param first  value of each function at the first pixel of every square
inline Touched touch(const Floats (&first)[kTileFunctions], const OverSquares* over, Floats farthest, Floats nearest) {
    constexpr int d = kTileBorders;
    Ints some = first[d] + (over[d].most + over[d].margin) > farthest;
    Ints all = first[d] + (over[d].least - over[d].margin) > nearest;
    for (int i = 0; i < kTileBorders; ++i) {
        some &= first[i] + (over[i].most + over[i].margin) >= 0.0f;
        all &= first[i] + (over[i].least - over[i].margin) > 0.0f;
    }
    const std::uint32_t whole = bitsOf(some & all);
    return {bitsOf(some) & ~whole, whole};
}

/// Whether a light's range ends before a tile.
inline bool isBeyond(const Band& band, const TileBox& box) {
    float d2 = 0.0f;
    for (int k = 0; k < 3; ++k) {
        const float slack = 1e-5f * (most(box.high[k], -box.low[k]) + most(band.light[k], -band.light[k]));
        const float d = most(most(box.low[k] - band.light[k], band.light[k] - box.high[k]) - slack, 0.0f);
        d2 += d * d;
    }
    return d2 > band.range2;
}

/// Which pixels may be lit, and how deep they lie.
inline void findActive(const Band& band) {
    const BandScratch& s = band.scratch;
    for (int block = 0; block < band.columns; ++block) {
        float blockFarthest = kInfinity, blockNearest = -kInfinity;
        for (int t = block * kBlockTiles; t < (block + 1) * kBlockTiles; ++t) {
            s.active[t] = 0;
            s.tileFarthest[t] = kInfinity;
            s.tileNearest[t] = -kInfinity;
            if (isBeyond(band, band.boxes[t])) continue;
            std::uint64_t active = 0;
            Floats farthest = Floats{} + kInfinity, nearest = Floats{} - kInfinity;
            for (int v = 0; v < kTileVectors; ++v) {
                const std::size_t at = std::size_t(t) * kTilePixels + std::size_t(v * kLanes);
                const Ints lit = (load<Ints>(band.lit + at) & std::int32_t(band.lightBit)) != 0;
                const Floats depth = load<Floats>(band.depths + at);
                active |= std::uint64_t(bitsOf(lit)) << (v * kLanes);
                farthest = lit & (depth < farthest) ? depth : farthest;
                nearest = lit & (depth > nearest) ? depth : nearest;
            }
            float low = kInfinity, high = -kInfinity;
            for (int i = 0; i < kLanes; ++i) {
                low = least(low, farthest[i]);
                high = most(high, nearest[i]);
            }
            s.active[t] = active;
            s.tileFarthest[t] = low;
            s.tileNearest[t] = high;
            blockFarthest = least(blockFarthest, low);
            blockNearest = most(blockNearest, high);
        }
        s.blockFarthest[block] = blockFarthest;
        s.blockNearest[block] = blockNearest;
    }
}

/// Which blocks of the row some polygons touch.
inline void bin(const Band& band, std::size_t firstPolygon, std::size_t endPolygon) {
    const BandScratch& s = band.scratch;
    for (int block = 0; block < band.columns; ++block) s.listSizes[block] = 0;
    for (std::size_t k = firstPolygon; k < endPolygon; ++k) {
        const TilePolygon& polygon = band.polygons[k];
        if ((polygon.rows >> (band.row < 63 ? band.row : 63) & 1u) == 0) continue;
        const OverSquares over[kTileFunctions]{
            {polygon, 0, kBlockSize}, {polygon, 1, kBlockSize}, {polygon, 2, kBlockSize}, {polygon, 3, kBlockSize}};
        for (int block = 0; block < band.columns; block += kLanes) {
            Floats first[kTileFunctions];
            for (int i = 0; i < kTileFunctions; ++i) {
                const auto start = float(valueAt(polygon.functions[i], block * kBlockSize, band.row * kBlockSize));
                first[i] = start + over[i].x * kBlockSize * kCount;
            }
            Touched touched =
                touch(first, over, load<Floats>(s.blockFarthest + block), load<Floats>(s.blockNearest + block));
            for (; touched.some != 0; touched.some &= touched.some - 1) {
                const int at = block + __builtin_ctz(touched.some);
                s.lists[std::size_t(at) * BandScratch::kPolygonsAtOnce + s.listSizes[at]++] = std::uint32_t(k);
            }
            if (touched.all != 0 && band.touching != nullptr) band.touching[k] = 1;
            for (; touched.all != 0; touched.all &= touched.all - 1) {
                std::int32_t* counts = s.tileCounts + (block + __builtin_ctz(touched.all)) * kBlockTiles;
                for (int v = 0; v < kBlockVectors; ++v)
                    store(counts + v * kLanes, load<Ints>(counts + v * kLanes) + polygon.crossing);
                ++band.work->pixels;
            }
        }
    }
}

/// A polygon within a tile, pixel by pixel.
/// @return  lanes that changed
inline std::uint32_t countPixels(const TilePolygon& polygon, const Floats (&pattern)[kTileFunctions], int column,
                                 int row, const float* depths, std::int32_t* counts) {
    Floats value[kTileFunctions];
    float down[kTileFunctions];
    for (int i = 0; i < kTileFunctions; ++i) {
        value[i] = pattern[i] + float(valueAt(polygon.functions[i], column, row));
        down[i] = 2.0f * float(polygon.functions[i].y);
    }
    Ints any{};
    for (int v = 0; v < kTileVectors; ++v) {
        Floats inside = value[0] + float(v) * down[0];
        for (int i = 1; i < kTileBorders; ++i) inside = smaller(inside, value[i] + float(v) * down[i]);
        Ints changed = value[kTileBorders] + float(v) * down[kTileBorders] > load<Floats>(depths + v * kLanes);
        changed &= inside > 0.0f;
        std::uint32_t near = bitsOf(magnitude(inside) <= kBorderRounding);
        for (; near != 0; near &= near - 1) {
            const int lane = __builtin_ctz(near);
            const float depth = depths[v * kLanes + lane];
            changed[lane] = isBehind(polygon, column + lane % 8, row + 2 * v + lane / 8, depth) ? -1 : 0;
        }
        store(counts + v * kLanes, load<Ints>(counts + v * kLanes) + (changed & polygon.crossing));
        any |= changed;
    }
    return bitsOf(any);
}

inline void countBlock(const Band& band, int block) {
    const BandScratch& s = band.scratch;
    const std::uint32_t* list = s.lists + std::size_t(block) * BandScratch::kPolygonsAtOnce;
    const int left = block * kBlockSize, top = band.row * kBlockSize;
    for (std::uint32_t k = 0; k < s.listSizes[block]; ++k) {
        const TilePolygon& polygon = band.polygons[list[k]];
        const OverSquares over[kTileFunctions]{
            {polygon, 0, kTileSize}, {polygon, 1, kTileSize}, {polygon, 2, kTileSize}, {polygon, 3, kTileSize}};
        Floats pattern[kTileFunctions], tiles[kTileFunctions];
        for (int i = 0; i < kTileFunctions; ++i) {
            pattern[i] = over[i].x * kColumn + over[i].y * kRow;
            tiles[i] = float(valueAt(polygon.functions[i], left, top)) + pattern[i] * kTileSize;
        }
        std::uint64_t some = 0;
        std::uint32_t changed = 0;
        for (int v = 0; v < kBlockVectors; ++v) {
            const int first = block * kBlockTiles + v * kLanes;
            Floats here[kTileFunctions];
            for (int i = 0; i < kTileFunctions; ++i) here[i] = tiles[i] + over[i].y * float(2 * v * kTileSize);
            const Touched touched =
                touch(here, over, load<Floats>(s.tileFarthest + first), load<Floats>(s.tileNearest + first));
            some |= std::uint64_t(touched.some) << (v * kLanes);
            if (touched.all == 0) continue;
            changed = 1;
            for (int t = 0; t < kLanes; ++t) {
                if ((touched.all >> t & 1u) != 0) s.tileCounts[first + t] += polygon.crossing;
            }
            band.work->pixels += std::uint64_t(__builtin_popcount(touched.all));
        }
        band.work->tiles += std::uint64_t(__builtin_popcountll(some));
        for (; some != 0; some &= some - 1) {
            const int tile = __builtin_ctzll(some);
            const std::size_t at = std::size_t(block * kBlockTiles + tile) * kTilePixels;
            changed |= countPixels(polygon, pattern, left + tile % 8 * kTileSize, top + tile / 8 * kTileSize,
                                   band.depths + at, s.counts + at);
        }
        if (changed != 0 && band.touching != nullptr) band.touching[list[k]] = 1;
    }
}

/// Where counts are not zero.
inline void mark(const Band& band) {
    const BandScratch& s = band.scratch;
    for (int t = 0; t < band.columns * kBlockTiles; ++t) {
        if (s.active[t] == 0 && band.counts == nullptr) continue;
        for (int v = 0; v < kTileVectors; ++v) {
            const std::size_t at = std::size_t(t) * kTilePixels + std::size_t(v * kLanes);
            const Ints count = load<Ints>(s.counts + at) + s.tileCounts[t];
            std::uint32_t* dark = band.dark + at;
            store(dark, load<Ints>(dark) | ((count != 0) & std::int32_t(band.lightBit)));
            if (band.counts != nullptr) store(band.counts + at, count);
        }
    }
}

inline void countBandOf(const Band& band) {
    const BandScratch& s = band.scratch;
    findActive(band);
    __builtin_memset(s.counts, 0, std::size_t(band.columns) * kBlockPixels * sizeof(std::int32_t));
    for (int t = 0; t < band.columns * kBlockTiles; ++t) s.tileCounts[t] = band.start;
    for (std::size_t k = 0; k < band.polygonCount; k += BandScratch::kPolygonsAtOnce) {
        const std::size_t end =
            k + BandScratch::kPolygonsAtOnce < band.polygonCount ? k + BandScratch::kPolygonsAtOnce : band.polygonCount;
        bin(band, k, end);
        for (int block = 0; block < band.columns; ++block) countBlock(band, block);
    }
    const std::size_t first = std::size_t(band.row) * std::size_t(band.columns) * kBlockPixels;
    for (std::size_t k = 0; k < band.sampleCount; ++k) {
        s.counts[band.samples[k].index - first] += band.samples[k].crossing;
    }
    mark(band);
}

}  // namespace
}  // namespace umbrage
