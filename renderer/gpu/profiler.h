// SPDX-License-Identifier: Apache-2.0
// How long passes take. Off unless asked for, because on a software device the only honest clock is the wall's between
// two glFinish calls, which forbids overlap (T15: timer queries lie there); on a GPU timer queries are read at the end.
#pragma once

#include <epoxy/gl.h>

#include <chrono>
#include <map>
#include <vector>

namespace umbrage::gpu {

class Profiler {
public:
    Profiler(bool enabled, bool softwareDevice) : enabled_(enabled), wallClock_(softwareDevice) {}
    ~Profiler();
    Profiler(const Profiler&) = delete;
    Profiler& operator=(const Profiler&) = delete;

    static constexpr int kNoPass = -1;
    /// Ends the running pass, if any, and begins one; kNoPass only ends. A pass may recur: times add up.
    void pass(int id);

    /// Milliseconds per pass since the last call. Waits for the device.
    std::map<int, double> collect();

private:
    struct Running {
        int id = kNoPass;
        std::chrono::steady_clock::time_point start;
    } running_;
    struct Pending {
        int id;
        GLuint begin, end;
    };
    std::vector<Pending> pending_;
    std::map<int, double> milliseconds_;
    bool enabled_, wallClock_;
};

}  // namespace umbrage::gpu
