// SPDX-License-Identifier: Apache-2.0
// Silhouettes wholly on the device, for up to 32 lights a dispatch: what Brabec & Seidel 2003 asked of future hardware.
#include "shadow/sides.h"
#include "shadow/silhouette_device.h"

namespace umbrage {
namespace {

class ComputeSilhouettes : public DeviceSilhouettes {
public:
    explicit ComputeSilhouettes(Fault fault)
        : DeviceSilhouettes(fault),
          edges_("edges.comp", {}, {planted(fault)}),
          edgesByParts_("edges.comp", {}, {planted(fault), "PARTS 1"}) {}

    std::string_view name() const override { return "compute"; }
    SideShaders sideShaders() const override { return ListedSides::shaders(); }
    void drawSides(const SideList& sides, const gpu::Program&) override { sides_.draw(sides); }

private:
    void sweepEdges(const Geometry& geometry, const LightGroup& group, const SweepOptions& options,
                    Silhouettes& out) override {
        const gpu::Program& edges = out.parts ? edgesByParts_ : edges_;
        setSweepUniforms(edges, geometry, group, options, out);
        edges.uniform(6, out.capacity);
        edges.dispatchGroups(geometry.edgeChunkCount());
    }

    gpu::Program edges_, edgesByParts_;
    ListedSides sides_;
};

}  // namespace

std::unique_ptr<SilhouetteTechnique> makeComputeSilhouettes(Fault fault) {
    return std::make_unique<ComputeSilhouettes>(fault);
}

}  // namespace umbrage
