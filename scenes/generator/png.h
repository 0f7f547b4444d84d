// SPDX-License-Identifier: Apache-2.0
// 8-bit pictures into PNG files in memory.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace generator {

struct Picture {
    int size = 0;                       // square
    std::vector<std::uint8_t> rgb{};    // rows from the top
    std::vector<std::uint8_t> alpha{};  // one a pixel; empty: opaque
};

std::string pngOf(const Picture& picture);

}  // namespace generator
