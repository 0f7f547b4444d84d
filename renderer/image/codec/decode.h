// SPDX-License-Identifier: Apache-2.0
// Codec::decode.
#pragma once

#include <OpenImageIO/paramlist.h>

#include "image/image.h"

namespace umbrage {

/// @param attributes  where not null: becomes what the file says of itself besides
/// @throws Error(Input) that names `name`
DecodedImage decodeImage(std::span<const std::byte> encoded, std::string_view name,
                         OIIO::ParamValueList* attributes = nullptr);

}  // namespace umbrage
