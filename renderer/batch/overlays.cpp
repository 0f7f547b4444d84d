// SPDX-License-Identifier: Apache-2.0
#include "batch/overlays.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "image/key.h"
#include "image/overlay.h"
#include "image/palette.h"

namespace umbrage {
namespace {

constexpr float kDimmed = 0.35f;  // of the picture's grey, below what is shown
constexpr float kFragmentScale = 64.0f;

std::size_t pixelCount(const OverlayInput& in) {
    return std::size_t(in.width) * std::size_t(in.height);
}

/// The picture, grey and dim; black where it was not shaded.
Canvas dimmed(const OverlayInput& in) {
    Canvas canvas(in.width, in.height);
    for (std::size_t i = 0; 3 * i < in.beautyRgb.size(); ++i) {
        const int x = int(i % std::size_t(in.width)), y = int(i / std::size_t(in.width));
        canvas.set(x, y, mixed({}, greyOf(&in.beautyRgb[3 * i]), kDimmed));
    }
    return canvas;
}

/// Calls `paint(i, x, y)` for every pixel.
template <class Paint>
void forPixels(const OverlayInput& in, Paint paint) {
    for (int y = 0; y < in.height; ++y) {
        for (int x = 0; x < in.width; ++x) paint(std::size_t(y) * std::size_t(in.width) + std::size_t(x), x, y);
    }
}

std::string lineOf(const OverlayInput& in, const std::string& technique, const std::string& more) {
    return fmt::format("frame {}  {}  {}", in.frame, technique, more);
}

RgbPicture finished(Canvas canvas, const OverlayInput& in, const std::string& more) {
    if (in.burnIn) drawBurnIn(canvas, lineOf(in, in.technique, more));
    return std::move(canvas).take();
}

RgbPicture falseColor(const OverlayInput& in, const std::vector<float>& counts, const OverlayStyle& style,
                      const std::string& technique) {
    Canvas canvas(drawOverlay(in.width, in.height, counts, in.beautyRgb, style));
    if (in.burnIn) {
        const float largest = counts.empty() ? 0.0f : *std::max_element(counts.begin(), counts.end());
        drawBurnIn(canvas, lineOf(in, technique, fmt::format("max {:g}", largest)));
    }
    return std::move(canvas).take();
}

std::vector<float> largestCounts(const OverlayInput& in) {
    std::vector<float> largest(pixelCount(in));
    for (const LightPlanes& light : in.pixels.lights) {
        for (std::size_t i = 0; i < largest.size(); ++i) largest[i] = std::max(largest[i], float(light.counts[i]));
    }
    return largest;
}

RgbPicture stencilPicture(const OverlayInput& in) {
    return falseColor(in, largestCounts(in), {"shadow count, highest of all lights", 16.0f}, in.technique);
}

RgbPicture stencilZeroPicture(const OverlayInput& in) {
    const KeyEntry key[] = {{{0, 150, 0}, "0"}, {{255, 0, 0}, "1"}, {{190, 0, 0}, "2"}, {{120, 0, 0}, "3 and more"}};
    const std::vector<float> counts = largestCounts(in);
    Canvas canvas = dimmed(in);
    forPixels(in, [&](std::size_t i, int x, int y) {
        canvas.blend(x, y, key[std::min(std::size_t(counts[i]), std::size(key) - 1)].color, 0.7f);
    });
    drawKey(canvas, "shadow count, highest of all lights", key);
    return finished(std::move(canvas), in, "");
}

RgbPicture overdrawOf(const OverlayInput& in, const FramePixels& pixels, const std::string& technique) {
    std::vector<float> mean = pixels.overdrawFragments;
    for (float& fragments : mean) fragments /= float(std::max<std::size_t>(1, pixels.lights.size()));
    return falseColor(in, mean, {"shadow volume fragments per light", kFragmentScale}, technique);
}

RgbPicture overdrawPicture(const OverlayInput& in) {
    return overdrawOf(in, in.pixels, in.technique);
}

RgbPicture updatesPicture(const OverlayInput& in) {
    std::vector<float> mean = in.pixels.overdrawUpdates;
    for (float& updates : mean) updates /= float(std::max<std::size_t>(1, in.pixels.lights.size()));
    return falseColor(in, mean, {"count changes per light", 16.0f}, in.technique);
}

std::vector<KeyEntry> keyOfLights(const OverlayInput& in) {
    std::vector<KeyEntry> key;
    for (std::size_t l = 0; l < in.pixels.lights.size(); ++l) key.push_back({categoryColor(l), in.pixels.lights[l].id});
    return key;
}

/// @param aov  of lines; none where the light is off
void drawLines(Canvas& canvas, const OverlayInput& in, const AovPlanes& planes, const char* aov, const Rgb8& color) {
    const auto plane = planes.find(aov);
    if (plane == planes.end() || plane->second.values.empty()) return;
    forPixels(in,
              [&](std::size_t i, int x, int y) { canvas.blend(x, y, color, std::min(plane->second.values[i], 1.0f)); });
}

RgbPicture silhouettePicture(const OverlayInput& in) {
    Canvas canvas = dimmed(in);
    for (std::size_t l = 0; l < in.pixels.lights.size(); ++l) {
        drawLines(canvas, in, in.pixels.lights[l].aovs, "silhouette", categoryColor(l));
    }
    drawKey(canvas, "silhouette edges of light", keyOfLights(in));
    return finished(std::move(canvas), in, "");
}

/// @param weighted  RGBA: colours added up, and their weights
/// @param coverageOf  of such a pixel
RgbPicture weightedPicture(const OverlayInput& in, const std::vector<float>& weighted, const char* title,
                           float (*coverageOf)(const float*)) {
    Canvas canvas = dimmed(in);
    forPixels(in, [&](std::size_t i, int x, int y) {
        const float* p = &weighted[4 * i];
        if (p[3] <= 0.0f) return;
        Rgb8 color;
        for (std::size_t c = 0; c < 3; ++c) color[c] = std::uint8_t(255.0f * std::min(p[c] / p[3], 1.0f) + 0.5f);
        canvas.blend(x, y, color, coverageOf(p));
    });
    drawKey(canvas, title, keyOfLights(in));
    return finished(std::move(canvas), in, "");
}

/// One face is a breath, some hundreds are not yet a wall.
float hullCoverage(const float* hull) {
    return std::min(0.1f * std::log2(1.0f + hull[3]), 0.85f);
}

RgbPicture volumesPicture(const OverlayInput& in) {
    return weightedPicture(in, in.pixels.hulls, "shadow volumes of light", hullCoverage);
}

RgbPicture splitPlanePicture(const OverlayInput& in) {
    return weightedPicture(in, in.pixels.splitPlanes, "split planes of light",
                           [](const float* planes) { return std::min(0.5f * planes[3], 0.7f); });
}

/// Brabec & Seidel 2003, figure 5.
RgbPicture extractionPicture(const OverlayInput& in) {
    constexpr Rgb8 kEdge{255, 225, 0}, kVolume{225, 25, 20};
    Canvas canvas = dimmed(in);
    forPixels(in,
              [&](std::size_t i, int x, int y) { canvas.blend(x, y, kVolume, hullCoverage(&in.pixels.hulls[4 * i])); });
    std::vector<KeyEntry> key{{kVolume, "shadow volumes of all lights"}};
    if (!in.pixels.lights.empty()) {
        const LightPlanes& first = in.pixels.lights.front();
        drawLines(canvas, in, first.aovs, "silhouette", kEdge);
        key.push_back({kEdge, "silhouette edges of " + first.id});
    }
    drawKey(canvas, "extraction", key);
    return finished(std::move(canvas), in, "");
}

/// Brabec & Seidel 2003, section 7: flat tones, and ink where the silhouette that the eye sees is. White paper where
/// nothing was shaded.
RgbPicture toonPicture(const OverlayInput& in) {
    constexpr float kTones = 4.0f;  // beside black
    Canvas canvas(in.width, in.height);
    forPixels(in, [&](std::size_t i, int x, int y) {
        Rgb8 color{255, 255, 255};
        if (!in.beautyRgb.empty()) {
            const std::uint8_t* rgb = &in.beautyRgb[3 * i];
            const float tone = std::max(greyOf(rgb), 1.0f) / 255.0f, flat = std::round(kTones * tone) / kTones;
            for (std::size_t c = 0; c < 3; ++c) color[c] = std::uint8_t(std::min(255.0f, float(rgb[c]) * flat / tone));
        }
        canvas.set(x, y, color);
    });
    const std::vector<float>& contour = in.pixels.aovs.find("contour")->second.values;
    forPixels(in, [&](std::size_t i, int x, int y) {
        if (contour[i] <= 0.0f) return;
        // Three pixels wide, as far as they are in the picture.
        for (const auto& [right, down] : {std::pair{0, 0}, {1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
            if (x + right >= 0 && x + right < in.width && y + down >= 0 && y + down < in.height) {
                canvas.set(x + right, y + down, {});
            }
        }
    });
    return finished(std::move(canvas), in, "");
}

RgbPicture castersPicture(const OverlayInput& in) {
    const std::vector<FillingCaster>& top = in.pixels.topCasters;
    std::vector<KeyEntry> key;
    for (std::size_t rank = 0; rank < top.size(); ++rank) {
        key.push_back({categoryColor(rank), fmt::format("{:.2f} M  {}", 1e-6 * top[rank].fragments, top[rank].path),
                       rank >= kCategoryColors.size()});
    }
    Canvas canvas = dimmed(in);
    forPixels(in, [&](std::size_t i, int x, int y) {
        std::size_t most = 0;
        for (std::size_t rank = 1; rank < top.size(); ++rank) {
            if (top[rank].pixels[i] > top[most].pixels[i]) most = rank;
        }
        if (top.empty() || top[most].pixels[i] <= 0.0f) return;
        canvas.blend(x, y, key[most].striped && isStripe(x, y) ? Rgb8{} : key[most].color, 0.7f);
    });
    drawKey(canvas, "caster whose volumes fill the pixel most: fragments", key);
    return finished(std::move(canvas), in, "");
}

RgbPicture tilesPicture(const OverlayInput& in) {
    constexpr int kTile = 8;
    const KeyEntry processed{categoryColor(4), "counts change"}, culled{categoryColor(0), "touched in vain"};
    Canvas canvas = dimmed(in);
    int tiles[2] = {0, 0};  // processed, culled
    for (int top = 0; top < in.height; top += kTile) {
        for (int left = 0; left < in.width; left += kTile) {
            const int right = std::min(left + kTile, in.width), bottom = std::min(top + kTile, in.height);
            bool touched = false, changed = false;
            for (int y = top; y < bottom; ++y) {
                for (int x = left; x < right; ++x) {
                    const std::size_t i = std::size_t(y) * std::size_t(in.width) + std::size_t(x);
                    touched = touched || in.pixels.overdrawFragments[i] > 0.0f;
                    changed = changed || in.pixels.overdrawUpdates[i] > 0.0f;
                }
            }
            if (!touched) continue;
            ++tiles[changed ? 0 : 1];
            for (int y = top; y < bottom; ++y) {
                for (int x = left; x < right; ++x) {
                    const bool border = y == top || x == left;
                    canvas.blend(x, y, changed ? processed.color : culled.color, border ? 0.75f : 0.4f);
                }
            }
        }
    }
    const int all = (in.width + kTile - 1) / kTile * ((in.height + kTile - 1) / kTile);
    const auto withShare = [&](KeyEntry entry, int count) {
        entry.label += fmt::format(": {} of {}", count, all);
        return entry;
    };
    const KeyEntry key[] = {withShare(processed, tiles[0]), withShare(culled, tiles[1])};
    drawKey(canvas, "tiles of 8 x 8 pixels", key);
    return finished(std::move(canvas), in, "");
}

/// Left this technique, right the other.
RgbPicture techniquesPicture(const OverlayInput& in) {
    OverlayInput named = in;
    named.burnIn = true;
    const RgbPicture halves[] = {overdrawOf(named, in.pixels, in.technique),
                                 overdrawOf(named, *in.against, in.againstTechnique)};
    RgbPicture both{2 * in.width, in.height, {}};
    both.rgb.reserve(6 * pixelCount(in));
    const std::size_t row = 3 * std::size_t(in.width);
    for (std::size_t y = 0; y < std::size_t(in.height); ++y) {
        for (const RgbPicture& half : halves) {
            const auto begin = half.rgb.begin() + std::ptrdiff_t(y * row);
            both.rgb.insert(both.rgb.end(), begin, begin + std::ptrdiff_t(row));
        }
    }
    return both;
}

/// An overlay: what it needs, how it is drawn. A new one is one line here and one in job/names.h.
struct Overlay {
    std::string_view name;
    void (*need)(FrameOutputs&);
    RgbPicture (*draw)(const OverlayInput&);
};
constexpr Overlay kOverlayPictures[] = {
    {"stencil", [](FrameOutputs& o) { o.counts = true; }, stencilPicture},
    {"stencil-zero", [](FrameOutputs& o) { o.counts = true; }, stencilZeroPicture},
    {"overdraw", [](FrameOutputs& o) { o.overdraw = true; }, overdrawPicture},
    {"updates", [](FrameOutputs& o) { o.overdraw = true; }, updatesPicture},
    {"silhouettes", [](FrameOutputs& o) { o.aovs.emplace("silhouette"); }, silhouettePicture},
    {"volumes", [](FrameOutputs& o) { o.hulls = true; }, volumesPicture},
    {"split-plane", [](FrameOutputs& o) { o.splitPlanes = o.geometry = true; }, splitPlanePicture},
    {"extraction",
     [](FrameOutputs& o) {
         o.hulls = true;
         o.aovs.emplace("silhouette");
     },
     extractionPicture},
    {"toon", [](FrameOutputs& o) { o.aovs.emplace("contour"); }, toonPicture},
    {"casters", [](FrameOutputs& o) { o.topCasters = true; }, castersPicture},
    {"tiles", [](FrameOutputs& o) { o.overdraw = true; }, tilesPicture},
    {"techniques", [](FrameOutputs& o) { o.overdraw = true; }, techniquesPicture},
};

const Overlay& overlayNamed(std::string_view name) {
    for (const Overlay& overlay : kOverlayPictures) {
        if (overlay.name == name) return overlay;
    }
    throw std::logic_error(fmt::format("no overlay \"{}\"", name));
}

}  // namespace

void addNeeds(std::span<const std::string> overlays, FrameOutputs& outputs) {
    for (const std::string& name : overlays) overlayNamed(name).need(outputs);
}

RgbPicture overlayPicture(std::string_view overlay, const OverlayInput& input) {
    return overlayNamed(overlay).draw(input);
}

}  // namespace umbrage
