// SPDX-License-Identifier: Apache-2.0
#include "report/error_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>

#include "image/bitmap_font.h"

namespace umbrage {
namespace {

constexpr float kDimmed = 0.4f;                      // of the frame's grey
constexpr float kFloor = 20.0f, kCropFloor = 60.0f;  // grey of what is black: the dots must show
constexpr Rgb8 kGrid{0, 0, 0};
constexpr int kGap = 8;                            // between panels and around them
constexpr int kZoom = 12;                          // picture pixels for one of the frame, grid line included
constexpr int kLeastCrop = 16, kMostCrop = 40;     // frame pixels
constexpr int kLeastFrame = 640, kMostZoomed = 4;  // small frames are shown larger, too
constexpr int kMostMarks = 64;                     // hard errors that get a box each
constexpr int kLeastWidth = 640;                   // room for the legend

struct Class {
    SampleVerdict verdict;
    std::string_view name;
    Rgb8 color;
};
// At least 25 steps of CIE Lab between any two and 20 from the dimmed frame's greys, also for eyes that lack one kind
// of cone.
constexpr std::array kClasses = {
    Class{SampleVerdict::FalseDark, "false dark", {230, 90, 0}},
    Class{SampleVerdict::FalseLit, "false lit", {255, 240, 60}},
    Class{SampleVerdict::Boundary, "boundary", {0, 114, 255}},
    Class{SampleVerdict::Grazing, "grazing", {200, 40, 160}},
    Class{SampleVerdict::Primary, "other surface", {60, 200, 120}},
};

std::vector<SampleVerdict> worstOfLights(const VerdictPlanes& planes) {
    std::vector<SampleVerdict> worst(std::size_t(planes.width) * std::size_t(planes.height), SampleVerdict::Right);
    for (const std::vector<SampleVerdict>& light : planes.verdicts) {
        for (std::size_t i = 0; i < worst.size(); ++i) worst[i] = std::max(worst[i], light[i]);
    }
    return worst;
}

std::uint64_t samplesOf(const FrameVerdict& frame, SampleVerdict verdict) {
    std::uint64_t sum = 0;
    for (const LightVerdict& light : frame.lights) {
        switch (verdict) {
            case SampleVerdict::FalseDark:
                sum += light.hardFalseDark;
                break;
            case SampleVerdict::FalseLit:
                sum += light.hardFalseLit;
                break;
            case SampleVerdict::Boundary:
                sum += light.boundary;
                break;
            case SampleVerdict::Grazing:
                sum += light.grazing;
                break;
            case SampleVerdict::Primary:
                sum += light.primary;
                break;
            case SampleVerdict::Right:
                break;
        }
    }
    return sum;
}

/// The light to look at more closely; the first one where nothing is wrong.
std::size_t worstLight(const FrameVerdict& verdict) {
    const auto worse = [](const LightVerdict& a, const LightVerdict& b) {
        return std::pair(a.hard(), a.band()) < std::pair(b.hard(), b.band());
    };
    return std::size_t(std::max_element(verdict.lights.begin(), verdict.lights.end(), worse) - verdict.lights.begin());
}

/// Where everything goes, in pixels of the picture.
struct Layout {
    int zoom, cropSide;            // of the frame; of the enlarged part, frame pixels
    int cropWidth, cropHeight;     // as it is shown
    int frameWidth, frameHeight;   // as it is shown
    int cropX, cropY;              // of the crop's corner
    int width, height, legendTop;  // of the whole picture
    int textScale;

    Layout(int w, int h) {
        zoom = std::clamp(kLeastFrame / std::max(w, h), 1, kMostZoomed);
        frameWidth = w * zoom;
        frameHeight = h * zoom;
        cropSide = std::clamp(frameHeight / kZoom, kLeastCrop, kMostCrop);
        cropWidth = std::min(w, cropSide) * kZoom + 1;
        cropHeight = std::min(h, cropSide) * kZoom + 1;
        const bool below = w > 3 * h;
        cropX = below ? kGap : 2 * kGap + frameWidth;
        cropY = below ? 2 * kGap + frameHeight : kGap;
        width = std::max(kLeastWidth, kGap + std::max(kGap + frameWidth, cropX + cropWidth));
        textScale = width >= 1280 ? 2 : 1;
        legendTop = kGap + std::max(kGap + frameHeight, cropY + cropHeight);
        height = legendTop + 4 * lineHeight() + kGap;
    }

