// SPDX-License-Identifier: Apache-2.0
#include "bench/tile_counter.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <thread>

namespace umbrage {
namespace {

constexpr int kTile = 8, kBlock = 64;
constexpr std::size_t kTilePixels = std::size_t(kTile * kTile);

enum class Rule : std::uint8_t { Pass, Fail };
using Choice = TileMethod::Choice;

struct Tile {
    PixelBox box;
    std::uint64_t inside = 0;  // pixels of the picture: bit 8 row + column
    std::array<double, kTilePixels> inverseDepths{};
    double farthest = 0.0, nearest = 0.0;  // inverse depths
};

/// What a polygon does in a tile.
struct Touch {
    std::uint64_t covered = 0, passed = 0;
    int entering = 0, times = 1;
    bool allPass = false, allFail = false, whole = false, nearPart = false;
    bool decidedForBlock = false;

    /// No count changes: known from the depths of tile and polygon alone.
    bool culledBy(Rule rule) const { return rule == Rule::Pass ? allFail : allPass; }
    std::uint64_t changed(Rule rule) const { return rule == Rule::Pass ? passed : covered & ~passed; }
    int change(Rule rule) const { return rule == Rule::Pass ? entering * times : -entering * times; }
    /// Every pixel's count changes alike.
    bool changesAll(Rule rule) const { return whole && (rule == Rule::Pass ? allPass : allFail); }
};

/// The tiles of one row of blocks.
class Band {
public:
    Band(std::span<const TileVolume> volumes, std::span<const double> inverseDepths, const TileView& view, int top,
         TileCounts& counts)
        : volumes_(volumes), depths_(inverseDepths), view_(view), top_(top), counts_(counts) {}

    /// @param figures  are added to
    void count(TileFiguresOfMethods& figures);

private:
    struct Block {
        PixelBox box;
        double farthest = HUGE_VAL, nearest = 0.0;
        std::vector<Tile> tiles;
    };
    struct Candidate {
        const TilePolygon* polygon;
        bool decided;  // for the whole block
        Touch touch;   // where decided
    };

    Block blockAt(int left) const;
    void countIn(const Block& block, const TileVolume& volume, TileFiguresOfMethods& figures);
    void countTile(const Tile& tile, const TileVolume& volume, TileFiguresOfMethods& figures);
    Rule ruleOf(const TileMethod& method, const Tile& tile, const TileVolume& volume) const;
    void apply(std::size_t m, Rule rule, const Tile& tile, std::uint64_t inBounds, bool boundsMeet,
               TileFigures& figures);

