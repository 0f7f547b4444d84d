// SPDX-License-Identifier: Apache-2.0
// Names that the sequence file, the frame and the image writer share; those of AOVs are in aovs.h. A new overlay is one
// line here.
#pragma once

#include <array>
#include <string_view>

namespace umbrage {

struct NameAndMeaning {
    std::string_view name, meaning;
};

inline constexpr std::array kOverlays = {
    NameAndMeaning{"stencil", "shadow counts in false colour"},
    NameAndMeaning{"overdraw", "shadow-volume fragments as a heat map"},
    NameAndMeaning{"silhouettes", "silhouette edges of each light"},
    NameAndMeaning{"volumes", "the shadow volumes themselves, translucent, with their edges"},
    NameAndMeaning{"casters", "whose volumes fill most at each pixel"},
    NameAndMeaning{"tiles", "tiles of 8 x 8 pixels that volumes touch, and in which counts change"},
    NameAndMeaning{"techniques", "the heat maps of two techniques side by side"},
};

// Techniques, the default first.
inline constexpr std::array kSilhouettes = {
    NameAndMeaning{"compute", "on the device, listed by compute shaders"},
    NameAndMeaning{"cpu", "on the host"},
};

inline constexpr std::array kCounts = {
    NameAndMeaning{"z-pass", "from the eye, with a constant for the volumes that hold it"},
    NameAndMeaning{"z-fail", "from infinity, with caps"},
    NameAndMeaning{"near-cap", "from a plane just before the near plane, with caps there"},
};

inline constexpr std::array kSkips = {
    NameAndMeaning{"halve", "one quad for two where every count is even"},
    NameAndMeaning{"range", "casters out of a light's range"},
};

}  // namespace umbrage
