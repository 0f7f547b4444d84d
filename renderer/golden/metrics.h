// SPDX-License-Identifier: Apache-2.0
// How much two pictures differ, in the figures that limits are set on.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "golden/comparison.h"
#include "image/image.h"

namespace umbrage {

struct MetricInfo {
    std::string_view name;     // in rules and reports
    std::string_view meaning;  // for people
    std::string_view unit;     // of the value; empty: a plain number
    bool largerIsWorse = true;
};

/// A sample is one channel's value of one pixel. Differences of integer channels count as numbers.
inline constexpr std::array kMetrics{
    MetricInfo{"max-abs", "largest difference of a sample", "value"},
    MetricInfo{"mean-abs", "mean difference over all samples", "value"},
    MetricInfo{"rmse", "root of the mean square difference over all samples", "value"},
    MetricInfo{"psnr", "peak signal to noise ratio; infinite for equal pictures", "dB", false},
    MetricInfo{"max-relative", "largest difference of a sample, in relation to the golden's", "ratio"},
    MetricInfo{"mean-relative", "mean over all samples of the difference in relation to the golden's", "ratio"},
    MetricInfo{"fraction", "share of pixels that differ by more than the tolerance", "share"},
    MetricInfo{"densest", "share of such pixels in the window that has most of them", "share"},
    MetricInfo{"uint-different", "samples of integer channels that are not equal", "samples"},
    MetricInfo{"flip", "mean of the FLIP error map, at one exposure", "[0, 1]"},
    MetricInfo{"flip-median", "weighted median of the FLIP error map: half of all error lies above", "[0, 1]"},
    MetricInfo{"flip-max", "largest value of the FLIP error map", "[0, 1]"},
    MetricInfo{"hdr-flip", "mean of the FLIP error map, the largest over all exposures at each pixel", "[0, 1]"},
    MetricInfo{"hdr-flip-max", "largest value of that map", "[0, 1]"},
    MetricInfo{"yee", "share of pixels that fail OpenImageIO's version of Yee's perceptual comparison", "share"},
};

/// @return  null for an unknown name
const MetricInfo* findMetric(std::string_view name);

struct MeasureSettings {
    /// A pixel differs where any of its samples does by more than this; integer samples by anything at all.
    double tolerance = 0.0;
    /// Pixels on a side of densest's window, >= 1; it is clipped to the picture where that is smaller.
    int window = 16;
    /// Relative differences are |output - golden| / max(|golden|, this), > 0: near black a ratio says nothing.
    double relativeFloor = 0.01;
    /// Of the viewer FLIP stands for: 67 is a display of 0.7 m and 3840 pixels across, seen from 0.7 m.
    double pixelsPerDegree = 67.0;
};

struct Measured {
    std::vector<Figure> figures;        // in the order they were wanted; those that do not apply are left out
    std::pair<int, int> worst{-1, -1};  // the pixel with the largest difference of a sample, the first of several, from
                                        // the top left of the data window; -1: there is no difference
};

/// Whether a picture has what a metric is about: psnr, relative differences and yee need float channels, uint-different
/// integer ones, flip and yee colours (R, G, B or Y), hdr-flip linear ones.
bool applies(std::string_view metric, const StoredImage& image);

/// Sums are taken in double and in one order: equal pictures give equal figures again (FLIP's and yee's last digits are
/// those of the machine's powers and roots). A sample that is the same
/// infinity, or a NaN, in both is no difference; one that is so in one of them alone is an infinite difference.
/// The peak of psnr is 1 for display values, else the largest finite magnitude of the golden, at least 1.
/// @param golden, output  of one size, with the same channels of the same kinds
/// @param wanted  names of kMetrics
/// @throws Error(Input) for pictures that cannot be compared and for unknown names
Measured measure(const StoredImage& golden, const StoredImage& output, const MeasureSettings& settings,
                 std::span<const std::string> wanted);

}  // namespace umbrage
