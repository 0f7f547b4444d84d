// SPDX-License-Identifier: Apache-2.0
// Names that the sequence file, the frame and the image writer share. A new AOV or overlay is one line here.
#pragma once

#include <array>
#include <string_view>

namespace umbrage {

struct NameAndMeaning {
    std::string_view name, meaning;
};

inline constexpr std::array kAovs = {
    NameAndMeaning{"beauty", "the picture"},
    NameAndMeaning{"depth", "distance along the viewing direction, metres (Z)"},
    NameAndMeaning{"normal", "shading normal, world (N.X, N.Y, N.Z)"},
    NameAndMeaning{"shadow", "per light: 1 where it reaches the surface"},
    NameAndMeaning{"stencil", "per light: the shadow count"},
    NameAndMeaning{"overdraw", "shadow-volume fragments and stencil updates per pixel"},
};

inline constexpr std::array kOverlays = {
    NameAndMeaning{"stencil", "shadow counts in false colour"},
    NameAndMeaning{"overdraw", "shadow-volume fragments as a heat map"},
};

}  // namespace umbrage
