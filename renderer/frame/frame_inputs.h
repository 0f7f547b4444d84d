// SPDX-License-Identifier: Apache-2.0
// All that a renderer looks at when it renders a moment, as bytes: two moments with the same bytes are the same frame,
// bit for bit, by the same renderer.
#pragma once

#include <string>

#include "frame/frame.h"
#include "scene/scene.h"

namespace umbrage {

/// @param nodes  split planes go through points of nodes, so all transforms count, not only those of what is placed
std::string inputsOf(const Scene& scene, const PlacedMoment& placed, bool nodes);

}  // namespace umbrage
