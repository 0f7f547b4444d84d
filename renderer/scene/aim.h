// SPDX-License-Identifier: Apache-2.0
// Lights and cameras of the sequence's own stand at a position and look at a target, each of them constant or sampled.
// Position is interpolated as the samples say; the rotation is right at the times of all samples of either, and on the
// sphere between those.
#pragma once

#include <string>

#include "job/job.h"
#include "scene/scene.h"

namespace umbrage {

/// Values of a sampled quantity of the sequence file as a track.
template <int N>
Track trackOf(const Sampled<N>& sampled, KeyInterpolation interpolation) {
    Track track;
    track.width = N;
    track.interpolation = interpolation == KeyInterpolation::Step ? Interpolation::Step : Interpolation::Linear;
    for (const double time : sampled.timesSeconds) track.timesSeconds.push_back(static_cast<float>(time));
    for (const auto& value : sampled.values)
        for (const double component : value) track.values.push_back(static_cast<float>(component));
    return track;
}

/// The rotation that turns -Z to `direction` (not zero) and keeps +Y up; straight up or down, -Z or +Z is up or down.
glm::dquat lookRotation(const glm::dvec3& direction);

/// Places the node: constants in its own transform, samples as a driver of the scene. Without `target` it only moves.
/// @throws Error(Input) at the target's place where both are the same point
void aim(Scene& scene, Index node, const Sampled<3>& position, const Sampled<3>* target,
         KeyInterpolation interpolation);

}  // namespace umbrage
