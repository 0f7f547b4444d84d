// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace umbrage {

/// A word as a shell takes it: in quotes where it needs them.
std::string quotedForShell(const std::string& word);

/// The command as one would type it, for documents that say how they are made: quoted where a shell wants it, and
/// "configs/*.yaml" again where the shell has put all the sequences of a folder in its place.
std::string commandLine(int argc, const char* const* argv);

}  // namespace umbrage
