// SPDX-License-Identifier: Apache-2.0
// Resolving on the processor, for devices that are one themselves: there, a shader that reads six textures and walks
// through a list of lights takes several times as long as the same in SIMD (shade_row.h).
#pragma once

#include <span>
#include <vector>

#include "shading/gbuffer.h"
#include "shading/resolve.h"
#include "shading/shade_row.h"

namespace umbrage {

class HostResolve {
public:
    struct Input {
        const GBuffer& gbuffer;  // of one sample a pixel
        const SeenSample& seen;  // read from it
        const Masks& masks;
        const Silhouettes& silhouettes;  // its hostFaces
        const gpu::ViewData& view;
        std::span<const gpu::LightData> lights;
        bool emissive = true;  // whether anything in the G-buffer is
    };
    /// What Resolve::shade() and readRadiance() give.
    std::vector<float> shade(const Input& input);

private:
    // Kept from frame to frame: fresh memory costs more than what is done with it.
    std::vector<std::uint32_t> baseColor_, normal_, properties_, emissive_;
    std::vector<std::vector<std::uint32_t>> dark_;
};

}  // namespace umbrage
