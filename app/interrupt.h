// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>

namespace umbrage {

/// From now on the first SIGINT or SIGTERM sets what is returned, so that the run ends after the frame at hand; a
/// second one ends it the usual way. Files appear whole or not at all, so either is safe.
const std::atomic<bool>& watchForInterrupts();

/// The exit code for the signal that came.
int interruptExitCode();

}  // namespace umbrage
