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

#include <algorithm>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "shadow/bounds.h"
#include "shadow/eye.h"
#include "shadow/volumes.h"

namespace umbrage {

/// What one count needs: its parts, and what the counter holds where nothing is in shadow.
struct CountPlan {
    std::vector<VolumePart> parts;
    int litValue = 0;
    bool allDark = false;               // the eye constant alone decides
    bool wide = false;                  // counts may exceed what 8 bits hold (T6)
    std::uint32_t layerBound = 0;       // no count is larger
    int crossings = 1;                  // that one of its count stands for
    int eyeLayers = 0;                  // volumes that hold every sample's start, and that no part counts
    bool byParts = false;               // its parts have Rule::Split, so that it is wide ...
    std::vector<std::uint32_t> starts;  // ... and these parts of the casters start from a constant of their own
    bool inverted = false;              // only parity is kept; of the full count:
    int fullLitValue = 0;
    bool fullIsWide = false;
};

/// What plans depend on beside the silhouettes.
struct CountSettings {
    bool eyeConstant = true;  // off: textbook z-pass, wrong with the eye in a volume
    bool halve = true;        // as in SweepOptions
    bool perspective = true;
    std::vector<bool> holed;  // per instance: has alpha-masked triangles
};

/// What a technique plans the counts of one light from.
struct CountInput {
    const Silhouettes& silhouettes;
    const LightGroup& group;
    std::uint32_t l = 0;           // of the group
    std::uint32_t layerBound = 0;  // no more layers than these lie between the light and any point
    bool parallelToView = false;   // directional, along an orthographic view: no view ray crosses a side (T5)
    const CountSettings& settings;
};

/// What techniques may look at before the silhouettes of a frame are found.
struct CountFrame {
    const Geometry& geometry;
    std::span<const Geometry::Bounds> modelBounds;  // per instance
    const Eye& eye;
    std::span<const ShadowLight> lights;   // all that shine
    std::span<const double> rangesMetres;  // of them; 0: infinite
};

/// A way of counting. One a file: count_<name>.cpp; what they share is in counts.cpp and volumes.cpp.
class CountTechnique {
public:
    virtual ~CountTechnique() = default;

    /// Share of the depth range that it needs before what is seen.
    virtual double ledge() const { return 0.0; }

    virtual void begin(const CountFrame&) {}

    /// Why it may be wrong for a light of the frame; empty: it is exact, as far as it claims that at all.
    virtual std::string whyInexact(std::uint32_t) const { return {}; }

    /// Whether a caster must not be halved in this frame.
    virtual bool countsWhole(std::uint32_t) const { return false; }

    /// Where counts from the eye begin.
    virtual VolumePart::Start start() const { return VolumePart::Start::Eye; }

    /// Whether casters are counted by z-fail, from infinity, unless the eye is near their volumes; else from the eye.
    virtual bool fromInfinity() const { return false; }

    /// Whether something is wrong where rasteriser and eye constant disagree (T4).
    virtual bool hasEyeConstant() const { return start() == VolumePart::Start::Eye; }

    /// Whether volumes end behind all that the light shines on, also where that is not wanted as a skip (T2).
    virtual bool endsVolumes() const { return false; }

    /// Where volumes end instead, from the light (of a directional one, from the caster); 0: not at a distance.
    virtual double endMetres() const { return 0.0; }

    /// Whether every crossing inverts the count's bits instead of adding to it.
    virtual bool inverts() const { return false; }

    /// Whether it counts by parts of the casters (Silhouettes::parts).
    virtual bool byParts() const { return false; }

    /// Whether the processor counts, see shadow/tile_lights.h.
    virtual bool byTiles() const { return false; }

    /// The halved and the whole count of a light, as far as there is something to count.
    virtual std::vector<CountPlan> plan(const CountInput& input) const;

protected:
    /// Whether a caster's volume, counted from infinity, needs its far end closed.
    bool needsDarkCap(const CountInput& input, std::uint32_t instance) const;

    /// What the whole count needs where counts begin elsewhere than at the eye: what an eye constant is for the others.
    virtual void addStart(CountPlan&, const CountInput&) const {}
};

/// Casters whose volumes may pass through the picture's rectangle at some distance, light by light: those need caps
/// there, and the others none.
class ReachingCasters {
public:
    void find(const CountFrame& frame, double distance);
    bool any(std::uint32_t instance) const {
        return std::ranges::find(reach_[instance], true) != reach_[instance].end();
    }
    /// Those of a light of the frame that cast its shadows, ascending.
    std::vector<std::uint32_t> of(const CountInput& input) const;

private:
    std::vector<std::vector<bool>> reach_;  // per instance and light
};

struct CountOptions {
    double endMetres = 0.0;  // of techniques whose volumes end; 0: behind all that the light shines on
};

/// @param name  of kCounts
std::unique_ptr<CountTechnique> makeCountTechnique(std::string_view name, const CountOptions& options = {});

}  // namespace umbrage
