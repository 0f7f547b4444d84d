// SPDX-License-Identifier: Apache-2.0
// One scene put into another.
#pragma once

#include "scene/scene.h"

namespace umbrage {

/// Moves everything a loader makes from `layer` into `scene`; roots become children of `parent` (kNone: roots). Paths
/// get the parent's in front, and an index where they are taken.
void appendScene(Scene& scene, Scene layer, Index parent);

}  // namespace umbrage
