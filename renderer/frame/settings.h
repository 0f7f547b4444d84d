// SPDX-License-Identifier: Apache-2.0
// What a job says about frames: how each is rendered, which there are, and when.
#pragma once

#include <string>
#include <vector>

#include "frame/frame.h"
#include "job/job.h"
#include "scene/compose.h"

namespace umbrage {

/// A silhouette and a count technique by their names in the sequence file; together written silhouette:count.
struct Technique {
    std::string silhouette, count;

    std::string name() const { return silhouette + ":" + count; }
    /// @param name  as name() gives it
    static Technique named(const std::string& name) {
        return {name.substr(0, name.find(':')), name.substr(name.find(':') + 1)};
    }
};

/// Those of techniqueNames().
std::vector<Technique> allTechniques();

/// The job with the fastest exact technique on a device where it says `auto`. Figures and pictures of what shadow
/// volumes cost a rasteriser are about one that has one.
Job chosenFor(Job job, const gpu::DeviceInfo& device, const FrameOutputs& outputs = {});

/// The job's; where it still says `auto`, what every device can.
Technique techniqueOf(const Job& job);

/// What the overlay `techniques` compares it with: the job's choice, or the same silhouettes counted the other way.
Technique techniqueAgainst(const Job& job);

void choose(const Technique& technique, FrameSettings& settings);

FrameSettings settingsOf(const Job& job, const Composition& composition);

/// The job's frames. Those of a bare scene's animation begin at frame 1, and the last one is at its last key or the
/// first after it.
FrameRange framesOf(const Job& job, const Composition& composition);

/// When a frame is, in seconds of the scene.
double frameSeconds(const Job& job, int frame);

/// The scene then, and the camera in it.
PlacedMoment placedMoment(const Job& job, const Composition& composition, int frame);

}  // namespace umbrage
