// SPDX-License-Identifier: Apache-2.0
// Codec::read: a picture as a file stores it.
#pragma once

#include "image/image.h"

namespace umbrage {

/// @throws Error(Input) that names `file`
StoredImage readStored(const std::filesystem::path& file);

}  // namespace umbrage
