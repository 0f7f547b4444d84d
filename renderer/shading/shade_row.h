// SPDX-License-Identifier: Apache-2.0
// The inner loop of resolving on the processor: a row of pixels, from what the G-buffer and the masks hold to radiance.
// The same source is compiled for several instruction sets (shade_row.inl).
#pragma once

#include <cstdint>

#include "shaders/shared.h"
#include "shading/lights_reach.h"

namespace umbrage {

struct ShadeRow {
    int y = 0, width = 0;
    const gpu::ViewData* view = nullptr;
    const gpu::LightData* lights = nullptr;
    const LightsReach* reach = nullptr;  // one for each sixteen lights
    // Of the row: as the G-buffer's textures hold them, see shading/gbuffer.h. Padded to whole sixteens.
    const std::uint32_t* triangles = nullptr;
    const float* depths = nullptr;
    const std::uint32_t *baseColor = nullptr, *normal = nullptr, *properties = nullptr;
    const std::uint32_t* emissive = nullptr;  // null: all zero
    // Of the group of 32 lights g: dark[g] of the row; facing[g] per triangle, front and back.
    const std::uint32_t* const* dark = nullptr;
    const std::uint32_t* const* facing = nullptr;
    const float* planes = nullptr;  // four values a triangle
    float* radiance = nullptr;      // RGBA, of the row
};

/// shaders/resolve.frag.glsl, for one row.
using ShadeRowFunction = void(const ShadeRow& row);
ShadeRowFunction shadeRowAvx512, shadeRowAvx2, shadeRowBaseline;

}  // namespace umbrage
