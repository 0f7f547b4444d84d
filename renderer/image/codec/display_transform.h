// SPDX-License-Identifier: Apache-2.0
// Codec::displayTransform.
#pragma once

#include <memory>

#include "image/image.h"

namespace umbrage {

/// @throws Error(Input) that lists what the configuration offers
std::unique_ptr<DisplayTransform> makeDisplayTransform(const ColorRequest& request);

}  // namespace umbrage
