// SPDX-License-Identifier: Apache-2.0
// What the judge says about a frame. All figures count samples (pixels, where there is one sample each).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace umbrage {

/// How a sample's mask compares with the exact answer.
enum class SampleVerdict : std::uint8_t {
    Right,
    Primary,    // wrong, but within the rasteriser's tolerance another surface is seen, for which it would be right
    Grazing,    // wrong, but the light is in the plane of the surface up to rounding
    Boundary,   // wrong, but within the tolerance of the shadow's boundary
    FalseDark,  // wrong without excuse
    FalseLit,
};

inline bool isHard(SampleVerdict v) {
    return v >= SampleVerdict::FalseDark;
}

/// One light's mask.
struct LightVerdict {
    std::string light;  // its id
    int samplesPerPixel = 1;
    std::uint64_t litFacing = 0;  // samples of surfaces that are turned to the light
    std::uint64_t exactDark = 0;  // of these in shadow
    std::uint64_t hardFalseDark = 0, hardFalseLit = 0;
    std::uint64_t primary = 0, grazing = 0, boundary = 0;  // mismatches that are explained
    std::uint64_t bandFalseDark = 0, bandFalseLit = 0;     // the same by their sign
    std::uint64_t bandPopulation = 0;                      // samples on which rounding may decide; a lower bound
    double boundaryLength = 0.0;                           // of the shadow's outline on screen, pixels
    std::uint64_t largestComponent = 0;                    // wrong pixels that hang together (8 neighbours)
    int largestExtent = 0;                                 // its larger side, pixels
    std::uint64_t countsJudged = 0, countErrors = 0, hardCountErrors = 0;  // only where counts were asked for
    std::uint64_t largestCountError = 0;
    std::uint64_t excessToggles = 0;  // pixels' changes since the frame before that the exact mask does not make

    std::uint64_t hard() const { return hardFalseDark + hardFalseLit; }
    std::uint64_t band() const { return primary + grazing + boundary; }
    /// (false dark - false lit) pixels / outline: how far the outline is moved outward on average, pixels.
    double signedBias() const;
    /// band() per lit-facing sample.
    double bandRate() const { return litFacing ? double(band()) / double(litFacing) : 0.0; }
};

/// Difference from the picture shaded with exact masks.
struct RadianceError {
    double largest = 0.0, rms = 0.0;  // linear, all channels
    int largestCode = 0;              // of 8-bit display codes
    double rmsCode = 0.0;
};

struct FrameVerdict {
    int frame = 0;
    std::string technique;  // silhouette:count
    std::vector<LightVerdict> lights;
    RadianceError radiance;
    double renderMilliseconds = 0.0, oracleMilliseconds = 0.0;  // the latter: of the exact answers, once a frame

    std::uint64_t hard() const;
    std::uint64_t hardCounts() const;
};

/// Per pixel and light, for pictures: the worst verdict of a pixel's samples, and its exact answer.
struct VerdictPlanes {
    int width = 0, height = 0;
    std::vector<std::vector<SampleVerdict>> verdicts;  // per light
    std::vector<std::vector<std::uint8_t>> exact;      // per light: 1 where all samples are reached
};

}  // namespace umbrage
