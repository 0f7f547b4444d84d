// SPDX-License-Identifier: Apache-2.0
// From what a frame's passes found to its statistics: per light, per caster of a light, per caster, and in all.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "diagnostics/statistics.h"
#include "gpu/activity.h"
#include "scene/moment.h"
#include "shading/again.h"
#include "shadow/fill.h"

namespace umbrage {

/// Fragments of shadow volumes, samples, of whatever part of them was added up.
struct FillSums {
    double sides = 0, lightCaps = 0, darkCaps = 0, passed = 0, failed = 0, entered = 0, left = 0;
    double net = 0;  // entered - left, in volumes: halved sides stand for two

    /// @param byFail  counted by z-fail
    /// @param halve  LIST_HALVED was halved
    void add(const gpu::CasterFill& fill, bool byFail, bool halve);
    void add(const FillSums& other);
    double fragments() const { return sides + lightCaps + darkCaps; }
    double updates() const { return entered + left; }
};

/// What the device was asked for since `begin`, of a frame.
void recordActivity(int frame, const gpu::Activity& begin, Statistics& statistics);

/// Records one frame.
class FrameRecorder {
public:
    struct Picture {
        int width = 0, height = 0, samples = 1;
    };
    FrameRecorder(const Scene& scene, const Moment& moment, const Geometry& geometry, const Picture& picture, int frame,
                  Statistics& statistics);

    /// Light `l` of the group that was swept last. Adds its planes to those of the frame.
    /// @param startLayers  volumes that hold every sample's start and that no part counts; unset: a plan was decided
    ///                     without drawing, so fill does not say all about counts
    /// @param stencil  its counts at every pixel; empty: not read
    void light(const std::string& id, std::uint32_t l, const Silhouettes& silhouettes, bool halve,
               const VolumeFill& fill, std::optional<int> startLayers, const std::vector<std::uint32_t>& stencil);

    /// How often opaque surfaces touch pixels.
    void scene(const SceneFragments& fragments);

    /// After the last light.
    void finish(std::size_t lightsSkipped, std::size_t lightsFellBack);

private:
    void record(const StatisticsPlace& place, const FillSums& sums) const;
    void recordPixels(const StatisticsPlace& place, const std::vector<float>& fragments,
                      const std::vector<float>& updates) const;

    const Scene& scene_;
    const Moment& moment_;
    const Geometry& geometry_;
    Picture picture_;
    int frame_;
    Statistics& statistics_;
    std::vector<FillSums> casters_;           // over the lights
    std::vector<float> fragments_, updates_;  // over the lights; empty: there was none
    gpu::Activity begin_ = gpu::activity();
};

}  // namespace umbrage
