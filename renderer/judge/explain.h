// SPDX-License-Identifier: Apache-2.0
// The second stage: whether a sample whose mask differs from the exact answer lies where rounding may decide.
#pragma once

#include <functional>
#include <vector>

#include "judge/tolerance.h"
#include "judge/verdict.h"
#include "oracle/oracle.h"

namespace umbrage {

/// A light of the moment as the exact answer needs it.
struct JudgedLight {
    explicit JudgedLight(const PlacedLight& placed);

    glm::dvec4 place;
    bool on = false;
    double range = 0.0;  // 0: unlimited
    bool spot = false;
    glm::dvec3 direction{0.0};
    double cosOuterCone = 0.0;

    /// Whether something arrives at p, shadows apart: range and cone. `slack` widens (or, negative, narrows) both.
    bool arrives(const glm::dvec3& p, double slack = 0.0) const;
};

/// What is known about a surface point and a light, exactly.
struct Exactly {
    bool facing = false;   // turned to the light, in its range and cone, the light on
    bool reaches = false;  // and not in shadow
};

Exactly exactly(const oracle::Oracle& oracle, const JudgedLight& light, std::uint32_t seen, const oracle::Ray& ray);

class Explainer {
public:
    /// @param farthest  the largest distance along the view axis that is seen
    Explainer(const oracle::Oracle& oracle, const oracle::EyeRays& rays, const Tolerance& tolerance, double farthest);

    /// A sample in question.
    struct Sample {
        double x, y;            // pixels
        std::uint32_t seen;     // by the oracle; kNothing: background
        std::uint32_t claimed;  // by the renderer
    };

    /// @param claim  the renderer's mask there, which is not the exact one
    SampleVerdict explainMask(const JudgedLight& light, const Sample& sample, bool claim) const;

    /// Whether rounding may explain a number of layers.
    /// @param claimed  accepts the numbers that agree with the renderer's
    bool explainsCount(const JudgedLight& light, const Sample& sample,
                       const std::function<bool(std::uint32_t)>& claimed) const;

    /// Whether the exact mask changes within the rasteriser's tolerance around a sample; thin shadows are missed.
    bool changesNearby(const JudgedLight& light, const Sample& sample, bool exact) const;

private:
    struct Patch;
    using Answers = std::function<bool(std::uint32_t seen, const oracle::EyeRay& ray)>;

    SampleVerdict explain(const JudgedLight& light, const Sample& sample, const Answers& answersAsClaimed) const;
    bool grazing(const JudgedLight& light, std::uint32_t seen, const oracle::Ray& ray) const;
    bool plausible(const Sample& sample) const;
    Patch patchOf(const Sample& sample, std::uint32_t seen) const;
    bool onRangeOrCone(const JudgedLight& light, const Patch& patch) const;
    bool nearSilhouette(const JudgedLight& light, std::uint32_t seen, const Patch& patch) const;
    bool onBoundary(const JudgedLight& light, const Sample& sample, std::uint32_t seen) const;
    bool continues(const oracle::Corners& t, const oracle::Corners& receiver, const Patch& patch) const;
    bool endsOn(const JudgedLight& light, const glm::dvec3& a, const glm::dvec3& b) const;
    bool mayBeSilhouette(const JudgedLight& light, std::uint32_t triangle, std::size_t edge) const;
    const std::vector<std::pair<std::size_t, std::uint32_t>>& edges() const;

    const oracle::Oracle& oracle_;
    const oracle::EyeRays& rays_;
    Tolerance tolerance_;
    double farthest_;
    struct Edges;
    std::shared_ptr<Edges> edges_;  // made when first needed
};

}  // namespace umbrage
