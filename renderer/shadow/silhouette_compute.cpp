// SPDX-License-Identifier: Apache-2.0
// Silhouettes wholly on the device, for up to 32 lights a dispatch: what Brabec & Seidel 2003 asked of future hardware.
#include "gpu/program.h"
#include "shadow/silhouette.h"

namespace umbrage {
namespace {

class ComputeSilhouettes : public SilhouetteTechnique {
public:
    std::string_view name() const override { return "compute"; }

    void sweep(const Geometry& geometry, const LightGroup& group, bool figures, Silhouettes& out) override {
        geometry.bind();
        out.bind();
        for (const gpu::Program* program : {&facing_, &edges_}) {
            program->uniform(1, out.facingBase(group));
            program->uniform(2, group.count);
            program->uniform(3, group.first);
            program->uniform(4, out.totalLights);
            program->uniform(5, GLuint(figures));
        }
        facing_.uniform(0, geometry.triangleChunkCount());
        edges_.uniform(0, geometry.edgeChunkCount());
        edges_.uniform(6, out.capacity);
        facing_.dispatchGroups(geometry.triangleChunkCount());
        glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
        edges_.dispatchGroups(geometry.edgeChunkCount());
        glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT);
        out.summaries.read(0, out.hostSummaries.size() * sizeof(gpu::LightSummary), out.hostSummaries.data());
        out.casters.read(0, out.hostCasters.size() * sizeof(gpu::CasterState), out.hostCasters.data());
    }

private:
    gpu::Program facing_{"facing.comp"}, edges_{"edges.comp"};
};

}  // namespace

std::unique_ptr<SilhouetteTechnique> makeComputeSilhouettes() {
    return std::make_unique<ComputeSilhouettes>();
}

}  // namespace umbrage
