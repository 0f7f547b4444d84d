// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace umbrage {

/// A field of a CSV line, quoted where RFC 4180 wants it.
std::string csvField(const std::string& text);

}  // namespace umbrage
