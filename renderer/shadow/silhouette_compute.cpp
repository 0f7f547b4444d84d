// SPDX-License-Identifier: Apache-2.0
// Silhouettes wholly on the device, for up to 32 lights a dispatch: what Brabec & Seidel 2003 asked of future hardware.
#include "gpu/program.h"
#include "shadow/silhouette.h"

namespace umbrage {
namespace {

static_assert(int(Fault::FacingTwice) == FAULT_FACING_TWICE && int(Fault::WrongFacing) == FAULT_WRONG_FACING &&
              int(Fault::MissingEdge) == FAULT_MISSING_EDGE);

class ComputeSilhouettes : public SilhouetteTechnique {
public:
    explicit ComputeSilhouettes(Fault fault) {
        const std::string planted = "FAULT " + std::to_string(int(fault));
        facing_ = gpu::Program("facing.comp", {}, {planted});
        edges_ = gpu::Program("edges.comp", {}, {planted});
    }

    std::string_view name() const override { return "compute"; }

    void sweep(const Geometry& geometry, const LightGroup& group, const SweepOptions& options,
               Silhouettes& out) override {
        geometry.bind();
        out.bind();
        for (const gpu::Program* program : {&facing_, &edges_}) {
            program->uniform(1, out.facingBase(group));
            program->uniform(2, group.count);
            program->uniform(3, group.first);
            program->uniform(4, out.totalLights);
            program->uniform(5, GLuint(options.figures));
        }
        facing_.uniform(0, geometry.triangleChunkCount());
        edges_.uniform(0, geometry.edgeChunkCount());
        edges_.uniform(6, out.capacity);
        edges_.uniform(7, GLuint(options.halve));
        facing_.dispatchGroups(geometry.triangleChunkCount());
        glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
        edges_.dispatchGroups(geometry.edgeChunkCount());
        glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT);
        out.summaries.read(0, out.hostSummaries.size() * sizeof(gpu::LightSummary), out.hostSummaries.data());
        out.casters.read(0, out.hostCasters.size() * sizeof(gpu::CasterState), out.hostCasters.data());
    }

private:
    gpu::Program facing_, edges_;
};

}  // namespace

std::unique_ptr<SilhouetteTechnique> makeComputeSilhouettes(Fault fault) {
    return std::make_unique<ComputeSilhouettes>(fault);
}

}  // namespace umbrage
