// SPDX-License-Identifier: Apache-2.0
// Runs the shipped program as its users do: a child process with its own folder, whose outputs are kept.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace umbrage::cli {

struct Result {
    int exitCode = -1;    // as a shell has it: 128 + n when killed by signal n
    bool killed = false;  // it took too long, and was ended
    std::string out, err;
    double seconds = 0.0;
    double peakMebibytes = 0.0;  // largest resident memory
};

struct Launch {
    std::filesystem::path program{};                      // empty: the one that was built
    std::filesystem::path folder{};                       // working directory
    std::vector<std::string> environment{};               // NAME=VALUE, besides the own one
    bool terminal = false;                                // stderr is a terminal
    std::filesystem::path standardOutput{};               // empty: kept in Result::out
    std::function<int(const std::string& err)> signal{};  // looks at stderr so far; a signal to send now, once, or 0
    double limitSeconds = 60.0;
};

/// @param arguments  without the program's name
/// @throws std::runtime_error if there is no such program
Result run(const Launch& launch, const std::vector<std::string>& arguments);

}  // namespace umbrage::cli
