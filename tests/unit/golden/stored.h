// SPDX-License-Identifier: Apache-2.0
// Pictures for the tests of comparisons, as the codec would read them.
#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "golden/flip.h"
#include "image/image.h"

namespace umbrage::test {

using Floats = std::vector<float>;
using Integers = std::vector<std::uint32_t>;

struct NamedValues {
    std::string name;
    std::variant<Floats, Integers> values;
};

/// Of display values, unless said otherwise.
inline StoredImage stored(int width, int height, const std::vector<NamedValues>& channels, bool displayEncoded = true) {
    StoredImage image;
    image.data = image.display = {0, 0, width, height};
    image.displayEncoded = displayEncoded;
    for (const NamedValues& channel : channels) {
        const bool floats = std::holds_alternative<Floats>(channel.values);
        image.channels.push_back({channel.name, floats ? PixelType::Float : PixelType::UInt32, channel.values});
    }
    return image;
}

inline LinearPicture constantPicture(int width, int height, float r, float g, float b) {
    LinearPicture picture{width, height, {}};
    for (int i = 0; i < width * height; ++i) picture.rgb.insert(picture.rgb.end(), {r, g, b});
    return picture;
}

/// @param brightest  values are in [0, this)
inline LinearPicture randomPicture(int width, int height, unsigned seed, float brightest = 1.0f) {
    LinearPicture picture{width, height, {}};
    std::mt19937 random(seed);
    for (int i = 0; i < 3 * width * height; ++i) picture.rgb.push_back(brightest * float(random() % 65536) / 65536.0f);
    return picture;
}

}  // namespace umbrage::test
