// SPDX-License-Identifier: Apache-2.0
#include "image/key.h"

#include <algorithm>

#include "image/bitmap_font.h"

namespace umbrage {
namespace {

constexpr int kMargin = 4, kPadding = 4, kSwatch = 9, kGap = 4, kLine = kGlyphHeight + 3;  // pixels of the font

int scaleOf(const Canvas& canvas) {
    return std::max(1, (canvas.height() + 192) / 384);
}

}  // namespace

void drawKey(Canvas& canvas, const std::string& title, std::span<const KeyEntry> entries) {
    const int s = scaleOf(canvas);
    const int room = canvas.width() / s - 2 * (kMargin + kPadding),
              rows = (canvas.height() / 2 / s - 2 * kPadding) / kLine;
    if (rows < 2 || room < textWidth("MMMMMMMM")) return;
    const std::size_t shown = std::min(entries.size(), std::size_t(rows - 1));
    int width = textWidth(title);
    for (const KeyEntry& entry : entries.first(shown)) width = std::max(width, kSwatch + kGap + textWidth(entry.label));
    width = std::min(width, room);
    const int height = int(shown + 1) * kLine + 2 * kPadding;
    const int left = kMargin * s, top = canvas.height() - (kMargin + height) * s;
    canvas.fill(left, top, (width + 2 * kPadding) * s, height * s, kPanel);
    int y = top + kPadding * s;
    canvas.text(left + kPadding * s, y, s, shortened(title, width));
    for (const KeyEntry& entry : entries.first(shown)) {
        y += kLine * s;
        const int x = left + kPadding * s;
        for (int row = 0; row < kGlyphHeight * s; ++row) {
            for (int column = 0; column < kSwatch * s; ++column) {
                const bool black = entry.striped && isStripe(x + column, y + row);
                canvas.set(x + column, y + row, black ? Rgb8{} : entry.color);
            }
        }
        canvas.text(x + (kSwatch + kGap) * s, y, s, shortened(entry.label, width - kSwatch - kGap));
    }
}

void drawBurnIn(Canvas& canvas, const std::string& line) {
    const int s = scaleOf(canvas), room = canvas.width() / s - 2 * kPadding;
    if (room < textWidth("MMMMMMMM")) return;
    const std::string text = shortened(line, room);
    canvas.fill(0, 0, (textWidth(text) + 2 * kPadding) * s, (kGlyphHeight + kPadding) * s, kPanel);
    canvas.text(kPadding * s, kPadding / 2 * s, s, text);
}

}  // namespace umbrage
