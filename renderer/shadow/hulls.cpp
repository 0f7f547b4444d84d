// SPDX-License-Identifier: Apache-2.0
#include "shadow/hulls.h"

namespace umbrage {

void VolumeHulls::draw(std::span<const CountPlan> plans, const glm::vec3& color, VolumeRenderer& renderer,
                       const Geometry& geometry, const Silhouettes& silhouettes, const LightGroup& group,
                       std::uint32_t l) const {
    constexpr float kLineWeight = 4.0f;  // of a border, in faces
    target_.framebuffer().bind();
    for (const auto& [into, weight] :
         {std::pair{VolumeRenderer::Into::Faces, 1.0f}, std::pair{VolumeRenderer::Into::Lines, kLineWeight}}) {
        renderer.setHullColor(weight * glm::vec4(color, 1.0f));
        for (const CountPlan& plan : plans) {
            for (const VolumePart& part : plan.parts) renderer.draw(part, into, geometry, silhouettes, group, l);
        }
    }
}

}  // namespace umbrage
