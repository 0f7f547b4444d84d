// SPDX-License-Identifier: Apache-2.0
// A drawing as pixels.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <vector>

#include "image/bitmap_font.h"
#include "report/plot.h"

namespace umbrage {
namespace {

constexpr int kScale = 2;  // pixels for one of the drawing's, and for one of the font's
constexpr Rgb8 kPaper{255, 255, 255}, kWriting{34, 34, 34};

glm::dvec2 pixelsOf(const PlotPoint& point) {
    return {kScale * point.x, kScale * point.y};
}

/// How much of each pixel a line covers; where its parts meet, the most counts.
class Coverage {
public:
    Coverage(int width, int height)
        : width_(width), height_(height), values_(std::size_t(width) * std::size_t(height)) {}

    /// One straight part. Pixels whose centre is within half the width are covered, with half a pixel of slope.
    void add(const glm::dvec2& from, const glm::dvec2& to, double lineWidth) {
        const double reach = lineWidth / 2 + 0.5;
        const glm::dvec2 low = glm::min(from, to) - reach, high = glm::max(from, to) + reach;
        const glm::dvec2 along = to - from;
        const double lengthSquared = glm::dot(along, along);
        for (int y = std::max(0, int(low.y)); y <= std::min(height_ - 1, int(high.y)); ++y) {
            for (int x = std::max(0, int(low.x)); x <= std::min(width_ - 1, int(high.x)); ++x) {
                const glm::dvec2 centre(x + 0.5, y + 0.5);
                const double t =
                    lengthSquared > 0 ? std::clamp(glm::dot(centre - from, along) / lengthSquared, 0.0, 1.0) : 0.0;
                const double covered = std::clamp(reach - glm::distance(centre, from + t * along), 0.0, 1.0);
                float& value = values_[std::size_t(y) * std::size_t(width_) + std::size_t(x)];
                value = std::max(value, float(covered));
            }
        }
    }

    void paint(Canvas& canvas, const Rgb8& color) const {
        for (int y = 0; y < height_; ++y) {
            for (int x = 0; x < width_; ++x) {
                const float value = values_[std::size_t(y) * std::size_t(width_) + std::size_t(x)];
                if (value > 0.0f) canvas.blend(x, y, color, value);
            }
        }
    }

private:
    int width_, height_;
    std::vector<float> values_;
};

/// The parts of a line that its dashes leave.
template <class Visit>
void eachDash(const PlotLine& line, const Visit& visit) {
    const double dash = kScale * line.dash;
    double walked = 0.0;  // along the line, from its beginning
    for (std::size_t i = 1; i < line.points.size(); ++i) {
        const glm::dvec2 from = pixelsOf(line.points[i - 1]), to = pixelsOf(line.points[i]);
        const double length = glm::distance(from, to);
        if (dash <= 0.0 || length == 0.0) {
            visit(from, to);
            continue;
        }
        const auto at = [&](double distance) { return from + (to - from) * (distance / length); };
        for (double piece = std::floor(walked / dash); piece * dash < walked + length; ++piece) {
            if (std::fmod(piece, 2.0) != 0.0) continue;
            visit(at(std::max(piece * dash - walked, 0.0)), at(std::min((piece + 1) * dash - walked, length)));
        }
        walked += length;
    }
}

void write(const PlotText& text, Canvas& canvas) {
    const std::string line = shortened(text.text, canvas.width() / kScale);
    const int width = textWidth(line) * kScale;
    const int share = text.anchor == Anchor::Start ? 0 : text.anchor == Anchor::Middle ? width / 2 : width;
    const int x = std::clamp(int(kScale * text.at.x) - share, 0, std::max(0, canvas.width() - width));
    canvas.text(x, int(kScale * text.at.y) - kGlyphHeight * kScale, kScale, line, kWriting);
}

}  // namespace

RgbPicture pictureOf(const Drawing& drawing) {
    Canvas canvas(kScale * drawing.width, kScale * drawing.height);
    canvas.fill(0, 0, canvas.width(), canvas.height(), kPaper);
    for (const PlotLine& line : drawing.lines) {
        Coverage coverage(canvas.width(), canvas.height());
        eachDash(line,
                 [&](const glm::dvec2& from, const glm::dvec2& to) { coverage.add(from, to, kScale * line.width); });
        coverage.paint(canvas, line.color);
    }
    for (const PlotText& text : drawing.texts) write(text, canvas);
    return std::move(canvas).take();
}

}  // namespace umbrage
