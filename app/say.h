// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <cstdio>

namespace umbrage {

/// To stderr. A log that cannot be written never ends a run (fmt::print would throw).
template <class... Args>
void say(fmt::format_string<Args...> text, Args&&... args) {
    const std::string line = fmt::format(text, std::forward<Args>(args)...);
    std::fwrite(line.data(), 1, line.size(), stderr);
}

}  // namespace umbrage
