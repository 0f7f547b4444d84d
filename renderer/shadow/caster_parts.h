// SPDX-License-Identifier: Apache-2.0
// Which parts the casters of a scene are counted by, and where their split planes go: as the sequence says, the rest
// automatically, anew for every light and eye (what Laine 2005 left open): of each mesh's tree of clusters the cut that
// is guessed to change fewest counts, with the plane of either construction that does.
#pragma once

#include <span>
#include <vector>

#include "job/job.h"
#include "scene/clusters.h"
#include "scene/moment.h"
#include "shadow/bounds.h"
#include "shadow/geometry.h"
#include "shadow/split_estimate.h"
#include "shadow/split_parts.h"

namespace umbrage {

class CasterParts {
public:
    /// @throws Error(Input) where the job names nodes that are not there
    CasterParts(const Scene& scene, const Moment& first, const Geometry& geometry, const JobParts& wanted);

    /// Chooses the parts of a group's lights.
    /// @param modelBounds  of this frame's instances
    /// @param lights  in the world
    /// @param samples  of what is seen; none where `wantsSamples()` says so
    void choose(const Moment& moment, const Geometry& geometry, std::span<const Geometry::Bounds> modelBounds,
                std::span<const Homogeneous> lights, std::uint32_t firstLight, const Eye& eye,
                std::span<const DepthSample> samples);
    bool wantsSamples() const;

    SplitParts& onDevice() { return onDevice_; }
    /// Of the last choice, per light.
    const std::vector<LightParts>& chosen() const { return chosen_; }

private:
    /// Instances that the sequence counts as one, or one that may be divided.
    struct Group {
        std::vector<std::uint32_t> instances;
        SplitChoice choice;
        Index pointsNode = kNone;           // whose space its points are in
        const ClusterTree* tree = nullptr;  // of its one instance, where it may be divided
        std::uint32_t firstCluster = 0;     // of its leaves, or its only one
    };
    /// A node of a group's tree, or all of a group, and what is best for it.
    struct Candidate {
        SplitPoints plane;
        double updates = 0.0;
        bool divided = false;
    };
    struct View;

    void readGroups(const Scene& scene, const Moment& first, const JobParts& wanted);
    void makeClusters(const Scene& scene, const Geometry& geometry);
    std::vector<glm::dvec3> pointsOf(const Group& group, const Moment& moment, const Geometry& geometry,
                                     std::span<const Geometry::Bounds> bounds) const;
    void addParts(const Group& group, const SplitChoice& choice, std::span<const glm::dvec3> points, const View& view,
                  const glm::dmat4& worldFromModel, LightParts& parts) const;
    static Candidate best(const SplitChoice& choice, const PartOutline& outline, const View& view);

    bool automatic_ = false;
    InstanceParts parts_;
    std::vector<Group> groups_;
    std::vector<ClusterTree> trees_;                         // per mesh; only of those that may be divided
    std::vector<std::vector<glm::dvec3>> extremesOfMeshes_;  // empty: it deforms
    std::vector<LightParts> chosen_;
    SplitParts onDevice_;
};

}  // namespace umbrage
