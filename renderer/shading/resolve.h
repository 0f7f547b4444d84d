// SPDX-License-Identifier: Apache-2.0
// From G-buffer and masks to radiance, and to the data AOVs.
#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "gpu/program.h"
#include "gpu/screen_target.h"
#include "shading/gbuffer.h"
#include "shadow/masks.h"
#include "shadow/silhouette.h"

namespace umbrage {

struct SeenSample {
    std::vector<std::uint32_t> triangles;
    std::vector<float> depths;
};

class Resolve {
public:
    explicit Resolve(const GBuffer& gbuffer);

    /// Lights everything in one pass over the image and leaves the target bound, with the scene's depth, for blended
    /// surfaces to be drawn over it.
    void shade(const GBuffer& gbuffer, const Masks& masks, const Silhouettes& silhouettes);

    /// Rows from the top, linear Rec.709 RGBA; samples averaged. Waits for the device.
    std::vector<float> readRadiance();

    /// What data.frag.glsl makes of the G-buffer.
    struct Data {
        std::string_view name;  // of the AOV; or normalAndDepth: world-space shading normal and distance along the view
                                // axis; or shadow: the masks of four lights (docs/rules.md, G7)
        int components = 4;
        bool firstSample = true;  // else the mean
        std::uint32_t firstLight = 0;
    };
    std::vector<float> readData(const Data& data, const GBuffer& gbuffer, const Masks& masks,
                                const Silhouettes& silhouettes, const glm::mat4& worldFromView);

    /// Of one sample of every pixel: the placed triangle that is seen (NO_TRIANGLE: none), and bits of the group's
    /// lights that reach it (docs/rules.md, G7).
    /// @param position  of the sample in its pixel
    std::vector<gpu::uvec2> readSample(const GBuffer& gbuffer, const Masks& masks, const Silhouettes& silhouettes,
                                       int sample, const glm::vec2& position, std::uint32_t group);

    /// Triangle (NO_TRIANGLE: none) and depth of one sample of every pixel, rows from the top.
    void readSeen(const GBuffer& gbuffer, const Masks& masks, const Silhouettes& silhouettes, int sample,
                  const glm::vec2& position, SeenSample& seen);

private:
    void drawSample(const gpu::Program& program, const GBuffer& gbuffer, const Masks& masks,
                    const Silhouettes& silhouettes, int sample, const glm::vec2& position);
    void drawFullScreen(const gpu::Program& program, const gpu::Framebuffer& target, const GBuffer& gbuffer,
                        const Masks& masks, const Silhouettes& silhouettes);

    glm::vec2 firstSample_{0.5f};  // its place in the pixel
    gpu::ScreenTarget target_;
    gpu::Framebuffer targetWithDepth_;
    gpu::ScreenTarget sample_;  // on first use
    gpu::Program shade_, sampleData_, seen_;
    std::map<std::string, gpu::Program, std::less<>> data_;  // by name, on first use
    gpu::VertexArray noVertices_{"full screen"};
};

}  // namespace umbrage
