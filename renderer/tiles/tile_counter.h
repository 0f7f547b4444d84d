// SPDX-License-Identifier: Apache-2.0
// Shadow counts of a whole picture, tile by tile: count `tiles`. Host code, no GL.
//
// z-pass with the constant of the eye, as a rasteriser of our own can do it (after Laine 2005, section 5, and Aila &
// Akenine-Möller 2004): a side that lies behind everything in a block or tile is dropped, one that covers it wholly and
// lies before everything changes one number, and only the others are looked at pixel by pixel. Needs no far ends,
// because what is behind everything costs nothing.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "tiles/seen_tiles.h"

namespace umbrage {

/// One light's volumes: their sides, and caps of what is not in the depth buffer.
struct TileLight {
    std::vector<TilePolygon> polygons;
    std::vector<TileSample> samples;                        // caps of what is missing there only; by ascending index
    std::int32_t start = 0;                                 // layers over the eye
    glm::vec3 position{0.0f};                               // in view space
    float range2 = std::numeric_limits<float>::infinity();  // of its range in metres, beyond which it lights nothing
    std::uint32_t bit = 1;                                  // in SeenTiles::lit(), and of what comes out
};

class TileCounter {
public:
    /// @param countBand  of count_band.h
    explicit TileCounter(CountBand* countBand = countBandHere()) : countBand_(countBand) {}

    /// Bits of the lights whose count is not zero at a pixel that they may light, tile by tile. As many threads as TBB
    /// has.
    const std::vector<std::uint32_t>& count(const SeenTiles& seen, std::span<const TileLight> lights);

    /// Counts of one light, tile by tile.
    /// @param seen  all of whose pixels may be lit by it
    std::vector<std::int32_t> countsOf(const SeenTiles& seen, const TileLight& light);

    /// Which polygons are before something that is seen and that any light may light: 1, else 0.
    std::vector<std::uint8_t> touching(const SeenTiles& seen, std::vector<TilePolygon> polygons);

    const TileWork& work() const { return work_; }  // of the last count

private:
    struct Wanted {
        std::int32_t* counts = nullptr;
        std::uint8_t* touching = nullptr;
    };
    void countAll(const SeenTiles& seen, std::span<const TileLight> lights, const Wanted& wanted);

    CountBand* countBand_;
    std::vector<std::uint32_t> dark_;
    TileWork work_;
};

}  // namespace umbrage
