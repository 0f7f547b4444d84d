// SPDX-License-Identifier: Apache-2.0
// Progress of a run on stderr: a bar with rate and time left on a terminal, plain lines elsewhere.
#pragma once

#include <chrono>
#include <cstddef>
#include <string>

#include "options.h"

namespace umbrage {

class Progress {
public:
    Progress(ProgressKind kind, bool quiet);
    ~Progress();

    void note(const std::string& text);
    void error(const std::string& text);
    /// @param title  stands in front of the bar
    void started(std::size_t frameCount, const std::string& title = {});
    /// @param what  the line's text: what happened to one frame more
    void advanced(const std::string& what);

private:
    void drawBar();
    void clearBar();

    ProgressKind kind_;
    bool quiet_, barShown_ = false;
    std::string title_;
    std::size_t done_ = 0, frameCount_ = 0;
    std::chrono::steady_clock::time_point start_;
};

}  // namespace umbrage
