// SPDX-License-Identifier: Apache-2.0
#include "golden/flip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/glm.hpp>
#include <numeric>

#include "golden/flip_color.h"
#include "golden/flip_filter.h"
#include "image/image.h"

namespace umbrage {
namespace {

using flip::Plane;

glm::vec3 colorAt(const LinearPicture& picture, std::size_t pixel) {
    return {picture.rgb[3 * pixel], picture.rgb[3 * pixel + 1], picture.rgb[3 * pixel + 2]};
}

/// The pixels whose error can be other than 0: where the pictures differ, and as far as that can be felt, twice, so
/// that what is felt is also computed from all that it depends on. Empty where they are equal.
PixelWindow windowOfDifferences(const LinearPicture& a, const LinearPicture& b, int reach) {
    int left = a.width, right = -1, top = a.height, bottom = -1;
    for (int y = 0; y < a.height; ++y) {
        for (int x = 0; x < a.width; ++x) {
            const std::size_t i = std::size_t(y) * a.width + x;
            if (std::equal(&a.rgb[3 * i], &a.rgb[3 * i] + 3, &b.rgb[3 * i])) continue;
            left = std::min(left, x), right = std::max(right, x);
            top = std::min(top, y), bottom = std::max(bottom, y);
        }
    }
    if (right < 0) return {};
    left = std::max(left - 2 * reach, 0), right = std::min(right + 2 * reach, a.width - 1);
    top = std::max(top - 2 * reach, 0), bottom = std::min(bottom + 2 * reach, a.height - 1);
    return {left, top, right - left + 1, bottom - top + 1};
}

LinearPicture cropped(const LinearPicture& picture, const PixelWindow& window) {
    LinearPicture result{window.width, window.height, {}};
    for (int y = 0; y < window.height; ++y) {
        const auto row = picture.rgb.begin() + 3 * (std::ptrdiff_t(window.y + y) * picture.width + window.x);
        result.rgb.insert(result.rgb.end(), row, row + 3 * window.width);
    }
    return result;
}

/// What the eye makes of a picture.
struct Percept {
    std::vector<glm::vec3> colors;     // filtered, as Hunt-adjusted L*a*b*
    std::vector<float> edges, points;  // how much of either there is
};

std::array<Plane, 3> ycxczPlanes(const LinearPicture& picture) {
    const std::size_t count = picture.rgb.size() / 3;
    std::array<Plane, 3> planes;
    for (Plane& plane : planes) plane = {picture.width, picture.height, std::vector<float>(count)};
    for (std::size_t i = 0; i < count; ++i) {
        const glm::vec3 color = flip::ycxczOf(glm::clamp(colorAt(picture, i), 0.0f, 1.0f));
        for (int c = 0; c < 3; ++c) planes[c].values[i] = color[c];
    }
    return planes;
}

std::vector<float> lengths(const Plane& x, const Plane& y) {
    std::vector<float> result(x.values.size());
    for (std::size_t i = 0; i < result.size(); ++i) {
        result[i] = std::sqrt(x.values[i] * x.values[i] + y.values[i] * y.values[i]);
    }
    return result;
}

Percept perceive(const LinearPicture& picture, const flip::Sensitivities& sensitivities,
                 const flip::FeatureKernels& kernels) {
    std::array<Plane, 3> planes = ycxczPlanes(picture);

    Percept percept;
    Plane& grey = planes[0];
    const Plane y = sensitivities.achromatic.applied(grey);
    const Plane cx = sensitivities.redGreen.applied(planes[1]);
    const Plane cz = sensitivities.blueYellow.applied(planes[2]);
    percept.colors.reserve(y.values.size());
    for (std::size_t i = 0; i < y.values.size(); ++i) {
        const glm::vec3 linear = flip::linearOf({y.values[i], cx.values[i], cz.values[i]});
        percept.colors.push_back(flip::huntLabOf(glm::clamp(linear, 0.0f, 1.0f)));
    }

    // Features are looked for in what was not filtered, with luminance in [0, 1].
    for (float& value : grey.values) value = (value + 16.0f) / 116.0f;
    const Plane smoothRows = flip::alongRows(grey, kernels.gaussian);
    percept.edges = lengths(flip::alongColumns(flip::alongRows(grey, kernels.first), kernels.gaussian),
                            flip::alongColumns(smoothRows, kernels.first));
    percept.points = lengths(flip::alongColumns(flip::alongRows(grey, kernels.second), kernels.gaussian),
                             flip::alongColumns(smoothRows, kernels.second));
    return percept;
}

/// Errors of colour and of features, the second as an exponent that raises the first (section 4.3).
float errorOf(const Percept& a, const Percept& b, std::size_t i) {
    const float color = flip::redistributed(flip::hyab(a.colors[i], b.colors[i]));
    if (color == 0.0f) return 0.0f;
    const float feature = std::max(std::abs(a.edges[i] - b.edges[i]), std::abs(a.points[i] - b.points[i]));
    return std::pow(color, 1.0f - std::sqrt(std::min(1.0f, feature / std::sqrt(2.0f))));
}

double medianOf(std::vector<float> values) {
    const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// Narkowicz's fit to ACES with its exposure of 0.6 taken in: (a x^2 + b x) / (c x^2 + d x + e).
constexpr double kToneA = 0.36 * 2.51, kToneB = 0.6 * 0.03, kToneC = 0.36 * 2.43, kToneD = 0.6 * 0.59, kToneE = 0.14;

LinearPicture toneMapped(const LinearPicture& picture, double stops) {
    const double factor = std::exp2(stops);
    LinearPicture result = picture;
    for (float& value : result.rgb) {
        const double x = std::max(0.0, factor * value);
        value = float(std::min(1.0, x * (kToneA * x + kToneB) / (x * (kToneC * x + kToneD) + kToneE)));
    }
    return result;
}

}  // namespace

FlipMap flipMap(const LinearPicture& reference, const LinearPicture& test, double pixelsPerDegree) {
    FlipMap map(reference.rgb.size() / 3);
    const PixelWindow window = windowOfDifferences(reference, test, flip::reach(pixelsPerDegree));
    if (window.width == 0) return map;
    const flip::Sensitivities sensitivities(pixelsPerDegree);
    const flip::FeatureKernels kernels(pixelsPerDegree);
    const Percept a = perceive(cropped(reference, window), sensitivities, kernels);
    const Percept b = perceive(cropped(test, window), sensitivities, kernels);
    for (int y = 0; y < window.height; ++y) {
        for (int x = 0; x < window.width; ++x) {
            map[std::size_t(window.y + y) * reference.width + window.x + x] =
                errorOf(a, b, std::size_t(y) * window.width + x);
        }
    }
    return map;
}

ExposureRange exposuresOf(const LinearPicture& reference) {
    std::vector<float> all, bright;
    for (std::size_t i = 0; i < reference.rgb.size() / 3; ++i) {
        all.push_back(flip::luminanceOf(colorAt(reference, i)));
        if (all.back() > 0.0f) bright.push_back(all.back());
    }
    if (bright.empty()) return {};
    const double brightest = *std::max_element(bright.begin(), bright.end());
    const double medianOfAll = medianOf(all), median = medianOfAll > 0.0 ? medianOfAll : medianOf(bright);

    // The x whose tone mapped value is 0.85: the positive root of (a - 0.85 c) x^2 + (b - 0.85 d) x - 0.85 e.
    constexpr double kTarget = 0.85;
    const double p = kToneA - kTarget * kToneC, q = kToneB - kTarget * kToneD, r = -kTarget * kToneE;
    const double x = (-q + std::sqrt(q * q - 4.0 * p * r)) / (2.0 * p);
    ExposureRange range;
    range.start = std::log2(x / brightest);
    range.stop = std::min(std::log2(x / median), range.start + kMaximumExposureStops);
    range.count = std::max(2, int(std::ceil(range.stop - range.start)));
    return range;
}

FlipMap hdrFlipMap(const LinearPicture& reference, const LinearPicture& test, double pixelsPerDegree) {
    FlipMap map(reference.rgb.size() / 3);
    if (reference.rgb == test.rgb) return map;
    const ExposureRange exposures = exposuresOf(reference);
    for (int i = 0; i < exposures.count; ++i) {
        const double stops = exposures.stops(i);
        const FlipMap one = flipMap(toneMapped(reference, stops), toneMapped(test, stops), pixelsPerDegree);
        std::transform(map.begin(), map.end(), one.begin(), map.begin(),
                       [](float a, float b) { return std::max(a, b); });
    }
    return map;
}

double meanError(const FlipMap& map) {
    return std::accumulate(map.begin(), map.end(), 0.0) / double(map.size());
}

double largestError(const FlipMap& map) {
    return *std::max_element(map.begin(), map.end());
}

double weightedPercentile(const FlipMap& map, double share) {
    FlipMap sorted = map;
    std::sort(sorted.begin(), sorted.end());
    const double total = std::accumulate(sorted.begin(), sorted.end(), 0.0);
    double below = 0.0;
    for (const float value : sorted) {
        below += value;
        if (below > 0.0 && below >= share * total) return value;
    }
    return sorted.back();
}

}  // namespace umbrage
