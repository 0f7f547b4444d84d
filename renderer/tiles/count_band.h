// SPDX-License-Identifier: Apache-2.0
// The inner loops of the tile counter: one light's polygons over one row of blocks. The same source is compiled for
// several instruction sets (count_band.inl), which give the same bits: no sum of floats depends on the width of the
// vectors.
//
// Pixels are stored tile by tile: 8 x 8 pixels a tile, 8 x 8 tiles a block, blocks from left to right and then down.
#pragma once

#include <cstddef>
#include <cstdint>

#include "tiles/tile_polygon.h"

namespace umbrage {

inline constexpr int kTilePixels = kTileSize * kTileSize, kBlockTiles = 64, kBlockPixels = kBlockTiles * kTilePixels;

/// What a thread needs while it counts; of a row of blocks.
struct BandScratch {
    static constexpr std::size_t kPolygonsAtOnce = 1024;
    std::int32_t* counts;                                              // per pixel
    std::int32_t* tileCounts;                                          // per tile: of all its pixels
    float *tileFarthest, *tileNearest, *blockFarthest, *blockNearest;  // depths of the pixels that may be lit
    std::uint64_t* active;                                             // per tile: pixels that may be lit
    std::uint32_t* lists;      // kPolygonsAtOnce per block: polygons that touch it ...
    std::uint32_t* listSizes;  // ... and how many
};

/// How much was looked at; one drawn twice counts once.
struct TileWork {
    std::uint64_t tiles = 0;   // pairs of polygon and tile that had to be looked at pixel by pixel
    std::uint64_t pixels = 0;  // of them, and one for each pair that was decided as a whole
};

/// In view space; empty where low > high.
struct TileBox {
    float low[3]{1.0f, 1.0f, 1.0f}, high[3]{-1.0f, -1.0f, -1.0f};
};

/// A sample whose count changes by itself.
struct TileSample {
    std::uint32_t index;  // as pixels are stored, in the whole picture
    std::int32_t crossing;

    auto operator<=>(const TileSample&) const = default;
};

struct Band {
    const TilePolygon* polygons;
    std::size_t polygonCount;
    const TileSample* samples;  // of this row
    std::size_t sampleCount;
    std::int32_t start;  // the count at the eye
    std::uint32_t lightBit;
    float light[3];            // in view space
    float range2;              // of its range, beyond which it lights nothing; infinite
    int columns, row;          // of blocks
    const float* depths;       // of what is seen, of this row
    const TileBox* boxes;      // of tiles
    const std::uint32_t* lit;  // bits of lights that what is seen may be lit by
    std::uint32_t* dark;       // gets the light's bit where the count is not zero
    std::int32_t* counts;      // of all pixels, if wanted; else null
    std::uint8_t* touching;    // per polygon, if wanted: set where it changes some count
    BandScratch scratch;
    TileWork* work;  // is added to
};

using CountBand = void(const Band&);
CountBand countBandBaseline, countBandAvx2, countBandAvx512;

/// The widest that this processor has.
CountBand* countBandHere();

}  // namespace umbrage
