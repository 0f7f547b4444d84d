// SPDX-License-Identifier: Apache-2.0
// Codec::yeeFailures: OpenImageIO's version of Yee's perceptual comparison.
#pragma once

#include <cstddef>
#include <span>

namespace umbrage {

/// As Codec::yeeFailures.
std::size_t countYeeFailures(int width, int height, std::span<const float> golden, std::span<const float> output);

}  // namespace umbrage
