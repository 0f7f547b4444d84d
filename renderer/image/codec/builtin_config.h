// SPDX-License-Identifier: Apache-2.0
// The text of configs/umbrage.ocio.
#pragma once

#include <string_view>

namespace umbrage {

extern const std::string_view kBuiltinColorConfig;

}  // namespace umbrage
