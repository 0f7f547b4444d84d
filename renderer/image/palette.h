// SPDX-License-Identifier: Apache-2.0
// Colours of things that are told apart, not ordered: Okabe and Ito's, for the colour-blind too, without the yellow
// that is lost on white.
#pragma once

#include <array>
#include <cstddef>

#include "image/false_color.h"

namespace umbrage {

inline constexpr std::array<Rgb8, 7> kCategoryColors{
    {{0, 114, 178}, {213, 94, 0}, {0, 158, 115}, {204, 121, 167}, {230, 159, 0}, {86, 180, 233}, {128, 128, 128}}};

/// They begin again when they are used up.
inline const Rgb8& categoryColor(std::size_t index) {
    return kCategoryColors[index % kCategoryColors.size()];
}

}  // namespace umbrage
