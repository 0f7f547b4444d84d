// SPDX-License-Identifier: Apache-2.0
// What the G-buffer does not hold: opaque surfaces drawn again in the same order, against a depth buffer of their own,
// so that the same ones are seen. Only when somebody asked.
#pragma once

#include <cstdint>
#include <vector>

#include "gpu/screen_target.h"
#include "shading/surfaces.h"

namespace umbrage {

/// How often opaque surfaces touch each pixel; with several samples their mean.
struct SceneFragments {
    std::vector<float> fragments;  // whatever is in front of them; alpha-tested ones where they are
    std::vector<float> shaded;     // those that passed the depth test, in the order they are drawn
    std::uint64_t fragmentSamples = 0, shadedSamples = 0;  // of all pixels, exactly (T16)
    std::uint64_t coveredPixels = 0;                       // with at least one
    std::vector<std::uint32_t> samplesOfMaterials;  // fragmentSamples by material; the last one is glTF's default
};

/// Where everything was in the frame before.
struct PreviousFrame {
    gpu::Buffer positions;      // as Geometry::positions(); empty: they are the same
    gpu::Buffer viewFromModel;  // three rows an instance
    glm::vec2 rayScale{1.0f};   // of its eye
};

class SurfacesAgain {
public:
    /// @param depthStencil  of the G-buffer: size and samples
    explicit SurfacesAgain(const gpu::Texture& depthStencil);

    /// @param emptyDepth  as in GBuffer::begin()
    SceneFragments countFragments(Surfaces& surfaces, const Geometry& geometry, const Materials& materials,
                                  float emptyDepth);

    /// Object (instance), material and triangle, from 1 on: three values a pixel, 0 where nothing is; first sample.
    std::vector<std::uint32_t> readIds(Surfaces& surfaces, const Geometry& geometry, const Materials& materials,
                                       float emptyDepth);

    /// From where the surface point was in the frame before to where it is: pixels to the right and down, two values a
    /// pixel; first sample.
    std::vector<float> readMotion(Surfaces& surfaces, const Geometry& geometry, const Materials& materials,
                                  float emptyDepth, const PreviousFrame& previous);

private:
    struct Programs {
        explicit Programs(const char* what);
        gpu::Program opaque, masked;
    };
    void begin(const gpu::ScreenTarget& target, float emptyDepth) const;

    gpu::Texture depth_;
    gpu::Buffer ofMaterials_;
    gpu::ScreenTarget tally_, ids_, motion_;  // on first use
    Programs tallyPrograms_{"TALLY"}, idPrograms_{"IDS"}, motionPrograms_{"MOTION"};
};

}  // namespace umbrage
