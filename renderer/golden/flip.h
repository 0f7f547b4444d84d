// SPDX-License-Identifier: Apache-2.0
// FLIP: what a person sees who looks from one picture to the other at the same place and back.
//
// LDR: Andersson, Nilsson, Akenine-Moller, Oskarsson, Astrom, Fairchild: "FLIP: A Difference Evaluator for Alternating
// Images", HPG 2020. HDR: Andersson, Nilsson, Shirley, Akenine-Moller: "Visualizing Errors in Rendered High Dynamic
// Range Images", Eurographics 2021 (short papers).
#pragma once

#include <span>
#include <vector>

namespace umbrage {

/// Interleaved linear Rec.709 triples, rows from the top, finite.
struct LinearPicture {
    int width = 0, height = 0;
    std::vector<float> rgb;
};

/// An error in [0, 1] for each pixel, rows from the top; at least one of them.
using FlipMap = std::vector<float>;

/// FLIP of two pictures of one size as a display shows them: values are clamped to [0, 1].
/// @param pixelsPerDegree  of the viewer's field of vision, > 0
FlipMap flipMap(const LinearPicture& reference, const LinearPicture& test, double pixelsPerDegree);

/// The exposures at which HDR-FLIP looks: factors are powers of two of stops that are evenly spread from `start` to
/// `stop`.
struct ExposureRange {
    double start = 0.0, stop = 0.0;
    int count = 1;

    double stops(int index) const { return count > 1 ? start + (stop - start) * index / (count - 1) : start; }
};

/// From the exposure that brings the reference's brightest pixel to 0.85 on the display to the one that brings its
/// median there, about a stop apart, two at least. Where the median is black, for most of a frame may be background, it
/// is that of the other pixels. Exposures end kMaximumExposureStops after the first: beyond, there is noise to see
/// only. Of a black reference: exposure 0 alone.
ExposureRange exposuresOf(const LinearPicture& reference);

inline constexpr double kMaximumExposureStops = 24.0;

/// The largest error of each pixel over all exposures, tone mapped by the fit to ACES that the paper uses by default.
FlipMap hdrFlipMap(const LinearPicture& reference, const LinearPicture& test, double pixelsPerDegree);

double meanError(const FlipMap& map);
double largestError(const FlipMap& map);

/// The least error such that those up to it add up to `share` of all error; 0 without error. That of 0.5 is the
/// weighted median.
/// @param share  in [0, 1]
double weightedPercentile(const FlipMap& map, double share);

}  // namespace umbrage
