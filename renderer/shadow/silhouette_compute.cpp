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
        for (const bool parts : {false, true}) {
            gpu::Program::Defines defines{planted};
            if (parts) defines.push_back("PARTS 1");
            facing_[parts] = gpu::Program("facing.comp", {}, defines);
            edges_[parts] = gpu::Program("edges.comp", {}, defines);
        }
    }

    std::string_view name() const override { return "compute"; }

    void sweep(const Geometry& geometry, const LightGroup& group, const SweepOptions& options,
               Silhouettes& out) override {
        geometry.bind();
        out.bind();
        const gpu::Program &facing = facing_[out.parts != nullptr], &edges = edges_[out.parts != nullptr];
        for (const gpu::Program* program : {&facing, &edges}) {
            if (out.parts) program->uniform(8, out.parts->clusterCount());
            program->uniform(1, out.facingBase(group));
            program->uniform(2, group.count);
            program->uniform(3, group.first);
            program->uniform(4, out.totalLights);
            program->uniform(5, GLuint(options.figures));
        }
        facing.uniform(0, geometry.triangleChunkCount());
        edges.uniform(0, geometry.edgeChunkCount());
        edges.uniform(6, out.capacity);
        edges.uniform(7, GLuint(options.halve));
        facing.dispatchGroups(geometry.triangleChunkCount());
        glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
        edges.dispatchGroups(geometry.edgeChunkCount());
        glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT);
        out.summaries.read(0, out.hostSummaries.size() * sizeof(gpu::LightSummary), out.hostSummaries.data());
        out.casters.read(0, out.hostCasters.size() * sizeof(gpu::CasterState), out.hostCasters.data());
        if (out.parts) out.parts->read();
    }

private:
    gpu::Program facing_[2], edges_[2];  // those for counts by parts second
};

}  // namespace

std::unique_ptr<SilhouetteTechnique> makeComputeSilhouettes(Fault fault) {
    return std::make_unique<ComputeSilhouettes>(fault);
}

}  // namespace umbrage
