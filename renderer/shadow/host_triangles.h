// SPDX-License-Identifier: Apache-2.0
// Triangles on the host, in structures of arrays, for passes over all of them: which side faces a light, their planes
// in view space.
#pragma once

#include <vector>

#include "shadow/geometry.h"

namespace umbrage {

class HostTriangles {
public:
    /// Once a frame. Reads back what has moved: positions of what deforms are computed on the device only.
    void update(const Geometry& geometry);

    const std::vector<float>& positions() const { return positions_; }
    glm::vec3 position(std::uint32_t vertex) const {
        return {positions_[3 * vertex], positions_[3 * vertex + 1], positions_[3 * vertex + 2]};
    }
    /// Normal, not of unit length, and first corner of a triangle of an instance, in its model space.
    glm::vec3 normal(std::uint32_t instance, std::uint32_t triangle) const;
    std::array<glm::vec3, 3> corners(const Geometry& geometry, std::uint32_t instance, std::uint32_t triangle) const;

    /// Of an instance, in its model space.
    const Geometry::Bounds& box(std::uint32_t instance) const { return boxes_[first_[instance].box]; }

    /// Sets `bit` for the triangles from `first` on whose front faces the light and for those whose back does, of which
    /// are also those of even components that are edge-on: any weight is legal (G1), and so every edge of them keeps an
    /// even multiplicity.
    /// @param light  homogeneous, in model space
    void face(std::uint32_t instance, std::uint32_t first, std::uint32_t count, const glm::vec4& light,
              std::uint32_t bit, std::uint32_t* front, std::uint32_t* back) const;

    /// Unit normal and offset of each triangle's plane in view space.
    void planes(const gpu::InstanceData& instance, std::uint32_t i, std::uint32_t first, std::uint32_t count,
                gpu::vec4* out) const;

private:
    struct First {
        std::size_t triangle = 0, box = 0;
    };
    void set(const Geometry& geometry, std::uint32_t instance);

    std::vector<float> positions_;
    std::vector<First> first_;  // per instance; rigid ones share those of their mesh
    std::vector<float> nx_, ny_, nz_, ax_, ay_, az_;
    std::vector<std::uint32_t> even_;  // all bits or none
    std::vector<Geometry::Bounds> boxes_;
    std::vector<std::uint32_t> own_;  // instances that deform
};

}  // namespace umbrage
