// SPDX-License-Identifier: Apache-2.0
// The legend of a picture in which colours stand for things.
#pragma once

#include <span>
#include <string>

#include "image/canvas.h"

namespace umbrage {

struct KeyEntry {
    Rgb8 color{};
    std::string label;
    bool striped = false;  // with stripes of black
};

/// Whether pixel (x, y) of something striped is black.
inline bool isStripe(int x, int y) {
    return (x + y) / 3 % 2 != 0;
}

/// Draws it into the lower left corner; pictures too small for it get as many entries as fit, or none.
void drawKey(Canvas& canvas, const std::string& title, std::span<const KeyEntry> entries);

/// One line in the upper left corner.
void drawBurnIn(Canvas& canvas, const std::string& line);

}  // namespace umbrage
