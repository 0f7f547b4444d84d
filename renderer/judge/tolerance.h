// SPDX-License-Identifier: Apache-2.0
// What a rasteriser may round: samples that change within it are on a boundary.
#pragma once

namespace umbrage {

/// From the sub-pixel grid and the depth format in use (see docs/exactness.md).
struct Tolerance {
    double lateralPixels = 1.0 / 128;  // twice the sub-pixel grid's step of 2^-8: both ends of an edge snap
    double depth = 0x1p-23;            // of the largest distance on the polygon: two quanta of a 32-bit float depth
    double position = 0x1p-22;         // of the largest coordinate relative to the eye: four roundings of a float
    double grazing = 1e-5;             // sine of the angle below which facing is open
};

/// @param subPixelBits  GL_SUBPIXEL_BITS
inline Tolerance toleranceOf(int subPixelBits) {
    Tolerance tolerance;
    tolerance.lateralPixels = 2.0 / double(1 << subPixelBits);
    return tolerance;
}

}  // namespace umbrage
