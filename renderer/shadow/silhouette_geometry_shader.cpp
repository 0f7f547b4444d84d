// SPDX-License-Identifier: Apache-2.0
// Silhouettes in the geometry stage, from triangles with adjacency (GPU Gems 3, chapter 11; silhouettes.geom.glsl).
#include "shadow/sides.h"
#include "shadow/silhouette_classed.h"

namespace umbrage {
namespace {

/// Per triangle of every mesh the records of its edges, within the mesh; EDGE_NONE where it casts nothing.
std::vector<std::uint32_t> adjacencyOf(const Geometry& geometry) {
    std::vector<std::uint32_t> adjacency(3 * geometry.triangleFlags().size(), EDGE_NONE);
    std::vector<bool> done(geometry.topologies().size());
    for (std::size_t i = 0; i < geometry.instances().size(); ++i) {
        if (done[geometry.meshOf(i)]) continue;
        done[geometry.meshOf(i)] = true;
        const std::uint32_t triangleBase = geometry.instances()[i].triangleBase;
        const std::vector<MeshEdge>& edges = geometry.topologies()[geometry.meshOf(i)].edges;
        const auto add = [&](std::uint32_t triangle, std::uint32_t record) {
            std::uint32_t* records = &adjacency[3 * std::size_t(triangleBase + triangle)];
            while (*records != EDGE_NONE) ++records;  // a triangle has no more than three edges
            *records = record;
        };
        for (std::uint32_t record = 0; record < edges.size(); ++record) {
            add(edges[record].left, record);
            if (edges[record].right != MeshEdge::kNoTriangle) add(edges[record].right, record);
        }
    }
    return adjacency;
}

class GeometryShader : public ClassedSilhouettes {
public:
    explicit GeometryShader(Fault fault) : ClassedSilhouettes(fault) {}

    std::string_view name() const override { return "geometry-shader"; }
    SideShaders sideShaders() const override { return {"adjacency.vert", "silhouettes.geom"}; }
    void drawSides(const SideList& sides, const gpu::Program& program) override {
        if (adjacency_.sizeBytes() == 0) {
            adjacency_ = gpu::Buffer::of("adjacency", std::span<const std::uint32_t>(adjacencyOf(sides.geometry)));
        }
        adjacency_.bindStorage(BIND_ADJACENCY);
        bindClasses();
        setEveryEdgeUniforms(sides, program);
        program.uniform(5, GLuint(mostQuads(sides.list) == 1));
        noVertices_.bind();
        glDrawArrays(GL_TRIANGLES_ADJACENCY, 0, GLsizei(6 * sides.geometry.placedTriangleCount()));
    }

private:
    gpu::Buffer adjacency_;
    gpu::VertexArray noVertices_{"triangles with adjacency"};
};

}  // namespace

std::unique_ptr<SilhouetteTechnique> makeGeometryShader(Fault fault) {
    return std::make_unique<GeometryShader>(fault);
}

}  // namespace umbrage
