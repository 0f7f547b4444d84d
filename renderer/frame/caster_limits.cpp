// SPDX-License-Identifier: Apache-2.0
#include "frame/caster_limits.h"

#include <algorithm>
#include <array>

#include "shading/lights.h"
#include "shadow/bounds.h"
#include "shadow/extent.h"

namespace umbrage {

void CasterLimits::begin(const Geometry& geometry, const Eye& eye, const FrameSettings& settings) {
    modelBounds_ = geometry.modelBounds();
    boxes_ = worldBounds(geometry, modelBounds_);
    const std::array<HalfSpace, 4> sides = sidesOfView(eye);
    unseen_.assign(boxes_.size(), false);
    for (std::size_t i = 0; settings.skipOutOfView && i < boxes_.size(); ++i) {
        unseen_[i] = outOfView(cornersOf(boxes_[i]), sides);
    }
}

void CasterLimits::limitVolumes(const LightGroup& group, const Lights& lights, const Eye& eye,
                                const FrameSettings& settings, bool exactCounts, Silhouettes& silhouettes) const {
    for (gpu::CasterState& caster : silhouettes.hostCasters) {
        caster.outOfReach = caster.outOfView = 0;
        std::fill(std::begin(caster.ends), std::end(caster.ends), 0u);
    }
    silhouettes.extents.assign(group.count, {});
    if (exactCounts) return;
    std::vector<BoxCorners> corners;
    for (const Geometry::Bounds& box : boxes_) corners.push_back(cornersOf(box));
    const std::array<HalfSpace, 4> viewSides = sidesOfView(eye);
    for (std::uint32_t l = 0; l < group.count; ++l) {
        const PlacedLight& light = *lights.lights[group.first + l];
        const ShadowLight& place = lights.places[group.first + l];
        const LightReach reach = lightReach(light, place);
        const LightExtent extent(boxes_, reach, eye);
        const bool ends = lights.counts.endsVolumes(group.first + l, settings.endVolumes);
        silhouettes.extents[l] = extent.facesInView(eye);
        for (std::size_t i = 0; i < silhouettes.hostCasters.size(); ++i) {
            gpu::CasterState& caster = silhouettes.hostCasters[i];
            const bool beyond = settings.skipOutOfReach && outOfReach(boxes_[i], reach);
            const bool volumeUnseen = settings.skipOutOfView && outOfView(corners[i], place, viewSides);
            caster.outOfReach |= std::uint32_t(beyond) << l;
            caster.outOfView |= std::uint32_t(volumeUnseen) << l;
            if (!ends || beyond || volumeUnseen) continue;
            caster.ends[l / 10] |= extent.endOf(corners[i]) << (3 * (l % 10));
        }
    }
}

}  // namespace umbrage
