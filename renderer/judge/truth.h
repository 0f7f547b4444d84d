// SPDX-License-Identifier: Apache-2.0
// What the oracle is asked about: the triangles of a moment in the world, as the file has them or as the device has
// deformed them, and nothing else of the renderer.
#pragma once

#include <memory>
#include <vector>

#include "oracle/oracle.h"
#include "shadow/geometry.h"

namespace umbrage {

class Truth {
public:
    explicit Truth(const Scene& scene) : scene_(scene) {}

    /// Goes to a moment. Keeps the oracle where no triangle has moved.
    void update(const Moment& moment, const Geometry& geometry);

    const oracle::Oracle& oracle() const { return *oracle_; }
    /// @param placed  as numbered by the renderer; NO_TRIANGLE gives kNothing
    std::uint32_t indexOf(std::uint32_t placed) const {
        return placed < indices_.size() ? indices_[placed] : oracle::kNothing;
    }

private:
    const Scene& scene_;
    std::unique_ptr<oracle::Oracle> oracle_;
    std::vector<std::uint32_t> indices_;  // oracle's triangle per placed triangle
};

}  // namespace umbrage
