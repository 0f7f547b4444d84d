// SPDX-License-Identifier: Apache-2.0
// What HTML and SVG have in common.
#pragma once

#include <string>
#include <string_view>

#include "image/false_color.h"

namespace umbrage {

/// Text that may stand between tags and in attributes. Control characters, which XML has no word for, become '?'.
std::string escapedMarkup(std::string_view text);

/// #rrggbb
std::string cssColor(const Rgb8& color);

}  // namespace umbrage
