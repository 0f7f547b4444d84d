// SPDX-License-Identifier: Apache-2.0
// What the tracer (tracer.h) traces: all opaque triangles of a moment in one space and one hierarchy of Embree's.
//
// Not copied: blended surfaces, lines and points. Alpha masks are as good as their material's constant alpha.
#pragma once

#include <memory>
#include <vector>

#include "bench/tracer_tile.h"
#include "shadow/geometry.h"

namespace umbrage {

class TracerScene {
public:
    explicit TracerScene(const Scene& scene);
    ~TracerScene();

    /// Places the triangles as they are in a moment, in floats relative to origin(). The renderer's geometry has just
    /// been updated for that moment and `eye`: what deforms is read from it.
    /// @return whether anything moved; then one of the next two must follow
    bool place(const Moment& moment, const Geometry& geometry, const Eye& eye);

    /// Makes the hierarchy from nothing, with Embree's surface area heuristic. @return milliseconds
    double build();
    /// Fits a hierarchy of its own, made of the first placed moment, to where the triangles are now; rays do not use
    /// it.
    /// @return milliseconds
    double refit();

    /// Fills what a frame needs to know of the scene.
    void describe(TracerFrame& frame) const;

    const glm::dvec3& origin() const { return origin_; }
    /// The renderer's number of a triangle: InstanceData::placedTriangleBase + triangle of the mesh.
    const std::vector<std::uint32_t>& placedTriangles() const { return placedTriangles_; }

private:
    struct Hierarchies;

    void number(const Moment& moment, const Geometry& geometry);

    const Scene& scene_;
    std::unique_ptr<Hierarchies> hierarchies_;
    glm::dvec3 origin_{0.0};
    std::vector<std::size_t> firstVertex_;                 // per instance
    std::vector<glm::dmat4> placings_;                     // of what is placed; per instance
    std::vector<float> deformed_;                          // positions on the device, as they were placed
    std::vector<float> positions_, normals_;               // three a vertex; positions end with padding
    std::vector<std::int32_t> vertices_;                   // three a triangle
    std::vector<std::uint32_t> traits_, placedTriangles_;  // per triangle
    std::vector<TracerMaterial> materials_;
};

}  // namespace umbrage
