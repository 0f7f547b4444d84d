// SPDX-License-Identifier: Apache-2.0
// The comparison for people: one HTML file that needs nothing else.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "golden/comparison.h"

namespace umbrage {

/// A picture as its file stores it.
struct PagePicture {
    int width = 0, height = 0;
    std::vector<std::string> channels;  // as the file names them: R, G, B, A, Z, ...
    std::vector<float> values;          // rows from the top, channels interleaved
    bool isDisplayEncoded = false;      // values in [0, 1] for a display (sRGB), as a PNG's; else linear
};

struct PagePictures {
    std::optional<PagePicture> golden{}, output{};  // what there is
};

inline constexpr std::size_t kMostPageBytes = 64u << 20;  // of values; a browser opens that in seconds

/// Results that pass get a thumbnail, all others their exact values too: as bytes, halves or floats, whichever is the
/// smallest that holds them exactly, deflated. Failures come first; once `mostBytes` of text are reached, the values of
/// further images are left out, and the page says of how many.
/// @param pictures  asked once for every image, one after the other; nothing where there is none to show
std::string comparisonPage(const Comparison& comparison,
                           const std::function<std::optional<PagePictures>(const ImageResult&)>& pictures,
                           std::size_t mostBytes = kMostPageBytes);

}  // namespace umbrage
