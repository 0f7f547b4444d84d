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

/// A way of counting, and when it claims to be exact: always, where it does not say otherwise itself (then
/// shadow.whenInexact decides), or never.
enum class Exact { Always, UnlessItSaysSo, Never };
struct CountName {
    std::string_view name, meaning;
    Exact exact;
};

inline constexpr std::array kOverlays = {
    NameAndMeaning{"stencil", "shadow counts in false colour"},
    NameAndMeaning{"stencil-zero", "shadow counts in green where they are zero and in red where not (Kilgard 2001)"},
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
    CountName{"z-pass", "from the eye, with a constant for the volumes that hold it", Exact::Always},
    CountName{"z-fail", "from infinity, with caps", Exact::Always},
    CountName{"near-cap", "from a plane just before the near plane, with caps there", Exact::Always},
    CountName{"z-pass-plus", "from the near plane, where the light's view of it counts what it cuts", Exact::Never},
    CountName{"invert", "from the eye, only whether counts are odd", Exact::UnlessItSaysSo},
    CountName{"z-fail-finite", "from infinity, with volumes that end", Exact::UnlessItSaysSo},
};

inline constexpr std::array kWhenInexact = {
    NameAndMeaning{"fall-back", "such lights are counted by z-pass, and a note says so"},
    NameAndMeaning{"refuse", "an error"},
    NameAndMeaning{"allow", "what comes out comes out"},
};

inline constexpr std::array kSkips = {
    NameAndMeaning{"halve", "one quad for two where every count is even"},
    NameAndMeaning{"range", "casters out of a light's range"},
};

}  // namespace umbrage
