// SPDX-License-Identifier: Apache-2.0
// The texts of page.html, page.css and page.js.
#pragma once

#include <string_view>

namespace umbrage {

extern const std::string_view kPageHtml, kPageStyle, kPageScript;

}  // namespace umbrage
