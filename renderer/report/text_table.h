// SPDX-License-Identifier: Apache-2.0
// Tables in plain text, for terminals, and in Markdown.
#pragma once

#include <string>
#include <vector>

namespace umbrage {

/// Control characters in names must not move the cursor of a terminal or end a row: they become '?'.
std::string printable(std::string text);

/// One line a row, columns two blanks apart.
/// @param rows  of as many cells as isText
/// @param isText  per column: words at the left, else numbers at the right
std::string alignedTable(std::vector<std::vector<std::string>> rows, const std::vector<bool>& isText);

/// The same for documents, the first row as its head; what Markdown takes for markup is escaped.
std::string markdownTable(const std::vector<std::vector<std::string>>& rows, const std::vector<bool>& isText);

/// Text that means itself in Markdown.
std::string markdownCell(const std::string& text);

}  // namespace umbrage
