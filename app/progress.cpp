// SPDX-License-Identifier: Apache-2.0
#include "progress.h"

#include <fmt/core.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>

#include "say.h"

namespace umbrage {
namespace {

constexpr int kBarCells = 30;

std::string clockText(double seconds) {
    const long s = std::lround(seconds);
    return s >= 3600 ? fmt::format("{}:{:02}:{:02}", s / 3600, s / 60 % 60, s % 60)
                     : fmt::format("{}:{:02}", s / 60, s % 60);
}

}  // namespace

Progress::Progress(ProgressKind kind, bool quiet) : kind_(kind), quiet_(quiet) {
    if (kind_ == ProgressKind::Auto) kind_ = isatty(STDERR_FILENO) ? ProgressKind::Bar : ProgressKind::Lines;
    if (quiet_) kind_ = ProgressKind::None;
}

Progress::~Progress() {
    clearBar();
}

void Progress::note(const std::string& text) {
    if (quiet_) return;
    clearBar();
    say("umbrage: {}\n", text);
}

void Progress::started(std::size_t frameCount) {
    start_ = std::chrono::steady_clock::now();
    if (kind_ == ProgressKind::Bar) drawBar(0, frameCount);
}

void Progress::frameWritten(int frame, std::size_t done, std::size_t frameCount) {
    if (kind_ == ProgressKind::Bar) {
        drawBar(done, frameCount);
    } else if (kind_ == ProgressKind::Lines) {
        say("frame {} written ({} of {})\n", frame, done, frameCount);
    }
}

void Progress::drawBar(std::size_t done, std::size_t frameCount) {
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    const auto filled = int(kBarCells * done / std::max<std::size_t>(1, frameCount));
    std::string rate;
    if (done > 0) {
        rate = fmt::format("  {:.2f} s a frame, {} left", seconds / double(done),
                           clockText(seconds / double(done) * double(frameCount - done)));
    }
    say("\r\x1b[K[{}{}] {}/{}{}", std::string(std::size_t(filled), '#'),
        std::string(std::size_t(kBarCells - filled), '.'), done, frameCount, rate);
    std::fflush(stderr);
    barShown_ = true;
}

void Progress::clearBar() {
    if (barShown_) say("\r\x1b[K");
    barShown_ = false;
}

}  // namespace umbrage
