// SPDX-License-Identifier: Apache-2.0
// What somebody asked about a frame's shadow volumes beside the masks: what they fill, whose they are, what they look
// like. Draws them again, so that the frame itself runs no counting pass.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "frame/frame.h"
#include "frame/record.h"
#include "shading/gbuffer.h"
#include "shadow/fill.h"
#include "shadow/hulls.h"

namespace umbrage {

/// What a light is drawn in. @param place  in the moment's list
glm::vec3 colorOfLight(std::size_t place);

class VolumeDiagnostics {
public:
    /// All must outlive it.
    VolumeDiagnostics(const GBuffer& gbuffer, const Geometry& geometry, const Silhouettes& silhouettes,
                      VolumeRenderer& volumes)
        : gbuffer_(gbuffer), geometry_(geometry), silhouettes_(silhouettes), volumes_(volumes) {}

    static bool wanted(const FrameOutputs& outputs);

    void begin(const FrameOutputs& outputs, FramePixels& pixels);

    /// Light `l` of the group that was swept last, once its counts are done.
    /// @param place  of the light in the moment's list: its colour
    void light(std::vector<CountPlan> plans, const LightGroup& group, std::uint32_t l, std::size_t place, bool halve,
               LightPlanes& planes, FrameRecorder& recorder);

    /// After the last light of a group.
    void endGroup(const LightGroup& group);

    void finish(const Scene& scene, const Moment& moment);

private:
    void measure(std::span<const CountPlan> plans, const LightGroup& group, std::uint32_t l, bool halve,
                 LightPlanes& planes, FrameRecorder& recorder);

    const GBuffer& gbuffer_;
    const Geometry& geometry_;
    const Silhouettes& silhouettes_;
    VolumeRenderer& volumes_;
    std::unique_ptr<FillMeter> meter_;  // these two on first use
    std::unique_ptr<VolumeHulls> hulls_;

    // Of the frame, then of the group.
    const FrameOutputs* outputs_ = nullptr;
    FramePixels* pixels_ = nullptr;
    std::vector<double> fragmentsOfCasters_;
    CasterPlanes casterPlanes_;
    std::vector<std::vector<CountPlan>> plans_;  // of each light, where casters are told apart
    std::vector<double> fragmentsInGroup_;
};

}  // namespace umbrage
