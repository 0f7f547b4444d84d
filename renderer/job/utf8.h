// SPDX-License-Identifier: Apache-2.0
// Is this text? The YAML library replaces broken UTF-8 silently and takes some control characters for the end.
#pragma once

#include <optional>
#include <string_view>

namespace umbrage {

struct TextPosition {
    int line = 1, column = 1;  // from 1; columns count bytes
};

/// The first byte that is neither part of valid UTF-8 nor an allowed control character (tab, line ends).
std::optional<TextPosition> firstUnreadableByte(std::string_view text);

}  // namespace umbrage
