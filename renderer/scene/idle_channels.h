// SPDX-License-Identifier: Apache-2.0
// Animation channels that move nothing: those that hold one value, and those of nodes under which there is nothing that
// is seen, casts, shines or sees.
#pragma once

#include <cstddef>
#include <span>

#include "scene/scene.h"

namespace umbrage {

/// Takes them out of what plays; nodes get the one value. What evaluate() says of instances, lights and the camera
/// stays the same bit for bit; the transforms of other nodes do not.
/// @param playing  animations; drivers always do
/// @return how many there were
std::size_t dropIdleChannels(Scene& scene, std::span<const Index> playing, Index cameraNode);

}  // namespace umbrage
