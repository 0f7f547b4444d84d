// SPDX-License-Identifier: Apache-2.0
// From lists of side quads to counts: which parts of a light's volumes are drawn, by which rule, and what the count is
// where nothing is in shadow.
//
// Counts are sums over casters (docs/rules.md, G1) and never negative, so a sample is lit exactly if the count of
// every group of casters is zero there. Two groups are counted apart:
//  - halved: components whose edges all have even valence, counted by z-pass without caps. Every crossing of their
//    volumes' sides counts two, so one quad is drawn for two, and the count is compared with half the eye constant; an
//    odd eye constant can never be undone by sides, so then everything is dark. Half the fill of two-sided weights,
//    valid for any winding and any position of the light, where one-sided weights need a proof (T3).
//  - whole: all other casters, and those that need caps or z-fail (T1, T4), with full multiplicities.
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
        Pass,  // +1 front, -1 back where nearer than what is seen
        Fail,  // -1 front, +1 back where not nearer
    };
    Kind kind = Kind::Sides;
    Rule rule = Rule::Pass;
    std::uint32_t what = LIST_HALVED;      // LIST_... (+ LIST_EDGE_ON) or CAP_...
    std::vector<std::uint32_t> instances;  // caps: those that need it, ascending
};

/// What one count needs: its parts, and what the counter holds where nothing is in shadow.
struct CountPlan {
    std::vector<VolumePart> parts;
    int litValue = 0;
    bool allDark = false;          // the eye constant alone decides
    bool wide = false;             // counts may exceed what 8 bits hold (T6)
    std::uint32_t layerBound = 0;  // no count is larger
};

/// What plans depend on beside the silhouettes.
struct CountSettings {
    bool eyeConstant = true;  // off: textbook z-pass, wrong with the eye in a volume
    bool halve = true;        // as in SweepOptions
    bool perspective = true;
    std::vector<bool> holed;  // per instance: has alpha-masked triangles
};

/// The halved and the whole count of light `l` of the group, as far as there is something to count.
/// @param layerBound  no more layers than these lie between the light and any point
/// @param parallelToView  the light is directional, along an orthographic view: no view ray crosses a side (T5)
std::vector<CountPlan> planCounts(const Silhouettes& silhouettes, const LightGroup& group, std::uint32_t l,
                                  std::uint32_t layerBound, bool parallelToView, const CountSettings& settings);

/// Draws parts of volumes into whatever framebuffer is bound.
class VolumeRenderer {
public:
    /// @param samples  of what is drawn into
    explicit VolumeRenderer(int samples);

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
        const gpu::Program& of(Into into) const;
    };
    static Programs programs(const char* vertex, bool edgeOn, int samples);
    void drawSides(const VolumePart& part, const Silhouettes& silhouettes, std::uint32_t l);
    void drawCap(const VolumePart& part, const gpu::Program& program, gpu::RasterState state, const Geometry& geometry,
                 const Silhouettes& silhouettes, const LightGroup& group, std::uint32_t l);

    Programs sides_, edgeOnSides_, caps_, edgeOnCaps_;
    gpu::VertexArray vertexArray_{"volumes"};
    glm::vec4 hullColor_{1.0f};
    gpu::Buffer pattern_;  // indices of quads: 0 1 2, 0 2 3, 4 5 6, ...
};

}  // namespace umbrage
