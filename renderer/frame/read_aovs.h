// SPDX-License-Identifier: Apache-2.0
// The AOVs of a frame: which pass makes each, and where its pixels go. What a pass needs is made on its first use.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "frame/frame.h"
#include "gpu/screen_target.h"
#include "shading/resolve.h"
#include "shading/surfaces.h"
#include "shadow/counts.h"

namespace umbrage {

class AovReader {
public:
    /// All must outlive it.
    AovReader(const Scene& scene, Geometry& geometry, const Materials& materials, Surfaces& surfaces,
              const GBuffer& gbuffer, Resolve& resolve);

    /// For motion: keeps positions and matrices of the frame before. The geometry must be updated for `eye` next.
    void placeBefore(const PlacedMoment& before, const Eye& eye);

    /// Where silhouette edges of light `l` of the group that was swept last are seen.
    std::vector<float> readSilhouette(const Silhouettes& silhouettes, const LightGroup& group, std::uint32_t l);

    /// All others, after shading.
    /// @param shining  lights that are on, as positions in the moment's list; the others' planes are 0
    void read(const FrameOutputs& outputs, const Masks& masks, const Silhouettes& silhouettes, const Eye& eye,
              std::span<const std::size_t> shining, FramePixels& pixels);

private:
    std::vector<float> readLines(const gpu::Program& program, const Silhouettes& silhouettes);
    void readAgain(const FrameOutputs& outputs, float emptyDepth, FramePixels& pixels);

    const Scene& scene_;
    Geometry& geometry_;
    const Materials& materials_;
    Surfaces& surfaces_;
    const GBuffer& gbuffer_;
    Resolve& resolve_;
    PreviousFrame previous_;
    std::unique_ptr<SurfacesAgain> again_;
    gpu::ScreenTarget lines_;
    gpu::Program silhouetteProgram_, contourProgram_;
    gpu::VertexArray noVertices_{"silhouette edges"};
};

}  // namespace umbrage