    std::span<const TileVolume> volumes_;
    std::span<const double> depths_;
    const TileView& view_;
    int top_;
    TileCounts& counts_;
    std::vector<Candidate> candidates_;
    std::vector<Touch> touches_;
    std::array<std::array<std::int16_t, kTilePixels>, kTileMethods.size()> sums_{};
    std::array<std::array<bool, 2>, kTileMethods.size()> ruleUsed_{};  // in the block
};

std::uint64_t bitOf(int column, int row) {
    return std::uint64_t(1) << (row * kTile + column);
}

template <class Visit>
void forBits(std::uint64_t bits, const Visit& visit) {
    for (; bits != 0; bits &= bits - 1) visit(std::size_t(std::countr_zero(bits)));
}

void classify(Touch& touch, const TilePolygon& polygon, const PixelBox& box, double farthest, double nearest) {
    touch.entering = polygon.entering;
    touch.times = polygon.times;
    touch.nearPart = polygon.kind == TilePolygon::Kind::NearPart;
    if (touch.nearPart) {
        touch.allPass = true;
        return;
    }
    const auto [low, high] = polygon.inverseDepths(box);
    touch.allPass = low > nearest;
    touch.allFail = high <= farthest;
}

/// @return  covered: 0 where it does not touch the tile
Touch touchOf(const TilePolygon& polygon, const Tile& tile) {
    Touch touch;
    const TilePolygon::Cover cover = polygon.cover(tile.box);
    if (cover == TilePolygon::Cover::None) return touch;
    const int left = tile.box.left, top = tile.box.top;
    if (cover == TilePolygon::Cover::All) {
        touch.covered = tile.inside;
        touch.whole = true;
    } else {
        forBits(tile.inside, [&](std::size_t i) {
            if (polygon.covers(left + int(i) % kTile, top + int(i) / kTile)) touch.covered |= std::uint64_t(1) << i;
        });
        if (touch.covered == 0) return touch;
    }
    classify(touch, polygon, tile.box, tile.farthest, tile.nearest);
    if (touch.allPass) {
        touch.passed = touch.covered;
    } else if (!touch.allFail) {
        forBits(touch.covered, [&](std::size_t i) {
            const double here = polygon.inverseDepth.at(left + int(i) % kTile, top + int(i) / kTile);
            if (here > tile.inverseDepths[i]) touch.passed |= std::uint64_t(1) << i;
        });
    }
    return touch;
}

/// Pixels to process, the first criterion of what is cheaper, and counts to change, the second.
std::array<std::uint64_t, 2> costOf(std::span<const Touch> touches, Rule rule, bool wholeTiles) {
    std::array<std::uint64_t, 2> cost{};
    for (const Touch& touch : touches) {
        if (touch.culledBy(rule)) continue;
        const bool one = wholeTiles && touch.changesAll(rule);
        cost[0] += std::uint64_t(touch.times) * (one ? 1 : std::uint64_t(std::popcount(touch.covered)));
        cost[1] += std::uint64_t(touch.times) * (one ? 1 : std::uint64_t(std::popcount(touch.changed(rule))));
    }
    return cost;
}

Band::Block Band::blockAt(int left) const {
    Block block;
    block.box = {left, top_, std::min(left + kBlock, view_.width()) - 1, std::min(top_ + kBlock, view_.height()) - 1};
    for (int y = top_; y <= block.box.bottom; y += kTile) {
        for (int x = left; x <= block.box.right; x += kTile) {
            Tile& tile = block.tiles.emplace_back();
            tile.box = {x, y, std::min(x + kTile - 1, block.box.right), std::min(y + kTile - 1, block.box.bottom)};
            tile.farthest = HUGE_VAL;
            for (int row = 0; row <= tile.box.bottom - y; ++row) {
                for (int column = 0; column <= tile.box.right - x; ++column) {
                    const double depth =
                        depths_[std::size_t(y + row) * std::size_t(view_.width()) + std::size_t(x + column)];
                    tile.inside |= bitOf(column, row);
                    tile.inverseDepths[std::size_t(row * kTile + column)] = depth;
                    tile.farthest = std::min(tile.farthest, depth);
                    tile.nearest = std::max(tile.nearest, depth);
                }
            }
            block.farthest = std::min(block.farthest, tile.farthest);
            block.nearest = std::max(block.nearest, tile.nearest);
        }
    }
    return block;
}

void Band::count(TileFiguresOfMethods& figures) {
    for (int left = 0; left < view_.width(); left += kBlock) {
        const Block block = blockAt(left);
        for (const TileVolume& volume : volumes_) countIn(block, volume, figures);
    }
}

void Band::countIn(const Block& block, const TileVolume& volume, TileFiguresOfMethods& figures) {
    candidates_.clear();
    for (const TilePolygon& polygon : volume.polygons) {
        const TilePolygon::Cover cover = polygon.cover(block.box);
        if (cover == TilePolygon::Cover::None) continue;
        Candidate candidate{&polygon, false, {}};
        if (cover == TilePolygon::Cover::All) {
            classify(candidate.touch, polygon, block.box, block.farthest, block.nearest);
            candidate.touch.whole = true;
            candidate.decided = candidate.touch.allPass || candidate.touch.allFail;
        }
        candidates_.push_back(candidate);
    }
    if (candidates_.empty()) return;
    ruleUsed_ = {};
    for (const Tile& tile : block.tiles) {
        touches_.clear();
        for (const Candidate& candidate : candidates_) {
            Touch touch = touchOf(*candidate.polygon, tile);
            if (touch.covered == 0) continue;
            touch.decidedForBlock = candidate.decided;
            touches_.push_back(touch);
        }
        if (!touches_.empty()) countTile(tile, volume, figures);
    }
    for (std::size_t m = 0; m < kTileMethods.size(); ++m) {
        if (!kTileMethods[m].wholeTiles) continue;
        for (const Candidate& candidate : candidates_) {
            if (!candidate.decided) continue;
            const Rule rule = candidate.touch.allPass ? Rule::Pass : Rule::Fail;
            if (!ruleUsed_[m][std::size_t(rule)]) continue;
            figures[m].tiles += std::uint64_t(candidate.touch.times);
            figures[m].pixels += std::uint64_t(candidate.touch.times);
            figures[m].updates += std::uint64_t(candidate.touch.times);
        }
    }
}

Rule Band::ruleOf(const TileMethod& method, const Tile& tile, const TileVolume& volume) const {
    const auto byPlane = [&](SplitAgainst against) {
        const glm::dvec2 center(tile.box.left + kTile / 2, tile.box.top + kTile / 2);
        const glm::dvec2 ndc(2.0 * center.x / view_.width() - 1.0, 1.0 - 2.0 * center.y / view_.height());
        return tilePasses(volume.split, ndc, view_.near() * tile.nearest, view_.near() * tile.farthest, against)
                   ? Rule::Pass
                   : Rule::Fail;
    };
    switch (method.choice) {
        case Choice::Pass:
            return Rule::Pass;
        case Choice::Fail:
            return Rule::Fail;
        case Choice::PlaneFarthest:
            return byPlane(SplitAgainst::Farthest);
        case Choice::PlaneNearest:
            return byPlane(SplitAgainst::Nearest);
        case Choice::Cheaper:
            break;
    }
    const auto pass = costOf(touches_, Rule::Pass, method.wholeTiles);
    return costOf(touches_, Rule::Fail, method.wholeTiles) < pass ? Rule::Fail : Rule::Pass;
}

void Band::apply(std::size_t m, Rule rule, const Tile& tile, std::uint64_t inBounds, bool boundsMeet,
                 TileFigures& figures) {
    const TileMethod& method = kTileMethods[m];
    std::array<std::int16_t, kTilePixels>& sums = sums_[m];
    int whole = 0;
    std::uint16_t* processed = counts_.processed.empty() ? nullptr : counts_.processed[m].data();
    for (const Touch& touch : touches_) {
        const auto times = std::uint64_t(touch.times);
        if (!touch.nearPart || rule == Rule::Pass) figures.processedTiles += times;
        if (touch.culledBy(rule) || (method.depthBounds && !boundsMeet)) continue;
        if (method.wholeTiles && (touch.decidedForBlock || touch.changesAll(rule))) {
            whole += touch.change(rule);
            if (touch.decidedForBlock) continue;  // paid for once, see countIn()
            figures.tiles += times;
            figures.pixels += times;
            figures.updates += times;
            continue;
        }
        const std::uint64_t changed = touch.changed(rule) & inBounds;
        figures.tiles += times;
        figures.pixels += times * std::uint64_t(std::popcount(touch.covered));
        figures.updates += times * std::uint64_t(std::popcount(changed));
        const auto change = std::int16_t(touch.change(rule));
        forBits(changed, [&](std::size_t i) { sums[i] = std::int16_t(sums[i] + change); });
        if (!processed) continue;
        forBits(touch.covered, [&](std::size_t i) {
            const std::size_t x = std::size_t(tile.box.left) + i % kTile, y = std::size_t(tile.box.top) + i / kTile;
            processed[y * std::size_t(view_.width()) + x] += std::uint16_t(touch.times);
        });
    }
    if (whole != 0) {
        for (std::int16_t& sum : sums) sum = std::int16_t(sum + whole);
    }
}

void Band::countTile(const Tile& tile, const TileVolume& volume, TileFiguresOfMethods& figures) {
    const bool boundsMeet = volume.bounds.meets(tile.farthest, tile.nearest);
    std::uint64_t inBounds = 0;
    forBits(tile.inside, [&](std::size_t i) {
        if (volume.bounds.holds(tile.inverseDepths[i])) inBounds |= std::uint64_t(1) << i;
    });
    for (std::size_t m = 0; m < kTileMethods.size(); ++m) {
        const Rule rule = ruleOf(kTileMethods[m], tile, volume);
        ruleUsed_[m][std::size_t(rule)] = true;
        sums_[m].fill(0);
        apply(m, rule, tile, kTileMethods[m].depthBounds ? inBounds : ~std::uint64_t(0), boundsMeet, figures[m]);
        forBits(tile.inside, [&](std::size_t i) { figures[m].different += sums_[m][i] != sums_[0][i]; });
    }
    forBits(tile.inside, [&](std::size_t i) {
        const std::size_t x = std::size_t(tile.box.left) + i % kTile, y = std::size_t(tile.box.top) + i / kTile;
        counts_.layers[y * std::size_t(view_.width()) + x] += sums_[0][i];
    });
}

}  // namespace

TileFigures& TileFigures::operator+=(const TileFigures& other) {
    processedTiles += other.processedTiles;
    tiles += other.tiles;
    pixels += other.pixels;
    updates += other.updates;
    different += other.different;
    return *this;
}

TileVolume tileVolume(const TileCaster& caster, const glm::dvec4& light, const SplitChoice& choice, const Eye& eye,
                      const TileView& view) {
    std::vector<glm::dvec3> points;
    for (const CastingTriangle& triangle : caster.triangles) {
        points.insert(points.end(), triangle.corners.begin(), triangle.corners.end());
    }
    const Plane plane = splitPlane(shapeOf(points), choice, eye.point(), light);
    return {volumePolygons(caster, light, view), depthBoundsOf(caster, light, view), screenPlane(plane, eye)};
}

TileCounts countTiles(std::span<const TileVolume> volumes, std::span<const double> inverseDepths, const TileView& view,
                      bool planes, int threads) {
    const std::size_t pixels = std::size_t(view.width()) * std::size_t(view.height());
    TileCounts counts;
    counts.layers.assign(pixels, 0);
    if (planes) counts.processed.assign(kTileMethods.size(), std::vector<std::uint16_t>(pixels));
    const int bandCount = (view.height() + kBlock - 1) / kBlock;
    std::vector<TileFiguresOfMethods> figures(std::size_t(bandCount), TileFiguresOfMethods{});
    std::atomic<int> next = 0;
    const auto work = [&] {
        for (int band = next++; band < bandCount; band = next++) {
            Band(volumes, inverseDepths, view, band * kBlock, counts).count(figures[std::size_t(band)]);
        }
    };
    {
        std::vector<std::jthread> helpers;
        for (int i = 1; i < threads; ++i) helpers.emplace_back(work);
        work();
    }
    for (const TileFiguresOfMethods& of : figures) {
        for (std::size_t m = 0; m < of.size(); ++m) counts.methods[m] += of[m];
    }
    return counts;
}

}  // namespace umbrage
