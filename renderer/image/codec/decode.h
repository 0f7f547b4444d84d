// SPDX-License-Identifier: Apache-2.0
// Codec::decode.
#pragma once

#include "image/image.h"

namespace umbrage {

/// @throws Error(Input) that names `name`
DecodedImage decodeImage(std::span<const std::byte> encoded, std::string_view name);

}  // namespace umbrage
