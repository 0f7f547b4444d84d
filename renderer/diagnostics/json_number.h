// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <nlohmann/json.hpp>

namespace umbrage {

/// A number in its shortest form: a whole one as such, 1 and not 1.0. What is not finite becomes null in JSON.
inline nlohmann::ordered_json shortestNumber(double value) {
    if (value == std::floor(value) && std::abs(value) < 1e15) return static_cast<long long>(value);
    return value;
}

}  // namespace umbrage
