// SPDX-License-Identifier: Apache-2.0
#include "report/text_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace umbrage {
namespace {

std::size_t shownWidth(std::string_view text) {
    return std::size_t(std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xc0) != 0x80; }));
}

}  // namespace

std::string printable(std::string text) {
    std::replace_if(
        text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }, '?');
    return text;
}

std::string alignedTable(std::vector<std::vector<std::string>> rows, const std::vector<bool>& isText) {
    std::vector<std::size_t> widths(isText.size());
    for (std::vector<std::string>& row : rows) {
        for (std::size_t c = 0; c < row.size(); ++c) {
            row[c] = printable(row[c]);
            widths[c] = std::max(widths[c], shownWidth(row[c]));
        }
    }
    std::string text;
    for (const std::vector<std::string>& row : rows) {
        std::string line;
        for (std::size_t c = 0; c < row.size(); ++c) {
            const std::string blanks(widths[c] - shownWidth(row[c]), ' ');
            line += (c > 0 ? "  " : "") + (isText[c] ? row[c] + blanks : blanks + row[c]);
        }
        text += line.erase(line.find_last_not_of(' ') + 1) + "\n";
    }
    return text;
}

std::string markdownCell(const std::string& text) {
    std::string escaped;
    for (const char c : printable(text)) {
        if (std::string_view("\\|`*_<").find(c) != std::string_view::npos) escaped += '\\';
        escaped += c;
    }
    return escaped;
}

std::string markdownTable(const std::vector<std::vector<std::string>>& rows, const std::vector<bool>& isText) {
    std::string text;
    for (std::size_t r = 0; r < rows.size(); ++r) {
        text += "|";
        for (const std::string& cell : rows[r]) text += fmt::format(" {} |", markdownCell(cell));
        text += "\n";
        if (r > 0) continue;
        text += "|";
        for (const bool words : isText) text += words ? "---|" : "---:|";
        text += "\n";
    }
    return text;
}

}  // namespace umbrage
