// SPDX-License-Identifier: Apache-2.0
// A font of our own for the few words inside pictures, so that no font library or file is needed.
#pragma once

#include <string_view>

namespace umbrage {

inline constexpr int kGlyphWidth = 5, kGlyphHeight = 7;
inline constexpr int kGlyphAdvance = kGlyphWidth + 1;

/// Whether the glyph of `character` covers (x, y), x to the right, y down. Small letters look like capitals; characters
/// outside printable ASCII are drawn as a box.
bool glyphCovers(char character, int x, int y);

/// Width of a line of text in unscaled pixels, without the gap after its last character.
int textWidth(std::string_view text);

}  // namespace umbrage
