// SPDX-License-Identifier: Apache-2.0
// Shadow volumes made visible (Brabec & Seidel 2003, figure 5; Kilgard 2001): translucent faces and their edges as
// lines, as far as they lie before what is seen.
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "gpu/screen_target.h"
#include "shadow/counts.h"

namespace umbrage {

class VolumeHulls {
public:
    /// @param depthStencil  holds the depth of what is seen
    explicit VolumeHulls(const gpu::Texture& depthStencil)
        : target_("hulls of volumes", GL_RGBA32F, depthStencil.size(), &depthStencil) {}

    void clear() const { target_.clear(); }
    void draw(std::span<const CountPlan> plans, const glm::vec3& color, VolumeRenderer& renderer,
              const Geometry& geometry, const Silhouettes& silhouettes, const LightGroup& group, std::uint32_t l) const;

    /// RGBA: colours, each as often as a face of its light's volumes is seen and more often where one has a border, and
    /// how many they are. Rows from the top. Waits.
    std::vector<float> read() const { return target_.readMean(4); }

private:
    gpu::ScreenTarget target_;
};

}  // namespace umbrage
