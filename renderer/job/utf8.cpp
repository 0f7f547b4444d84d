// SPDX-License-Identifier: Apache-2.0
#include "job/utf8.h"

#include <cstddef>

namespace umbrage {
namespace {

// Bytes of the character that begins `text` (not empty), 0 if it is none: RFC 3629, so no overlong forms, no
// surrogates, nothing above U+10FFFF.
std::size_t characterLength(std::string_view text) {
    const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u; };
    const auto continues = [&](std::size_t i) { return (byte(i) & 0xC0u) == 0x80u; };
    const unsigned lead = byte(0);
    if (lead < 0x80u) return lead >= 0x20u ? (lead != 0x7Fu) : (lead == '\t' || lead == '\n' || lead == '\r');
    if (lead >= 0xC2u && lead <= 0xDFu) return continues(1) ? 2 : 0;
    if (lead >= 0xE0u && lead <= 0xEFu) {
        const bool overlong = lead == 0xE0u && byte(1) < 0xA0u;
        const bool surrogate = lead == 0xEDu && byte(1) > 0x9Fu;
        return continues(1) && continues(2) && !overlong && !surrogate ? 3 : 0;
    }
    if (lead >= 0xF0u && lead <= 0xF4u) {
        const bool overlong = lead == 0xF0u && byte(1) < 0x90u;
        const bool tooLarge = lead == 0xF4u && byte(1) > 0x8Fu;
        return continues(1) && continues(2) && continues(3) && !overlong && !tooLarge ? 4 : 0;
    }
    return 0;
}

}  // namespace

std::optional<TextPosition> firstUnreadableByte(std::string_view text) {
    TextPosition position;
    while (!text.empty()) {
        const std::size_t length = characterLength(text);
        if (length == 0) return position;
        if (text.front() == '\n') {
            ++position.line;
            position.column = 1;
        } else {
            position.column += static_cast<int>(length);
        }
        text.remove_prefix(length);
    }
    return std::nullopt;
}

}  // namespace umbrage
