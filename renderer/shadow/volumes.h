// SPDX-License-Identifier: Apache-2.0
// Shadow volumes drawn: their sides and caps, part by part, into whatever is bound.
#pragma once

#include <vector>

#include "gpu/objects.h"
#include "gpu/program.h"
#include "gpu/state.h"
#include "shadow/silhouette.h"

namespace umbrage {

/// A part of a light's volumes that is drawn with one rule.
struct VolumePart {
    enum class Kind { Sides, Cap };
    enum class Rule {
        Pass,   // +1 front, -1 back where nearer than what is seen
        Fail,   // -1 front, +1 back where not nearer
        Split,  // of each part of the casters one of both, pixel by pixel: into counters, not into the stencil buffer
    };
    enum class Start {
        Eye,  // view rays begin at the eye itself
        NearPlane,
        CapPlane,  // at the plane in the middle of the ledge, by which everything is cut (shadow/ledge.h)
    };
    Kind kind = Kind::Sides;
    Rule rule = Rule::Pass;
    Start start = Start::Eye;
    std::uint32_t what = LIST_HALVED;      // LIST_... (+ LIST_EDGE_ON) or CAP_...
    std::vector<std::uint32_t> instances;  // caps: those that need it, ascending
    int crossings = 1;                     // that a fragment stands for
    float endMetres = 0.0f;                // where volumes end that no face of the light's extent ends; 0: nowhere
    bool inverts = false;                  // every crossing inverts the count's bits, of which only parity is left
};

/// Draws parts of volumes into whatever framebuffer is bound.
class VolumeRenderer {
public:
    /// @param samples  of what is drawn into
    /// @param technique  that draws the sides; must outlive it
    VolumeRenderer(int samples, SilhouetteTechnique& technique);

    enum class Into {
        Stencil,  // crossings, signed, into the stencil buffer (modulo 256)
        Counter,  // the same into a float colour buffer by additive blending (T6)
        Fill,     // fragments and count changes at each pixel, see shadow/fill.h
        Tally,    // the same, and for each caster
        Casters,  // fragments of some casters, see shadow/fill.h
        Faces,    // for pictures, where they are before what is seen, see shadow/hulls.h
        Lines,    // the same, only their borders
    };
    /// @param color  that each fragment of Faces and Lines adds
    void setHullColor(const glm::vec4& color) { hullColor_ = color; }
    void draw(const VolumePart& part, Into into, const Geometry& geometry, const Silhouettes& silhouettes,
              const LightGroup& group, std::uint32_t l);

private:
    struct Programs {
        gpu::Program stencil, counter, fill, tally, casters, hull;
        gpu::Program splitCounter, splitFill, splitTally;
        const gpu::Program& of(Into into, VolumePart::Rule rule) const;
    };
    static Programs programs(const SideShaders& shaders, bool edgeOn, int samples);
    const Programs& programsOf(const VolumePart& part) const;
    void drawBy(VolumePart::Rule rule, const VolumePart& part, Into into, const Geometry& geometry,
                const Silhouettes& silhouettes, const LightGroup& group, std::uint32_t l);
    void drawCutSides(const VolumePart& part, const gpu::Program& program, const Silhouettes& silhouettes,
                      std::uint32_t l);
    void drawCap(const VolumePart& part, const gpu::Program& program, gpu::RasterState state, const Geometry& geometry,
                 const Silhouettes& silhouettes, const LightGroup& group, std::uint32_t l);

    SilhouetteTechnique& technique_;
    Programs sides_, edgeOnSides_, caps_, edgeOnCaps_;
    Programs cutSides_, edgeOnCutSides_, cutCaps_, edgeOnCutCaps_, lightViews_;
    gpu::VertexArray noVertices_{"caps of volumes"};
    glm::vec4 hullColor_{1.0f};
};

}  // namespace umbrage
