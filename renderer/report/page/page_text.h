// SPDX-License-Identifier: Apache-2.0
// Self-contained pages: what all of them share (common.*) and the statistics page's own (page.*).
#pragma once

#include <string>
#include <string_view>

namespace umbrage {

extern const std::string_view kCommonHtml, kCommonStyle, kCommonScript;
extern const std::string_view kPageHtml, kPageStyle, kPageScript;

struct PageParts {
    std::string title;                     // as it is
    std::string_view style, body, script;  // the page's own; the script may use what common.js has
    std::string data;                      // JSON, for the script, in the element "data"
    std::string more{};                    // elements after the data
};

/// One HTML file that asks for nothing else.
std::string wholePage(const PageParts& parts);

std::string base64(std::string_view bytes);

}  // namespace umbrage