    int lineHeight() const { return (kGlyphHeight + 5) * textScale; }
    int lineTop(int line) const { return legendTop + line * lineHeight(); }
};

class Drawing {
public:
    Drawing(const VerdictPlanes& planes, std::span<const std::uint8_t> displayRgb)
        : planes_(planes),
          display_(displayRgb),
          layout_(planes.width, planes.height),
          canvas_(layout_.width, layout_.height) {
        canvas_.fill(0, 0, layout_.width, layout_.height, kPanel);
    }

    const Layout& layout() const { return layout_; }

    void frame(std::span<const SampleVerdict> verdicts) {
        const int zoom = layout_.zoom;
        for (int y = 0; y < planes_.height; ++y) {
            for (int x = 0; x < planes_.width; ++x) {
                canvas_.fill(kGap + x * zoom, kGap + y * zoom, zoom, zoom, colorAt(verdicts, indexOf(x, y), kFloor));
            }
        }
    }

    /// Boxes around hard errors, so that a single pixel in a large frame is found; not where there are many anyway.
    void markHard(std::span<const SampleVerdict> verdicts) {
        if (std::count_if(verdicts.begin(), verdicts.end(), isHard) > kMostMarks) return;
        constexpr int kAway = 4;
        for (int y = 0; y < planes_.height; ++y) {
            for (int x = 0; x < planes_.width; ++x) {
                const SampleVerdict verdict = verdicts[indexOf(x, y)];
                if (!isHard(verdict)) continue;
                const int left = std::max(0, x - kAway), top = std::max(0, y - kAway);
                outline({left, top, std::min(planes_.width, x + kAway + 1) - left,
                         std::min(planes_.height, y + kAway + 1) - top},
                        colorOf(verdict));
            }
        }
    }

    /// The enlarged part: a dot says the exact answer of each pixel.
    void crop(const PixelRectangle& place, std::span<const SampleVerdict> verdicts,
              std::span<const std::uint8_t> exact) {
        canvas_.fill(layout_.cropX, layout_.cropY, layout_.cropWidth, layout_.cropHeight, kGrid);
        for (int y = 0; y < place.height; ++y) {
            for (int x = 0; x < place.width; ++x) {
                const std::size_t i = indexOf(place.x + x, place.y + y);
                const int left = layout_.cropX + 1 + x * kZoom, top = layout_.cropY + 1 + y * kZoom;
                canvas_.fill(left, top, kZoom - 1, kZoom - 1, colorAt(verdicts, i, kCropFloor));
                if (exact.empty()) continue;
                constexpr int kDot = 3, kInset = (kZoom - 1 - kDot) / 2;
                canvas_.fill(left + kInset, top + kInset, kDot, kDot, exact[i] ? kInk : kGrid);
            }
        }
        outline(place, kInk);
    }

    void line(int line, const std::string& text) {
        const int room = (layout_.width - 2 * kGap) / layout_.textScale;
        canvas_.text(kGap, layout_.lineTop(line), layout_.textScale, shortened(text, room));
    }

    /// Swatches with the number of samples of each class.
    void classes(int line, const FrameVerdict& verdict) {
        const int scale = layout_.textScale, side = kGlyphHeight * scale;
        int x = kGap;
        for (const Class& one : kClasses) {
            const std::string text = fmt::format("{} {}", samplesOf(verdict, one.verdict), one.name);
            const int end = x + side + 3 * scale + textWidth(text) * scale;
            if (end > layout_.width - kGap) return;
            canvas_.fill(x, layout_.lineTop(line), side, side, one.color);
            canvas_.text(x + side + 3 * scale, layout_.lineTop(line), scale, text);
            x = end + 12 * scale;
        }
    }

