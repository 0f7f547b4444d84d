// SPDX-License-Identifier: Apache-2.0
// What a rasteriser that culls whole tiles of 8 x 8 pixels would do for a light's shadow volumes (Laine 2005, section
// 5), counted exactly, by every way of choosing between z-pass and z-fail. Host code, no GL.
//
// A pair of polygon and tile is culled where the depths of the two say that no count in the tile changes. What is left
// is processed pixel by pixel; with whole-tile counters, a polygon that covers a tile completely and lies wholly before
// or behind it changes one number instead, and for a block of 64 x 64 pixels likewise (after Aila & Akenine-Möller
// 2004).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "bench/depth_bounds.h"
#include "bench/tile_polygons.h"
#include "shadow/split_plane.h"

namespace umbrage {

struct TileMethod {
    enum class Choice {
        Pass,
        Fail,
        PlaneFarthest,  // the split test of the tile's farthest depth, as the paper has it
        PlaneNearest,
        Cheaper,  // whatever leaves fewer pixels to process, counted for each caster and tile
    };
    std::string_view name, doc;
    Choice choice = Choice::Pass;
    bool depthBounds = false, wholeTiles = false;
};

inline constexpr std::array kTileMethods = {
    TileMethod{"ZP+DB", "z-pass, near correction, depth bounds of each caster", TileMethod::Choice::Pass, true},
    TileMethod{"ZF+DB", "z-fail, depth bounds of each caster", TileMethod::Choice::Fail, true},
    TileMethod{"SPSV", "split planes, against the farthest depth of a tile", TileMethod::Choice::PlaneFarthest},
    TileMethod{"SPSVnear", "split planes, against the nearest depth of a tile", TileMethod::Choice::PlaneNearest},
    TileMethod{"best", "the cheaper of z-pass and z-fail for each caster and tile", TileMethod::Choice::Cheaper},
    TileMethod{"ZP", "z-pass, near correction", TileMethod::Choice::Pass},
    TileMethod{"ZF", "z-fail", TileMethod::Choice::Fail},
    TileMethod{"ZP/H", "ZP with counters of whole tiles", TileMethod::Choice::Pass, false, true},
    TileMethod{"ZF/H", "ZF with counters of whole tiles", TileMethod::Choice::Fail, false, true},
    TileMethod{"SPSV/H", "SPSV with counters of whole tiles", TileMethod::Choice::PlaneFarthest, false, true},
    TileMethod{"best/H", "best with counters of whole tiles", TileMethod::Choice::Cheaper, false, true},
};

/// Of one method. Drawing a polygon twice counts two.
struct TileFigures {
    std::uint64_t processedTiles = 0;  // pairs of polygon and tile with a pixel that it covers
    std::uint64_t tiles = 0;           // of them, those that are not culled
    std::uint64_t pixels = 0;          // processed in those; with whole-tile counters each of these is one
    std::uint64_t updates = 0;         // of counts, likewise
    std::uint64_t different = 0;       // pixels whose count of some caster is not that of the first method: must be 0

    TileFigures& operator+=(const TileFigures& other);
};
using TileFiguresOfMethods = std::array<TileFigures, kTileMethods.size()>;

/// A caster's volume, ready for counting.
struct TileVolume {
    std::vector<TilePolygon> polygons;
    DepthBounds bounds;
    ScreenPlane split;
};

TileVolume tileVolume(const TileCaster& caster, const glm::dvec4& light, const SplitChoice& choice, const Eye& eye,
                      const TileView& view);

struct TileCounts {
    TileFiguresOfMethods methods;
    std::vector<std::int32_t> layers;                   // volumes around what each pixel sees
    std::vector<std::vector<std::uint16_t>> processed;  // per method: how often each pixel is processed, if asked
};

/// @param inverseDepths  of what each pixel sees, 1/metre along the view axis, rows from the top; 0: infinitely far
/// @param planes  fill TileCounts::processed
TileCounts countTiles(std::span<const TileVolume> volumes, std::span<const double> inverseDepths, const TileView& view,
                      bool planes, int threads);

}  // namespace umbrage
