// SPDX-License-Identifier: Apache-2.0
// Brabec & Seidel 2003 as it ran in 2003: vertex stages could not read textures, so the flags of edges go through the
// host, which lists the quads to be drawn. A baseline to measure against.
#include <bit>

#include "shadow/edge_texels.h"
#include "shadow/sides.h"

namespace umbrage {
namespace {

class VertexRejectReadback : public DeviceSilhouettes {
public:
    explicit VertexRejectReadback(Fault fault) : DeviceSilhouettes(fault), edges_({planted(fault)}) {}

    std::string_view name() const override { return "vertex-reject-readback"; }
    SideShaders sideShaders() const override { return ListedSides::shaders(); }
    void drawSides(const SideList& sides, const gpu::Program&) override { sides_.draw(sides); }

private:
    void sweepEdges(const Geometry& geometry, const LightGroup& group, const SweepOptions& options,
                    Silhouettes& out) override;

    EdgeTexels edges_;
    ListedSides sides_;
    std::vector<std::vector<std::uint32_t>> entries_;  // per list and light
};

void VertexRejectReadback::sweepEdges(const Geometry& geometry, const LightGroup& group, const SweepOptions& options,
                                      Silhouettes& out) {
    setSweepUniforms(edges_.program(), geometry, group, options, out);
    edges_.draw(geometry);
    const std::vector<gpu::uvec4> flags = edges_.read();
    entries_.assign(std::size_t(group.count) * LIST_COUNT, {});
    for (std::uint32_t placed = 0; placed < geometry.placedEdgeCount(); ++placed) {
        const gpu::uvec4& f = flags[placed];  // see edge_texels.frag.glsl
        for (std::uint32_t lights = f.x | f.y; lights != 0; lights &= lights - 1) {
            const auto l = std::uint32_t(std::countr_zero(lights));
            const std::uint32_t i = geometry.edgeChunks()[placed >> CHUNK_SHIFT];
            const gpu::InstanceData& instance = geometry.instances()[i];
            const gpu::Edge& edge = geometry.edges()[instance.edgeBase + placed - instance.placedEdgeBase];
            const std::uint32_t list =
                listOf(instance, out.hostCasters[i], l, edge.left & EDGE_EVEN) + (f.w >> l & 1u ? LIST_EDGE_ON : 0);
            std::vector<std::uint32_t>& entries = entries_[l * LIST_COUNT + list];
            entries.insert(entries.end(), f.z >> l & 1u ? 2 : 1, placed << 1 | (f.y >> l & 1u));
        }
    }
    ListedSides::upload(entries_, out);
}

}  // namespace

std::unique_ptr<SilhouetteTechnique> makeVertexRejectReadback(Fault fault) {
    return std::make_unique<VertexRejectReadback>(fault);
}

}  // namespace umbrage
