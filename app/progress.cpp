// SPDX-License-Identifier: Apache-2.0
#include "progress.h"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
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

void Progress::error(const std::string& text) {
    clearBar();
    say("umbrage: error: {}\n", text);
}

void Progress::started(std::size_t frameCount, const std::string& title) {
    start_ = std::chrono::steady_clock::now();
    frameCount_ = frameCount;
    done_ = 0;
    title_ = title.empty() ? "" : title + " ";
    if (kind_ == ProgressKind::Bar) drawBar();
}

/// Every step has its line, up to so many; then every hundredth part of the run.
constexpr std::size_t kMostLines = 1000;

void Progress::advanced(const std::string& what) {
    ++done_;
    if (kind_ == ProgressKind::Bar) {
        drawBar();
    } else if (kind_ == ProgressKind::Lines &&
               (frameCount_ <= kMostLines || 100 * done_ / frameCount_ != 100 * (done_ - 1) / frameCount_)) {
        say("{} ({} of {})\n", what, done_, frameCount_);
    }
}

void Progress::drawBar() {
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    const auto filled = int(kBarCells * done_ / std::max<std::size_t>(1, frameCount_));
    std::string rate;
    if (done_ > 0) {
        rate = fmt::format("  {:.2f} s a frame, {} left", seconds / double(done_),
                           clockText(seconds / double(done_) * double(frameCount_ - done_)));
    }
    say("\r\x1b[K{}[{}{}] {}/{}{}", title_, std::string(std::size_t(filled), '#'),
        std::string(std::size_t(kBarCells - filled), '.'), done_, frameCount_, rate);
    std::fflush(stderr);
    barShown_ = true;
}

void Progress::clearBar() {
    if (barShown_) say("\r\x1b[K");
    barShown_ = false;
}

}  // namespace umbrage
