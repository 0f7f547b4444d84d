// SPDX-License-Identifier: Apache-2.0
#include "bench/bench_tiles.h"

#include <fmt/format.h>

#include "bench/laine_table.h"
#include "shading/lights.h"

namespace umbrage {
namespace {

constexpr std::string_view kYardstick = "SPSV";  // what ratios are to, as in the paper

std::size_t indexOf(std::string_view method) {
    std::size_t m = 0;
    while (kTileMethods[m].name != method) ++m;
    return m;
}

std::vector<BenchColumn> columns() {
    return {{"sequence", "sequence", "", -1},
            {"method", "method", "", -1},
            {"tiles.processed.thousand", "tiles", "pairs of polygon and tile, thousands a frame", 1},
            {"tiles.thousand", "not culled", "of them, thousands a frame", 1},
            {"pixels.thousand", "pixels", "processed in those, thousands a frame", 1},
            {"updates.thousand", "updates", "of counts, thousands a frame", 1},
            {"tiles.ratio", "tiles/SPSV", "tiles not culled for each of SPSV", 2},
            {"pixels.ratio", "pixels/SPSV", "", 2},
            {"updates.ratio", "updates/SPSV", "", 2},
            {"printed.tiles.thousand", "paper: not culled", "in the paper's table", 1},
            {"printed.pixels.thousand", "paper: pixels", "in the paper", 1},
            {"printed.updates.thousand", "paper: updates", "in the paper", 1},
            {"printed.tiles.ratio", "paper: tiles/SPSV", "in the paper", 2},
            {"printed.pixels.ratio", "paper: pixels/SPSV", "in the paper", 2},
            {"printed.updates.ratio", "paper: updates/SPSV", "in the paper, from its counts", 2},
            {"different", "differ", "pixels, of all frames and casters, whose count is not that of ZP+DB", 0}};
}

/// Means over the frames, thousands.
struct Means {
    double processedTiles, tiles, pixels, updates;

