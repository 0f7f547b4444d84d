// SPDX-License-Identifier: Apache-2.0
// Which parts the casters of a scene are counted by, and where their split planes go: as the sequence says, the rest
// automatically.
#pragma once

#include <span>
#include <vector>

#include "job/job.h"
#include "scene/moment.h"
#include "shadow/geometry.h"
#include "shadow/split_parts.h"

namespace umbrage {

class CasterParts {
public:
    /// @throws Error(Input) where the job names nodes that are not there
    CasterParts(const Scene& scene, const Moment& first, const Geometry& geometry, const JobParts& wanted);

    /// Chooses the parts of a group's lights.
    /// @param lights  in the world
    void choose(const Moment& moment, const Geometry& geometry, std::span<const Homogeneous> lights,
                std::uint32_t firstLight, const Eye& eye);

    SplitParts& onDevice() { return onDevice_; }

private:
    /// What never comes apart.
    struct Cluster {
        std::uint32_t instance = 0;
        std::vector<glm::dvec3> extremes;  // of its vertices, in the instance's model space; empty: it deforms
    };
    struct Given {
        SplitChoice choice;
        Index pointsNode = kNone;  // whose space its points are in
    };
    std::vector<glm::dvec3> pointsOf(std::span<const std::uint32_t> clusters, const Moment& moment,
                                     const Geometry& geometry) const;

    InstanceParts groups_;
    std::vector<Given> given_;  // per group
    std::vector<Cluster> clusters_;
    std::vector<std::vector<std::uint32_t>> clustersOf_;  // per group
    std::vector<Geometry::Bounds> bounds_;                // of this frame, in model space
    SplitParts onDevice_;
};

}  // namespace umbrage
