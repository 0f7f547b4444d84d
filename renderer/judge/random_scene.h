// SPDX-License-Identifier: Apache-2.0
// Scenes nobody would make: random soups of triangles, closed pieces among them, random lights of all kinds and random
// eyes. Half of them have all coordinates snapped to a coarse grid, so that edges meet sample positions, lights lie in
// planes and on vertices, and faces coincide.
#pragma once

#include <cstdint>

#include "scene/moment.h"

namespace umbrage {

struct RandomScene {
    Scene scene;
    PlacedCamera camera;
    int width = 64, height = 64;
    std::string description;  // what it drew, for people
};

/// The same scene for the same seed on every machine.
RandomScene randomScene(std::uint64_t seed);

}  // namespace umbrage
