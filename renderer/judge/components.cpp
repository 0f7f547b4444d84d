// SPDX-License-Identifier: Apache-2.0
#include "judge/components.h"

#include <algorithm>

namespace umbrage {

Component largestComponent(const std::vector<bool>& marked, int width, int height) {
    Component largest;
    std::vector<bool> left = marked;
    std::vector<std::size_t> open;
    for (std::size_t start = 0; start < left.size(); ++start) {
        if (!left[start]) continue;
        Component here;
        int lowX = width, highX = 0, lowY = height, highY = 0;
        open.assign(1, start);
        left[start] = false;
        while (!open.empty()) {
            const int x = int(open.back() % std::size_t(width)), y = int(open.back() / std::size_t(width));
            open.pop_back();
            ++here.pixels;
            lowX = std::min(lowX, x), highX = std::max(highX, x);
            lowY = std::min(lowY, y), highY = std::max(highY, y);
            for (int ny = std::max(y - 1, 0); ny <= std::min(y + 1, height - 1); ++ny) {
                for (int nx = std::max(x - 1, 0); nx <= std::min(x + 1, width - 1); ++nx) {
                    const std::size_t neighbour = std::size_t(ny) * std::size_t(width) + std::size_t(nx);
                    if (!left[neighbour]) continue;
                    left[neighbour] = false;
                    open.push_back(neighbour);
                }
            }
        }
        here.extent = std::max(highX - lowX, highY - lowY) + 1;
        if (here.pixels > largest.pixels) largest = here;
    }
    return largest;
}

}  // namespace umbrage
