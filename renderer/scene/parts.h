// SPDX-License-Identifier: Apache-2.0
// Parts of a scene's casters that are counted by one rule at a pixel (Laine 2005, section 6), and their shapes. Counts
// are sums over triangles (docs/rules.md, G1), so any grouping is right; a good one makes volumes that a plane splits
// well.
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <string>
#include <vector>

#include "job/job.h"
#include "scene/moment.h"

namespace umbrage {

/// Instances of a moment in groups.
struct InstanceParts {
    std::vector<std::uint32_t> ofInstance;  // the part of each
    std::vector<Index> nodes;               // per part: the node that a glob matched, or that of its one instance

    std::uint32_t count() const { return std::uint32_t(nodes.size()); }
};

/// Instances at and below a node that one of the globs matches are one part; of several such nodes the nearest above
/// counts. All other instances are parts by themselves. Numbered by their first instance.
/// @throws Error(Input) at a glob's place if it matches no node that has a mesh there or below
InstanceParts groupInstances(const Scene& scene, std::span<const Instance> instances,
                             std::span<const Located<std::string>> globs);

/// A cloud of points as far as split planes need it.
struct PartShape {
    glm::dvec3 low{0.0}, high{0.0};  // box with the axes of the points' space
    glm::dvec3 axisEnds[2]{};        // where the points end along their longest principal axis, through their mean
    double thinness = 1.0;           // extent along that axis in extents along the next

    glm::dvec3 center() const { return 0.5 * (low + high); }
};

PartShape shapeOf(std::span<const glm::dvec3> points);

}  // namespace umbrage
