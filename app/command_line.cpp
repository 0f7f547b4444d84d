// SPDX-License-Identifier: Apache-2.0
#include "command_line.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <vector>

namespace umbrage {
namespace {

namespace fs = std::filesystem;

bool isSequence(const fs::path& file) {
    return file.extension() == ".yaml";
}

/// Those that *.yaml stands for.
std::set<fs::path> sequencesIn(const fs::path& folder) {
    std::set<fs::path> files;
    std::error_code failed;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder.empty() ? "." : folder, failed)) {
        const fs::path name = entry.path().filename();
        if (isSequence(name) && name.string().front() != '.') files.insert(name);
    }
    return files;
}

}  // namespace

std::string quotedForShell(const std::string& word) {
    const bool plain = !word.empty() && std::all_of(word.begin(), word.end(), [](unsigned char c) {
        return c >= 0x80 || std::isalnum(c) || std::string_view("-_./:=,+@%").find(char(c)) != std::string_view::npos;
    });
    if (plain) return word;
    std::string made = "'";
    for (const char c : word) made += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return made + "'";
}

std::string commandLine(int argc, const char* const* argv) {
    std::string line = "umbrage";
    for (int i = 1; i < argc;) {
        const fs::path folder = fs::path(argv[i]).parent_path();
        std::set<fs::path> together;
        int end = i;
        while (end < argc && isSequence(argv[end]) && fs::path(argv[end]).parent_path() == folder) {
            together.insert(fs::path(argv[end++]).filename());
        }
        if (together.size() > 1 && together == sequencesIn(folder)) {
            line.append(" ").append(folder.empty() ? "" : quotedForShell(folder.string() + "/")).append("*.yaml");
            i = end;
        } else {
            line.append(" ").append(quotedForShell(argv[i++]));
        }
    }
    return line;
}

}  // namespace umbrage