    Means(const TileFigures& sum, std::size_t frames)
        : processedTiles(1e-3 * double(sum.processedTiles) / double(frames)),
          tiles(1e-3 * double(sum.tiles) / double(frames)),
          pixels(1e-3 * double(sum.pixels) / double(frames)),
          updates(1e-3 * double(sum.updates) / double(frames)) {}
};

BenchCell ratio(double value, double to) {
    return to > 0.0 ? BenchCell(value / to) : BenchCell();
}

const PrintedRow* printedRow(const std::string& name) {
    const auto found = std::ranges::find_if(kPrintedRows, [&](const PrintedRow& row) { return row.name == name; });
    return found == kPrintedRows.end() ? nullptr : &*found;
}

void addRows(const BenchSequence& sequence, const TileFiguresOfMethods& sums, std::size_t frames, BenchTable& table) {
    const Means yardstick(sums[indexOf(kYardstick)], frames);
    const PrintedRow* printed = printedRow(sequence.printed);
    for (std::size_t m = 0; m < kTileMethods.size(); ++m) {
        const Means means(sums[m], frames);
        std::vector<BenchCell> row{sequence.name,
                                   std::string(kTileMethods[m].name),
                                   means.processedTiles,
                                   means.tiles,
                                   means.pixels,
                                   means.updates,
                                   ratio(means.tiles, yardstick.tiles),
                                   ratio(means.pixels, yardstick.pixels),
                                   ratio(means.updates, yardstick.updates)};
        const PrintedFigures* theirs = printed ? printed->of(kTileMethods[m].name) : nullptr;
        if (theirs) {
            const PrintedFigures& base = printed->splitPlane;
            row.insert(row.end(), {theirs->tiles, theirs->pixels, theirs->updates, ratio(theirs->tiles, base.tiles),
                                   ratio(theirs->pixels, base.pixels), ratio(theirs->updates, base.updates)});
        }
        row.resize(table.columns.size() - 1);
        row.push_back(double(sums[m].different));
        table.rows.push_back(std::move(row));
    }
}

/// What the choice for each caster and tile saves against split planes.
std::string saving(const BenchSequence& sequence, const TileFiguresOfMethods& sums) {
    const auto percent = [&](std::string_view method, std::string_view to) {
        const double pixels = double(sums[indexOf(method)].pixels), base = double(sums[indexOf(to)].pixels);
        return base > 0.0 ? 100.0 * (1.0 - pixels / base) : 0.0;
    };
    return fmt::format(
        "{}: best processes {:.1f} % fewer pixels than SPSV, with counters of whole tiles {:.1f} % fewer.",
        sequence.name, percent("best", "SPSV"), percent("best/H", "SPSV/H"));
}

}  // namespace

TileBench::TileBench(const BenchScene& scene, const gpu::Context& context, int threads)
    : scene_(scene), threads_(threads), truth_(scene.composition.scene) {
    FrameSettings settings = settingsOf(scene.job, scene.composition);
    settings.samples = 1;
    renderer_ = scene.renderer(settings, context);
}

TileFrame TileBench::frame(int frame, bool radiance) {
    PlacedMoment placed = scene_.at(frame);
    const int width = scene_.job.image.width, height = scene_.job.image.height;
    const Eye eye = makeEye(placed.camera, width, height);
    FrameOutputs outputs;
    outputs.radiance = radiance;
    outputs.geometry = true;
    Statistics unused;
    FramePixels pixels = renderer_->render(placed.moment, placed.camera, outputs, frame, unused);
    const Geometry& geometry = renderer_->geometry();
    truth_.update(placed.moment, geometry);
    const BenchSequence& sequence = scene_.sequence;
    std::vector<TileCaster> casters =
        tileCasters(scene_.composition.scene, placed.moment, geometry, truth_, eye, sequence.casters, Weights::Least);
    if (sequence.together) {
        for (std::size_t i = 1; i < casters.size(); ++i) {
            auto& all = casters.front().triangles;
            all.insert(all.end(), casters[i].triangles.begin(), casters[i].triangles.end());
        }
        casters.resize(std::min<std::size_t>(casters.size(), 1));
    }
    std::vector<glm::dvec4> lights;
    for (const PlacedLight& light : placed.moment.lights) {
        if (isOn(light.light)) lights.push_back(shadowLight(light));
    }
    const TileView view(eye, width, height);
    std::vector<double> inverseDepths = inverseDepthsOf(pixels, casters, eye, view);
    return {std::move(placed), eye, view, std::move(pixels), std::move(inverseDepths), std::move(casters),
            std::move(lights)};
}

TileCounts TileBench::count(const TileFrame& frame, bool planes) const {
    TileCounts sum;
    for (const glm::dvec4& light : frame.lights) {
        std::vector<TileVolume> volumes;
        for (const TileCaster& caster : frame.casters) {
            volumes.push_back(tileVolume(caster, light, scene_.sequence.splitPlane, frame.eye, frame.view));
        }
        TileCounts counts = countTiles(volumes, frame.inverseDepths, frame.view, planes, threads_);
        if (sum.layers.empty()) {
            sum = std::move(counts);
            continue;
        }
        for (std::size_t m = 0; m < kTileMethods.size(); ++m) {
            sum.methods[m] += counts.methods[m];
            for (std::size_t i = 0; planes && i < counts.layers.size(); ++i) {
                sum.processed[m][i] += counts.processed[m][i];
            }
        }
        for (std::size_t i = 0; i < counts.layers.size(); ++i) sum.layers[i] += counts.layers[i];
    }
    return sum;
}

void measureTiles(const BenchScenes& scenes, const gpu::Context& context, int threads, BenchObserver& observer,
                  const std::atomic<bool>& interrupted, BenchResult& result) {
    BenchTable table{"tiles", "Tiles", columns(), {}, {}};
    std::size_t frames = 0;
    for (const BenchScene* scene : scenes) frames += scene->frames.size();
    observer.started(frames, "tiles");
    for (const BenchScene* each : scenes) {
        const BenchScene& scene = *each;
        TileBench bench(scene, context, threads);
        TileFiguresOfMethods sums{};
        std::vector<PlotSeries> series;
        for (const std::string_view method : {"ZP+DB", "ZF+DB", "SPSV", "best"}) {
            series.push_back({std::string(method), {}});
        }
        for (const int frame : scene.frames) {
            if (interrupted) return;
            const TileCounts counts = bench.count(bench.frame(frame));
            for (std::size_t m = 0; m < kTileMethods.size(); ++m) sums[m] += counts.methods[m];
            for (PlotSeries& of : series) {
                of.points.emplace_back(frame, 1e-6 * double(counts.methods[indexOf(of.name)].pixels));
            }
            observer.advanced(fmt::format("{} frame {}", scene.sequence.name, frame));
        }
        addRows(scene.sequence, sums, scene.frames.size(), table);
        for (std::size_t m = 0; m < kTileMethods.size(); ++m) {
            if (sums[m].different == 0) continue;
            result.wrong.push_back(fmt::format("{}: {} counts {} pixels otherwise than {}", scene.sequence.name,
                                               kTileMethods[m].name, sums[m].different, kTileMethods[0].name));
        }
        table.remarks.push_back(saving(scene.sequence, sums));
        result.plots.emplace_back("tiles-" + scene.sequence.name, Plot{scene.sequence.name + ": pixels processed",
                                                                       "frame", "million", std::move(series)});
    }
    result.tables.push_back(std::move(table));
}

}  // namespace umbrage
