// SPDX-License-Identifier: Apache-2.0
// What the perceptual metrics see of two pictures: their colours, linear and finite.
#pragma once

#include <optional>
#include <vector>

#include "golden/flip.h"
#include "image/image.h"

namespace umbrage {

/// Whether there are float channels R, G, B, or Y, of no layer.
bool hasColours(const StoredImage& image);

/// Each figure is computed when it is first asked for. Alpha is left to other metrics: colours count as they are
/// stored. A pixel one of whose samples is a NaN or an infinity that the other picture has not there is as wrong as can
/// be: 1 in FLIP's map, and a failure of yee.
class Perception {
public:
    /// @param golden, output  of one size and with the same channels; both outlive this
    Perception(const StoredImage& golden, const StoredImage& output, double pixelsPerDegree);

    // Only where hasColours().
    const FlipMap& flip();
    const FlipMap& hdrFlip();
    double yeeShare();

private:
    void see();
    FlipMap withSpoiled(FlipMap map) const;

    const StoredImage &golden_, &output_;
    double pixelsPerDegree_;
    bool seen_ = false;
    LinearPicture goldenColors_, outputColors_;
    std::vector<std::size_t> spoiled_;
    std::optional<FlipMap> flip_, hdrFlip_;
};

}  // namespace umbrage
