// SPDX-License-Identifier: Apache-2.0
// How much two pictures differ, in the figures that limits are set on.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "golden/comparison.h"
#include "image/image.h"
#include "job/golden_rules.h"

namespace umbrage {

/// @return  null for an unknown name
const MetricInfo* findMetric(std::string_view name);

struct MeasureSettings {
    /// A pixel differs where any of its samples does by more than this; integer samples by anything at all.
    double tolerance = 0.0;
    /// Pixels on a side of densest's window, >= 1; it is clipped to the picture where that is smaller.
    int window = 11;
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
