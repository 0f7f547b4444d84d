// SPDX-License-Identifier: Apache-2.0
#include "tiles/tile_counter.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <limits>

#include "instruction_set.h"

namespace umbrage {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// Memory of BandScratch.
class Scratch {
public:
    explicit Scratch(int columns)
        : tileCount_(std::size_t(columns) * kBlockTiles),
          // Blocks are looked at sixteen at a time: those beyond the last see nothing.
          blockCount_((std::size_t(columns) + 15) / 16 * 16),
          counts_(tileCount_ * kTilePixels),
          tileCounts_(tileCount_),
          depths_(2 * tileCount_ + 2 * blockCount_, kInfinity),
          active_(tileCount_),
          lists_(std::size_t(columns) * BandScratch::kPolygonsAtOnce),
          listSizes_(std::size_t(columns)) {}

    BandScratch get() {
        float* depths = depths_.data();
        return {counts_.data(),      tileCounts_.data(),      depths,
                depths + tileCount_, depths + 2 * tileCount_, depths + 2 * tileCount_ + blockCount_,
                active_.data(),      lists_.data(),           listSizes_.data()};
    }
    TileWork work;

private:
    std::size_t tileCount_, blockCount_;
    std::vector<std::int32_t> counts_, tileCounts_;
    std::vector<float> depths_;
    std::vector<std::uint64_t> active_;
    std::vector<std::uint32_t> lists_, listSizes_;
};

/// Those of a band.
std::span<const TileSample> samplesOf(const TileLight& light, std::size_t first, std::size_t end) {
    const auto from = std::ranges::lower_bound(light.samples, first, {}, &TileSample::index);
    return {from, std::ranges::lower_bound(from, light.samples.end(), end, {}, &TileSample::index)};
}

}  // namespace

CountBand* countBandHere() {
    return forThisProcessor(countBandBaseline, countBandAvx2, countBandAvx512);
}

const std::vector<std::uint32_t>& TileCounter::count(const SeenTiles& seen, std::span<const TileLight> lights) {
    countAll(seen, lights, {});
    return dark_;
}

std::vector<std::int32_t> TileCounter::countsOf(const SeenTiles& seen, const TileLight& light) {
    std::vector<std::int32_t> counts(seen.pixelCount());
    countAll(seen, {&light, 1}, {counts.data(), nullptr});
    return counts;
}

std::vector<std::uint8_t> TileCounter::touching(const SeenTiles& seen, std::vector<TilePolygon> polygons) {
    std::vector<std::uint8_t> touching(polygons.size());
    TileLight any;
    any.polygons = std::move(polygons);
    any.bit = ~0u;
    countAll(seen, {&any, 1}, {nullptr, touching.data()});
    return touching;
}

void TileCounter::countAll(const SeenTiles& seen, std::span<const TileLight> lights, const Wanted& wanted) {
    dark_.assign(seen.pixelCount(), 0);
    work_ = {};
    tbb::enumerable_thread_specific<Scratch> scratches([&] { return Scratch(seen.columns()); });
    tbb::parallel_for(0, seen.rows(), [&](int row) {
        Scratch& scratch = scratches.local();
        const std::size_t first = std::size_t(row) * std::size_t(seen.columns()) * kBlockPixels;
        for (const TileLight& light : lights) {
            Band band;
            band.polygons = light.polygons.data(), band.polygonCount = light.polygons.size();
            const std::span<const TileSample> samples =
                samplesOf(light, first, first + std::size_t(seen.columns()) * kBlockPixels);
            band.samples = samples.data(), band.sampleCount = samples.size();
            band.start = light.start, band.lightBit = light.bit;
            for (int k = 0; k < 3; ++k) band.light[k] = light.position[k];
            band.range2 = light.range2;
            band.columns = seen.columns(), band.row = row;
            band.depths = seen.depths() + first, band.lit = seen.lit() + first;
            band.boxes = seen.boxes() + first / kTilePixels;
            band.dark = dark_.data() + first;
            band.counts = wanted.counts ? wanted.counts + first : nullptr;
            band.touching = wanted.touching;
            band.scratch = scratch.get(), band.work = &scratch.work;
            countBand_(band);
        }
    });
    for (const Scratch& scratch : scratches) {
        work_.tiles += scratch.work.tiles;
        work_.pixels += scratch.work.pixels;
    }
    work_.pixels += work_.tiles * kTilePixels;
}

}  // namespace umbrage
