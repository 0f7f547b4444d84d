// SPDX-License-Identifier: Apache-2.0
// Lights of a moment for shading (view space) and for shadows (world space, homogeneous).
#pragma once

#include <vector>

#include "gpu/objects.h"
#include "scene/moment.h"
#include "shaders/shared.h"
#include "shadow/bounds.h"
#include "shadow/eye.h"

namespace umbrage {

/// Whether the light reaches anything: off lights are skipped, which cannot change a pixel.
bool isOn(const Light& light);

gpu::LightData lightData(const PlacedLight& placed, const Eye& eye);
ShadowLight shadowLight(const PlacedLight& placed);
/// @param light  as shadowLight() gives it
LightReach lightReach(const PlacedLight& placed, const ShadowLight& light);

/// Directional and, up to float rounding, along the view of an orthographic eye (T5).
bool parallelToView(const PlacedLight& placed, const Eye& eye);

}  // namespace umbrage
