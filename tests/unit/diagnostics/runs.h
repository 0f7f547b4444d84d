// SPDX-License-Identifier: Apache-2.0
// A run's numbers with every kind of place, for tests.
#pragma once

#include "diagnostics/statistics.h"

namespace umbrage {

inline Distribution distributionOf(std::initializer_list<double> values) {
    Distribution distribution;
    for (const double value : values) distribution.add(value);
    return distribution;
}

/// Frames 1 and 2 of a scene with the lights Lamp and Sun and the casters /Box and /Tree.
inline Statistics twoFrames() {
    Statistics s;
    for (const int frame : {1, 2}) {
        s.record(frame, {}, "triangles", 10144);
        s.record(frame, {}, "time.frame", 12.25 * frame);
        s.record(frame, {}, "scene.shaded", 150 * frame);
        s.record(frame, {}, "scene.covered", 100);
        s.record(frame, {}, "scene.overdraw", 1.5 * frame);
        s.record(frame, {}, "overdraw", distributionOf({0, 1, 1, 2.5 * frame}));
        s.record(frame, {.light = "Lamp"}, "edges.silhouette", 319 + frame);
        s.record(frame, {.light = "Lamp"}, "stencil", distributionOf({0, 0, 1}));
        s.record(frame, {.light = "Lamp", .caster = "/Box"}, "overdraw.fragments", 10);
        s.record(frame, {.light = "Lamp", .caster = "/Tree"}, "overdraw.fragments", 1000 * frame);
        s.record(frame, {.light = "Sun", .caster = "/Box"}, "overdraw.fragments", 5);
        s.record(frame, {.material = "bark"}, "scene.shaded", 50);
    }
    return s;
}

inline StatisticsFile twoFramesFile() {
    return twoFrames().file({{"sequence", "courtyard.yaml"},
                             {"version", "0.1.0"},
                             {"device", "llvmpipe"},
                             {"clock", "wall clock between glFinish calls"}});
}

}  // namespace umbrage
