// SPDX-License-Identifier: Apache-2.0
// The wall's clock.
#pragma once

#include <chrono>

namespace umbrage {

class Stopwatch {
public:
    /// Since it was made.
    double milliseconds() const { return std::chrono::duration<double, std::milli>(Clock::now() - start_).count(); }

private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point start_ = Clock::now();
};

}  // namespace umbrage
