// SPDX-License-Identifier: Apache-2.0
// Globs of paths, as the sequence file and the command line have them.
#pragma once

#include <string_view>

namespace umbrage {

/// '*' is any text and '?' any character within one part of a path, '**' any text at all; the rest is literal.
bool matchesGlob(std::string_view glob, std::string_view path);

}  // namespace umbrage
