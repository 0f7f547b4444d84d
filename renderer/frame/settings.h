// SPDX-License-Identifier: Apache-2.0
// What a job says about frames: how each is rendered, which there are, and when.
#pragma once

#include <string>

#include "frame/frame.h"
#include "job/job.h"
#include "scene/compose.h"

namespace umbrage {

/// Names of shadow techniques, as in the sequence file.
struct ShadowTechniques {
    std::string silhouette, count;
};

/// The job's, with `auto` resolved.
ShadowTechniques techniquesOf(const Job& job);

FrameSettings settingsOf(const Job& job, const Composition& composition);

/// The job's frames. Those of a bare scene's animation begin at frame 1, and the last one is at its last key or the
/// first after it.
FrameRange framesOf(const Job& job, const Composition& composition);

/// When a frame is, in seconds of the scene.
double frameSeconds(const Job& job, int frame);

}  // namespace umbrage
