// SPDX-License-Identifier: Apache-2.0
// What an EXR file declares about itself, read from its first bytes by hand: the decoder allocates what a file claims,
// so the claim is judged before it sees it.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "image/image.h"

namespace umbrage {

inline constexpr std::string_view kExrMagic{"\x76\x2f\x31\x01", 4};

struct ExrHeader {
    PixelWindow data, display;
    std::size_t channelCount = 0;
    std::size_t pixelBytes = 0;  // of all channels
};

/// Reads the header as "OpenEXR File Layout" (openexr.com) describes it, and refuses what no file of that length holds.
/// @throws Error(Input) that names `name`: damaged, several parts, deep or subsampled pixels, a size out of bounds
ExrHeader readExrHeader(std::span<const std::byte> encoded, const std::string& name);

}  // namespace umbrage
