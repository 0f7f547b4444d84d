// SPDX-License-Identifier: Apache-2.0
#include "report/page/page_text.h"

#include <cstdint>
#include <map>

#include "report/markup.h"

namespace umbrage {

std::string wholePage(const PageParts& parts) {
    // nothing in the data may begin a tag
    std::string data;
    for (const char c : parts.data) data += c == '<' ? std::string("\\u003c") : std::string(1, c);
    const std::map<std::string_view, std::string> texts{{"TITLE", escapedMarkup(parts.title)},
                                                        {"STYLE", std::string(kCommonStyle).append(parts.style)},
                                                        {"BODY", std::string(parts.body)},
                                                        {"DATA", data},
                                                        {"MORE", parts.more},
                                                        {"SCRIPT", std::string(kCommonScript).append(parts.script)}};
    std::string page;
    std::string_view rest = kCommonHtml;  // text, %NAME%, text, %NAME% ... text
    for (bool isName = false; !rest.empty(); isName = !isName) {
        const std::size_t end = rest.find('%');
        const std::string_view piece = rest.substr(0, end);
        page += isName ? texts.at(piece) : std::string(piece);
        rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
    }
    return page;
}

std::string base64(std::string_view bytes) {
    constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t three = 0;
        for (std::size_t j = i; j < i + 3; ++j) three = three << 8 | (j < bytes.size() ? std::uint8_t(bytes[j]) : 0u);
        for (std::size_t j = 0; j < 4; ++j) text += i + j <= bytes.size() ? kDigits[three >> (18 - 6 * j) & 63u] : '=';
    }
    return text;
}

}  // namespace umbrage
