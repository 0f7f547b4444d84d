// SPDX-License-Identifier: Apache-2.0
// Hints for misspelt names: the nearest known one, or the list of them.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace umbrage {

/// Levenshtein's distance in bytes: insertions, deletions and replacements that turn `a` into `b`.
std::size_t editDistance(std::string_view a, std::string_view b);

/// `did you mean "X"?` when a known name is near enough to be meant, else `known: A, B, ...` (the nearest ones when
/// there are many), or "" when nothing is known.
std::string hintForName(std::string_view name, std::span<const std::string> known);

}  // namespace umbrage
