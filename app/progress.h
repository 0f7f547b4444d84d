// SPDX-License-Identifier: Apache-2.0
// Progress of a run on stderr: a bar with rate and time left on a terminal, plain lines elsewhere.
#pragma once

#include <chrono>

#include "batch/batch.h"
#include "options.h"

namespace umbrage {

class Progress : public BatchObserver {
public:
    Progress(ProgressKind kind, bool quiet);
    ~Progress() override;

    void note(const std::string& text) override;
    void started(std::size_t frameCount) override;
    void frameWritten(int frame, std::size_t done, std::size_t frameCount) override;

private:
    void drawBar(std::size_t done, std::size_t frameCount);
    void clearBar();

    ProgressKind kind_;
    bool quiet_, barShown_ = false;
    std::chrono::steady_clock::time_point start_;
};

}  // namespace umbrage
