// SPDX-License-Identifier: Apache-2.0
// What the program's exit status means, in one place.
#pragma once

#include "error.h"

namespace umbrage {

enum ExitCode {
    kOk = 0,
    kFramesFailed = 1,  // finished, but frames failed or differ
    kUsage = 2,
    kBadInput = 3,
    kNoDevice = 4,
    kOutputFailed = 5,
    kInterrupted = 130,  // 128 + SIGINT; SIGTERM gives 143
    kTerminated = 143,
};

inline ExitCode exitCodeOf(ErrorKind kind) {
    switch (kind) {
        case ErrorKind::Usage:
            return kUsage;
        case ErrorKind::Input:
            return kBadInput;
        case ErrorKind::Device:
            return kNoDevice;
        default:
            return kOutputFailed;
    }
}

}  // namespace umbrage
