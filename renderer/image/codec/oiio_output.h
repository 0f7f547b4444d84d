// SPDX-License-Identifier: Apache-2.0
// What both writers do with OpenImageIO: encode native, interleaved pixels into memory.
#pragma once

#include <OpenImageIO/imageio.h>

#include "image/codec/encode.h"

namespace umbrage {

/// @param spec  size, channels and their types, attributes
/// @param pixels  as `spec` describes them, rows from the top without padding
/// @throws Error(Output) that names `file`
EncodedFile encodeWithOiio(const std::filesystem::path& file, const std::string& format, const OIIO::ImageSpec& spec,
                           const void* pixels);

/// @throws Error(Output) for what no writer can store: no pixels, no channels, two channels of one name
void checkImage(const std::filesystem::path& file, const ImageFile& image);

}  // namespace umbrage
