// SPDX-License-Identifier: Apache-2.0
// What an encoded picture declares about itself, read from its first bytes by hand: the decoders allocate what a file
// claims, so the claim is judged before they see it.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace umbrage {

struct EncodedHeader {
    std::string_view format;  // OpenImageIO's name of the reader: png, jpeg, webp
    int width = 0, height = 0;
};

/// Reads the size a PNG, JPEG or WebP declares, and refuses what no file of that length can hold.
/// @throws Error(Input) that names `name`: another kind of file, cut short, or a size out of bounds
EncodedHeader readEncodedHeader(std::span<const std::byte> encoded, const std::string& name);

}  // namespace umbrage
