// SPDX-License-Identifier: Apache-2.0
#include "interrupt.h"

#include <csignal>

#include "exit_codes.h"

namespace umbrage {
namespace {

std::atomic<bool> interrupted{false};
std::atomic<int> interruptSignal{0};

void onSignal(int signal) {
    interrupted = true;
    interruptSignal = signal;
    std::signal(signal, SIG_DFL);
}

}  // namespace

const std::atomic<bool>& watchForInterrupts() {
    std::signal(SIGINT, onSignal);
    std::signal(SIGTERM, onSignal);
    return interrupted;
}

int interruptExitCode() {
    return interruptSignal == SIGTERM ? kTerminated : kInterrupted;
}

}  // namespace umbrage
