// SPDX-License-Identifier: Apache-2.0
// Codec::write's two kinds of file, as bytes. Equal images give equal bytes.
#pragma once

#include <vector>

#include "image/image.h"

namespace umbrage {

using EncodedFile = std::vector<unsigned char>;

/// 1 to 4 channels of one type, UInt8 or UInt16; values outside [0, 1] are clamped.
/// @throws Error(Output) that names `file`
EncodedFile encodePng(const std::filesystem::path& file, const ImageFile& image);

/// Any channels. Half: finite values beyond 65504 are stored as 65504.
/// @throws Error(Output) that names `file`
EncodedFile encodeExr(const std::filesystem::path& file, const ImageFile& image);

}  // namespace umbrage
