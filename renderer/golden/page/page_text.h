// SPDX-License-Identifier: Apache-2.0
// The texts of the files beside this one; the script is unpack.js, viewer.js and comparison.js.
#pragma once

#include <string_view>

namespace umbrage {

extern const std::string_view kComparisonHtml, kComparisonStyle, kComparisonScript;

}  // namespace umbrage
