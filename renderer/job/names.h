// SPDX-License-Identifier: Apache-2.0
// Names that the sequence file, the frame and the image writer share. A new AOV or overlay is one line here.
#pragma once

#include <array>
#include <string_view>

namespace umbrage {

struct NameAndMeaning {
    std::string_view name, meaning;
};

struct AovName {
    std::string_view name, meaning;
    bool isPicture;  // may be a PNG; data would be cut to [0, 1] there
};

inline constexpr std::array kAovs = {
    AovName{"beauty", "the picture", true},
    AovName{"depth", "distance along the viewing direction, metres, or infinite (Z)", false},
    AovName{"normal", "shading normal, world (N.X, N.Y, N.Z)", false},
    AovName{"shadow", "per light: 1 where it reaches the surface", false},
    AovName{"stencil", "per light: the shadow count", false},
    AovName{"overdraw", "shadow-volume fragments and stencil updates per pixel", false},
};

inline constexpr std::array kOverlays = {
    NameAndMeaning{"stencil", "shadow counts in false colour"},
    NameAndMeaning{"overdraw", "shadow-volume fragments as a heat map"},
};

inline constexpr std::array kSkips = {
    NameAndMeaning{"halve", "one quad for two where every count is even"},
    NameAndMeaning{"range", "casters out of a light's range"},
};

}  // namespace umbrage
