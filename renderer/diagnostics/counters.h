// SPDX-License-Identifier: Apache-2.0
// The registry of counters: what a frame reports about itself. A new counter is one line here; CSV, JSON and whoever
// documents them read this table.
#pragma once

#include <array>
#include <cstddef>
#include <stdexcept>
#include <string_view>

namespace umbrage {

struct CounterInfo {
    std::string_view name, unit, doc;
};

// clang-format off
inline constexpr std::array kCounters{
    CounterInfo{"triangles", "count", "triangles of the shadow casters"},
    CounterInfo{"triangles.facing", "count", "triangles whose front the light sees"},
    CounterInfo{"edges", "count", "welded edges of the shadow casters"},
    CounterInfo{"edges.silhouette", "count", "edges that become sides of a shadow volume"},
    CounterInfo{"quads", "count", "sides of shadow volumes that are drawn, multiplicities included"},
    CounterInfo{"overdraw.fragments", "count", "fragments of shadow volumes (one for each sample), before the depth test"},
    CounterInfo{"overdraw.updates", "count", "stencil updates: fragments of shadow volumes that count"},
    CounterInfo{"eye.constant", "count", "shadow volumes that hold the eye"},
    CounterInfo{"casters.zfail", "count", "casters counted by z-fail because the eye is near their volumes"},
    CounterInfo{"casters.outOfReach", "count", "casters skipped because the light's range ends before them"},
    CounterInfo{"lights.skipped", "count", "lights that provably change no pixel of the frame"},
    CounterInfo{"time.position", "ms", "skinning, morphing and displacement of positions"},
    CounterInfo{"time.gbuffer", "ms", "depth and surface attributes"},
    CounterInfo{"time.silhouettes", "ms", "facing and edge lists"},
    CounterInfo{"time.counts", "ms", "shadow volumes into counts, counts into the lights' mask bits"},
    CounterInfo{"time.resolve", "ms", "lighting of all lights"},
    CounterInfo{"time.blended", "ms", "blended surfaces"},
    CounterInfo{"time.readback", "ms", "pixels from the device to the host"},
    CounterInfo{"time.encode", "ms", "display colour, encoding and writing of files"},
    CounterInfo{"time.frame", "ms", "the whole frame"},
    CounterInfo{"memory.peak", "MiB", "largest resident memory of the process so far"},
};
// clang-format on

/// A counter's place in kCounters, found by name while compiling: a misspelt name does not compile.
class Counter {
public:
    template <std::size_t N>
    consteval Counter(const char (&name)[N]) : index_(find({name, N - 1})) {}

    /// The counter at a place of kCounters.
    static constexpr Counter at(std::size_t index) { return Counter(index, Placed{}); }

    constexpr std::size_t index() const { return index_; }
    constexpr const CounterInfo& info() const { return kCounters[index_]; }

private:
    struct Placed {};
    constexpr Counter(std::size_t index, Placed) : index_(index) {}

    static consteval std::size_t find(std::string_view name) {
        for (std::size_t i = 0; i < kCounters.size(); ++i) {
            if (kCounters[i].name == name) return i;
        }
        throw std::invalid_argument("no such counter");
    }

    std::size_t index_;
};

}  // namespace umbrage
