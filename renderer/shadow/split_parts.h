// SPDX-License-Identifier: Apache-2.0
// Parts of casters on the device, for counts that differ from part to part (Laine 2005): which part every triangle
// belongs to for each light of a group, the parts' split planes, and what the sweep finds out about them.
//
// Triangles belong to clusters for good; parts are sets of clusters, chosen anew for every light and eye.
#pragma once

#include <vector>

#include "gpu/objects.h"
#include "gpu/program.h"
#include "shadow/split_plane.h"

namespace umbrage {

/// The parts of one light.
struct LightParts {
    std::vector<std::uint32_t> ofCluster;  // the part of each
    std::vector<SplitPoints> parts;
    std::vector<std::vector<glm::dvec3>> extremes;  // of each part's vertices, in the world
};

class SplitParts {
public:
    /// @param ofPlacedTriangle  the cluster of each
    void setClusters(std::vector<std::uint32_t> ofPlacedTriangle, std::uint32_t clusterCount);

    /// @param lights  those of a group
    void set(std::span<const LightParts> lights, std::uint32_t firstLight, const Eye& eye);

    /// Before a sweep: nothing is found yet. Makes the planes.
    void begin();
    void bind() const;
    void read();    // waits
    void upload();  // `host`, after a sweep there

    std::uint32_t clusterCount() const { return clusterCount_; }
    std::uint32_t firstCluster(std::uint32_t l) const { return l * clusterCount_; }
    std::uint32_t partOf(std::uint32_t placedTriangle, std::uint32_t l) const {
        return partOf_[firstCluster(l) + clusters_[placedTriangle]];
    }
    /// Those of a light, in `host`: first and one past the last.
    std::array<std::uint32_t, 2> partsOf(std::uint32_t l) const {
        return {l * partsPerLight_, (l + 1) * partsPerLight_};
    }

    std::vector<gpu::SplitPart> host;  // as last read, or to be uploaded

private:
    std::vector<std::uint32_t> clusters_, partOf_;
    std::uint32_t clusterCount_ = 0, partsPerLight_ = 0, firstLight_ = 0;
    gpu::Buffer clusterBuffer_, partOfBuffer_, parts_;
    gpu::Program planes_{"split_planes.comp"};
};

}  // namespace umbrage
