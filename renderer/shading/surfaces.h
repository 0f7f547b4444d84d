// SPDX-License-Identifier: Apache-2.0
// The visible primitives: which draws there are, in which state, in which order.
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "gpu/objects.h"
#include "gpu/program.h"
#include "gpu/state.h"
#include "scene/moment.h"
#include "shading/materials.h"
#include "shadow/geometry.h"

namespace umbrage {

class Surfaces {
public:
    Surfaces(const Scene& scene, const Geometry& geometry);

    /// Opaque and masked primitives into the G-buffer that is bound: the viewer sees front faces, and back faces of
    /// double-sided materials (docs/rules.md, G7).
    /// @param unseen  instances whose triangles are out of view, and left out
    void drawOpaque(const Geometry& geometry, const Materials& materials, const std::vector<bool>& unseen);

    /// The same primitives in the same order, by other programs into whatever is bound.
    struct OpaquePass {
        const gpu::Program *opaque = nullptr, *masked = nullptr;  // null: what the G-buffer needs
        const gpu::VertexArray* vertices = nullptr;               // null: their own
        gpu::RasterState state{};                                 // but for culling
        const std::vector<bool>* unseen = nullptr;                // instances whose triangles are left out
    };
    void drawOpaque(const Geometry& geometry, const Materials& materials, const OpaquePass& pass);

    /// For OpaquePass: their own, to which attributes from 7 on can be added.
    gpu::VertexArray makeVertexArray(const Geometry& geometry) const { return geometry.makeVertexArray(drawIds_); }

    /// Marks casters with a culled back face nearer than what is seen (T1) in CasterState::exposed; the finished depth
    /// buffer is bound.
    /// @param unseen  as drawOpaque()
    void findExposed(const Geometry& geometry, const Materials& materials, const std::vector<bool>& unseen,
                     const gpu::Buffer& casters);

    /// What casts, opaque and masked triangles from both sides, by the program and in the state that are set: position
    /// is attribute 0, the draw 6.
    /// @param leftOut  instances
    void drawCasters(const Geometry& geometry, const std::vector<bool>& leftOut) const;

    /// Whether anything shines by itself or is unlit.
    bool anyEmissive() const { return anyEmissive_; }
    bool anyBlended() const { return !blended_.empty(); }
    /// Back to front by the middle of each primitive's bounds; of double-sided ones the back faces first.
    /// @param worldBoxes  per instance; places those that deform
    void drawBlended(const Geometry& geometry, const Materials& materials, const Eye& eye,
                     std::span<const Geometry::Bounds> worldBoxes);

    /// Per instance: it has alpha-masked triangles.
    const std::vector<bool>& holed() const { return holed_; }

private:
    struct Draw {
        std::uint32_t id = 0;  // in the draw buffer
        std::uint32_t instance = 0, material = 0;
        std::uint32_t firstIndex = 0, indexCount = 0;
        GLenum mode = GL_TRIANGLES;
        glm::dvec3 center{0.0};  // of the primitive's bounds, in model space
    };
    void submit(const Draw& draw, const Geometry& geometry) const;
    bool frontIsClockwise(const Draw& draw, const Geometry& geometry) const;

    std::vector<Draw> opaque_;  // sorted by material
    std::vector<Draw> blended_;
    std::vector<bool> holed_;
    bool anyEmissive_ = false;
    gpu::Buffer drawBuffer_, drawIds_;
    gpu::VertexArray vertexArray_;
    const gpu::Program& gbufferProgram(std::uint32_t textures, bool masked);

    // One for each set of textures that a material has: llvmpipe runs both ways of a branch, so a texture that is not
    // there would be read all the same, and the G-buffer would take twice as long.
    std::map<std::pair<std::uint32_t, bool>, gpu::Program> gbufferPrograms_;
    gpu::Program exposureProgram_{"surface.vert", "exposure.frag"};
    gpu::Program blendedProgram_{"surface.vert", "blended.frag"};
};

}  // namespace umbrage
