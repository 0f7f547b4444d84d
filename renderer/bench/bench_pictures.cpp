// SPDX-License-Identifier: Apache-2.0
#include "bench/bench_pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "error.h"
#include "image/overlay.h"

namespace umbrage {
namespace {

/// What all but one in a thousand of the pixels processed at all stay below, to the next whole number.
float scaleOf(const std::vector<ProcessedPanel>& panels) {
    std::vector<float> counts{1.0f};
    for (const ProcessedPanel& panel : panels) {
        std::ranges::copy_if(panel.processed, std::back_inserter(counts), [](float count) { return count > 0.0f; });
    }
    const auto high = counts.begin() + std::ptrdiff_t(double(counts.size() - 1) * 0.999);
    std::nth_element(counts.begin(), high, counts.end());
    return std::ceil(*high);
}

void place(const RgbPicture& picture, int left, int top, Canvas& canvas) {
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) {
            const std::uint8_t* rgb = &picture.rgb[3 * (std::size_t(y) * std::size_t(picture.width) + std::size_t(x))];
            canvas.set(left + x, top + y, {rgb[0], rgb[1], rgb[2]});
        }
    }
}

/// Where a view ray meets a volume.
struct Met {
    std::vector<double> depths;  // metres along the view axis; HUGE_VAL: at infinity
    int x = 0, y = 0;
    const TileVolume* volume = nullptr;
};

std::size_t crossingsAt(const TileVolume& volume, int x, int y) {
    std::size_t crossings = 0;
    for (const TilePolygon& polygon : volume.polygons) {
        if (polygon.covers(x, y)) crossings += std::size_t(polygon.times);
    }
    return crossings;
}

/// Of the pixels of a coarse grid the first at which some volume is met most often.
Met mostMet(std::span<const TileVolume> volumes, const TileView& view) {
    constexpr int kStep = 4;
    Met most;
    std::size_t best = 0;
    for (const TileVolume& volume : volumes) {
        for (int y = kStep / 2; y < view.height(); y += kStep) {
            for (int x = kStep / 2; x < view.width(); x += kStep) {
                const std::size_t crossings = crossingsAt(volume, x, y);
                if (crossings <= best) continue;
                best = crossings;
                most = {{}, x, y, &volume};
            }
        }
    }
    if (!most.volume) return most;
    for (const TilePolygon& polygon : most.volume->polygons) {
        if (!polygon.covers(most.x, most.y)) continue;
        const bool before = polygon.kind == TilePolygon::Kind::NearPart;
        const double inverse = before ? 1.0 / view.near() : polygon.inverseDepth.at(most.x, most.y);
        most.depths.insert(most.depths.end(), std::size_t(polygon.times), inverse > 0.0 ? 1.0 / inverse : HUGE_VAL);
    }
    std::ranges::sort(most.depths);
    return most;
}

}  // namespace

RgbPicture drawProcessed(const std::vector<ProcessedPanel>& panels, const DisplayTransform& display) {
    const ProcessedPanel& first = panels.front();
    const float scale = scaleOf(panels);
    const auto beauty = [&](const ProcessedPanel& panel) {
        std::vector<float> displayed = panel.radiance;
        display.apply(displayed);
        return RgbPicture{panel.width, panel.height, rgbBytes(displayed)};
    };
    std::vector<RgbPicture> shown;
    for (std::size_t i = 0; i < panels.size(); ++i) {
        const ProcessedPanel& panel = panels[i];
        if (i == 0 || panel.radiance != panels[i - 1].radiance) shown.push_back(beauty(panel));
        shown.push_back(
            drawOverlay(panel.width, panel.height, panel.processed, beauty(panel).rgb, {panel.title, scale}));
    }
    const int columns = int(std::ceil(std::sqrt(double(shown.size()))));
    const int rows = (int(shown.size()) + columns - 1) / columns;
    Canvas canvas(columns * first.width, rows * first.height);
    for (std::size_t i = 0; i < shown.size(); ++i) {
        place(shown[i], int(i) % columns * first.width, int(i) / columns * first.height, canvas);
    }
    return std::move(canvas).take();
}

ProcessedPanel processedPanel(TileBench& bench, std::string_view method, int frame) {
    const TileFrame counted = bench.frame(frame, true);
    const TileCounts counts = bench.count(counted, true);
    ProcessedPanel panel{"", counted.view.width(), counted.view.height(),
                         std::vector<float>(counted.inverseDepths.size()), counted.pixels.radiance};
    std::uint64_t pixels = 0;
    for (std::size_t m = 0; m < counts.processed.size(); ++m) {
        if (kTileMethods[m].name != method) continue;
        panel.processed.assign(counts.processed[m].begin(), counts.processed[m].end());
        pixels = counts.methods[m].pixels;
    }
    panel.title = fmt::format("{} {}: {:.0f} k", bench.scene().sequence.name, method, 1e-3 * double(pixels));
    return panel;
}

Plot updateCurve(TileBench& bench, const BenchCurve& curve) {
    TileFrame counted = bench.frame(curve.frame);
    if (counted.lights.empty()) {
        throw Error(ErrorKind::Input, curve.sequence.place.text(),
                    fmt::format("no light is on in frame {}", curve.frame));
    }
    const TileView& view = counted.view;
    std::vector<TileVolume> volumes;
    for (TileCaster& caster : counted.casters) {
        for (CastingTriangle& triangle : caster.triangles)
            triangle.mayBeUnseen = true;  // light caps at their own depth
        volumes.push_back(
            tileVolume(caster, counted.lights.front(), bench.scene().sequence.splitPlane, counted.eye, view));
    }
    const Met met = mostMet(volumes, view);
    Plot plot{fmt::format("{} frame {}, pixel ({}, {})", bench.scene().sequence.name, curve.frame, met.x, met.y),
              "depth of what is seen (metres)",
              "count updates",
              {{"z-pass", {}}, {"z-fail", {}}, {"split plane", {}}}};
    if (!met.volume) return plot;
    // From a little before the first crossing to a little behind the last one that is not at infinity.
    std::vector<double> finite;
    std::ranges::copy_if(met.depths, std::back_inserter(finite), [](double depth) { return depth < HUGE_VAL; });
    if (finite.empty()) return plot;
    const double margin = 0.15 * (finite.back() - finite.front()) + 0.01 * finite.back();
    const double begin = std::max(view.near(), finite.front() - margin), end = finite.back() + margin;
    const glm::dvec2 ndc(2.0 * (met.x + 0.5) / view.width() - 1.0, 1.0 - 2.0 * (met.y + 0.5) / view.height());
    constexpr int kSteps = 1000;
    for (int i = 0; i <= kSteps; ++i) {
        const double depth = begin + (end - begin) * i / kSteps;
        const double before = double(std::ranges::lower_bound(met.depths, depth) - met.depths.begin());
        const double behind = double(met.depths.size()) - before;
        const bool passes = met.volume->split.passes(ndc, view.near() / depth);
        const std::array<double, 3> updates{before, behind, passes ? before : behind};
        for (std::size_t s = 0; s < updates.size(); ++s) plot.series[s].points.emplace_back(depth, updates[s]);
    }
    return plot;
}

}  // namespace umbrage
