// SPDX-License-Identifier: Apache-2.0
// One tile of a picture by rays: what the tracer (tracer.h) spends its time in. Compiled once for each instruction set;
// plain arrays and Embree's C interface, so that the copies share no inline code.
#pragma once

#include <embree3/rtcore.h>

#include <cstdint>

#include "shading/lights_reach.h"

namespace umbrage {

inline constexpr int kTracerTile = 16;  // pixels a side

/// What a triangle is, beside its material's number in the low bits.
inline constexpr std::uint32_t kTracerFrontSeen = 1u << 31, kTracerBackSeen = 1u << 30, kTracerFlat = 1u << 29,
                               kTracerMaterial = kTracerFlat - 1;

/// Constant over its triangles, rounded as the G-buffer keeps it.
struct TracerMaterial {
    float baseColor[3] = {}, metallic = 0.0f, roughness = 1.0f;
    float emissive[3] = {};  // of an unlit one its colour
    float lit = 1.0f;        // 0: unlit
};

/// As gpu::LightData, in the tracer's space.
struct TracerLight {
    float position[3] = {}, w = 1.0f;               // w = 0: the direction to it
    float direction[3] = {}, inverseRange2 = 0.0f;  // the way a spot shines
    float color[3] = {}, intensity = 0.0f;          // candela or lux
    float coneScale = 0.0f, coneOffset = 1.0f;
};

struct TracerFrame {
    RTCScene scene = nullptr;
    const std::int32_t* vertices = nullptr;  // three a triangle
    const float* normals = nullptr;          // three a vertex
    const std::uint32_t* traits = nullptr;   // per triangle
    const TracerMaterial* materials = nullptr;
    const TracerLight* lights = nullptr;
    const LightsReach* reach = nullptr;  // one for each sixteen lights
    int lightCount = 0, width = 0, height = 0;
    bool shadows = true;
    float offset =
        0.0f;  // where shadow rays begin, in parts of the largest of the point's coordinates and its distance
    // Rays through the middle of pixel (x, y): origin + x originRight + y originDown, directions alike. Directions are
    // as long as one metre along the view axis is.
    float origin[3] = {}, originRight[3] = {}, originDown[3] = {};
    float direction[3] = {}, directionRight[3] = {}, directionDown[3] = {};
    float near = 0.0f, far = 0.0f;  // along the view axis
    float ambientSky[3] = {}, ambientGround[3] = {}, background[3] = {};
    float* radiance = nullptr;        // RGBA
    std::uint8_t* reaches = nullptr;  // may be null; light after light: 1 where it reaches the pixel
    std::uint32_t* seen = nullptr;    // with it: triangle, or RTC_INVALID_GEOMETRY_ID
};

/// Traces and shades the pixels of the tile whose upper left one is (left, top).
using TraceTile = void(const TracerFrame& frame, int left, int top);

TraceTile traceTileAvx512, traceTileAvx2, traceTileBaseline;

}  // namespace umbrage
