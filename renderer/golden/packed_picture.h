// SPDX-License-Identifier: Apache-2.0
// Pictures as text that the page's script unpacks (comparison.js).
//
// A picture is a plane for each byte of each channel: channel by channel, the lowest byte first, rows from the top. A
// plane is stored as differences modulo 256 to the byte at the left (in the first column to the one above), or to the
// same byte of the golden, of which an output of the same shape mostly is a copy. Then zlib's deflate, then base64.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "golden/comparison_page.h"

namespace umbrage {

/// The smallest that holds all values exactly: k/255 and k/65535 of display values, halves, floats.
enum class PackedType { UInt8, UInt16, Half, Float };

PackedType packedType(const std::vector<float>& values, bool isDisplayEncoded);

/// The half of this value, where there is one.
std::optional<std::uint16_t> exactHalf(float value);

struct PackedPicture {
    nlohmann::ordered_json head;  // width, height, channels, type, display, from: "left" or "golden"
    std::string text;             // base64
};

struct PackedPictures {
    std::optional<PackedPicture> golden, output;
};

PackedPictures packed(const PagePictures& pictures);

}  // namespace umbrage
