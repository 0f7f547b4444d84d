// SPDX-License-Identifier: Apache-2.0
// What a frame's casters are limited to by their boxes alone: which are not drawn, which cast nothing that a light's
// receivers or the viewer meet, and where the volumes of the others may end.
#pragma once

#include <span>
#include <vector>

#include "frame/frame.h"
#include "frame/light_counts.h"
#include "scene/moment.h"

namespace umbrage {

class CasterLimits {
public:
    /// @param geometry  as it is in this frame
    void begin(const Geometry& geometry, const Eye& eye, const FrameSettings& settings);

    /// Per instance, of this frame: in model space, and in the world.
    const std::vector<Geometry::Bounds>& modelBounds() const { return modelBounds_; }
    const std::vector<Geometry::Bounds>& boxes() const { return boxes_; }
    /// Per instance: its box is out of view.
    const std::vector<bool>& unseen() const { return unseen_; }

    struct Lights {
        std::span<const PlacedLight* const> lights;  // of the frame, those that shine
        std::span<const ShadowLight> places;
        const LightCounts& counts;
    };
    /// Which casters need no volumes of a group's lights, and where those of the others may end.
    /// @param exactCounts  counts matter, not only whether they are zero: no skip that changes them
    void limitVolumes(const LightGroup& group, const Lights& lights, const Eye& eye, const FrameSettings& settings,
                      bool exactCounts, Silhouettes& silhouettes) const;

private:
    std::vector<Geometry::Bounds> modelBounds_, boxes_;
    std::vector<bool> unseen_;
};

}  // namespace umbrage
