// SPDX-License-Identifier: Apache-2.0
// What is made on the host of a frame that is done: its samples one by one, each light's own picture, its split planes.
#pragma once

#include <span>
#include <vector>

#include "frame/frame.h"
#include "shading/host_resolve.h"
#include "shadow/split_parts.h"

namespace umbrage {

/// What is seen at every sample, and which lights reach it.
/// @param shining  lights that are on, as positions in the moment's list
void readSamples(const HostResolve::Input& frame, Resolve& resolve, const Eye& eye,
                 std::span<const std::size_t> shining, FramePixels& pixels);

/// The AOV `light` by what the picture was made by: highlights amplify how things are rounded, and these add up to it.
/// The planes are there and get their values.
void shadeLights(const HostResolve::Input& frame, HostResolve& resolve, std::span<const std::size_t> shining,
                 FramePixels& pixels);

/// The planes of the lights that shine.
/// @param pixels  with normals and depth
void drawSplitPlanes(const FrameSettings& settings, std::span<const LightParts> parts,
                     std::span<const ShadowLight> places, const Eye& eye, std::span<const std::size_t> shining,
                     FramePixels& pixels);

}  // namespace umbrage
