// SPDX-License-Identifier: Apache-2.0
// The colours of counts.
#pragma once

#include <array>
#include <cstdint>

namespace umbrage {

using Rgb8 = std::array<std::uint8_t, 3>;

/// A path through OKLCh space that was chosen for counts: lightness rises in a straight line, hue turns from violet
/// over blue and teal to yellow, without the reds and greens of equal lightness that the colour-blind confuse.
class FalseColor {
public:
    /// @param scaleMaximum  > 0
    explicit FalseColor(float scaleMaximum);

    /// @param x, y  the pixel, for the stripes of what is off the scale
    /// @param count  not 0, not NaN
    Rgb8 at(float count, int x, int y) const;

private:
    float scaleMaximum_;
    std::array<Rgb8, 256> table_;
};

}  // namespace umbrage