    RgbPicture take() && { return std::move(canvas_).take(); }

private:
    std::size_t indexOf(int x, int y) const { return std::size_t(y) * std::size_t(planes_.width) + std::size_t(x); }

    Rgb8 colorAt(std::span<const SampleVerdict> verdicts, std::size_t i, float floor) const {
        if (verdicts[i] != SampleVerdict::Right) return colorOf(verdicts[i]);
        return mixed({}, floor + kDimmed * greyOf(&display_[3 * i]), 1.0f);
    }

    /// Around a part of the frame.
    void outline(const PixelRectangle& place, const Rgb8& color) {
        const int zoom = layout_.zoom;
        const int x = kGap + place.x * zoom - 1, y = kGap + place.y * zoom - 1;
        const int w = place.width * zoom + 2, h = place.height * zoom + 2;
        canvas_.fill(x, y, w, 1, color);
        canvas_.fill(x, y + h - 1, w, 1, color);
        canvas_.fill(x, y, 1, h, color);
        canvas_.fill(x + w - 1, y, 1, h, color);
    }

    const VerdictPlanes& planes_;
    std::span<const std::uint8_t> display_;
    Layout layout_;
    Canvas canvas_;
};

std::string figuresText(const FrameVerdict& verdict) {
    std::uint64_t litFacing = 0, counts = 0, countErrors = 0, largest = 0;
    for (const LightVerdict& light : verdict.lights) {
        litFacing += light.litFacing;
        counts += light.countsJudged;
        countErrors += light.hardCountErrors;
        largest = std::max(largest, light.largestComponent);
    }
    std::string text =
        fmt::format("{} light-facing samples of {} light{}, largest error {} px, radiance {:.2g} ({} codes)", litFacing,
                    verdict.lights.size(), verdict.lights.size() == 1 ? "" : "s", largest, verdict.radiance.largest,
                    verdict.radiance.largestCode);
    if (counts > 0) text += fmt::format(", {} wrong counts", countErrors);
    return text;
}

}  // namespace

Rgb8 colorOf(SampleVerdict verdict) {
    const auto found =
        std::find_if(kClasses.begin(), kClasses.end(), [&](const Class& one) { return one.verdict == verdict; });
    assert(found != kClasses.end());
    return found->color;
}

RgbPicture drawErrors(const std::string& sequence, const FrameVerdict& verdict, const VerdictPlanes& planes,
                      std::span<const std::uint8_t> displayRgb) {
    assert(displayRgb.size() == 3 * std::size_t(planes.width) * std::size_t(planes.height));
    assert(planes.verdicts.size() == verdict.lights.size() && planes.exact.size() == verdict.lights.size());
    Drawing drawing(planes, displayRgb);
    const std::vector<SampleVerdict> all = worstOfLights(planes);
    drawing.frame(all);
    drawing.markHard(all);
    const int side = drawing.layout().cropSide;
    drawing.line(0, fmt::format("{}, frame {}, {}", sequence, verdict.frame, verdict.technique));
    drawing.classes(1, verdict);
    drawing.line(2, figuresText(verdict));
    if (verdict.lights.empty()) {
        drawing.crop(worstPlace(all, planes.width, planes.height, side, side), all, {});
        return std::move(drawing).take();
    }
    const std::size_t light = worstLight(verdict);
    const PixelRectangle place = worstPlace(planes.verdicts[light], planes.width, planes.height, side, side);
    drawing.crop(place, planes.verdicts[light], planes.exact[light]);
    drawing.line(3, fmt::format("enlarged: light {}, x {}-{}, y {}-{}; dot: exact answer, white lit, black shadow",
                                verdict.lights[light].light, place.x, place.x + place.width - 1, place.y,
                                place.y + place.height - 1));
    return std::move(drawing).take();
}

}  // namespace umbrage
