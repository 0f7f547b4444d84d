// SPDX-License-Identifier: Apache-2.0
// The pictures of a comparison, for its page.
#pragma once

#include <optional>

#include "golden/comparison_page.h"

namespace umbrage {

/// Both files, as far as they can be read; the result says why one cannot.
/// @param comparison  with its places as they are seen from the working directory
std::optional<PagePictures> picturesOf(const Comparison& comparison, const ImageResult& image);

}  // namespace umbrage
