// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

namespace umbrage {

/// sRGB's encoding (IEC 61966-2-1) of linear light in [0, 1].
inline float displayEncoded(float linear) {
    return linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1.0f / 2.4f) - 0.055f;
}

}  // namespace umbrage
