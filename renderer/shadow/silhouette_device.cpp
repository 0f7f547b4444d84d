// SPDX-License-Identifier: Apache-2.0
#include "shadow/silhouette_device.h"

namespace umbrage {

static_assert(int(Fault::FacingTwice) == FAULT_FACING_TWICE && int(Fault::WrongFacing) == FAULT_WRONG_FACING &&
              int(Fault::MissingEdge) == FAULT_MISSING_EDGE && int(Fault::OriginExtrusion) == FAULT_ORIGIN_EXTRUSION);

DeviceSilhouettes::DeviceSilhouettes(Fault fault)
    : facing_("facing.comp", {}, {planted(fault)}), facingByParts_("facing.comp", {}, {planted(fault), "PARTS 1"}) {}

namespace {

void setCommonUniforms(const gpu::Program& program, const LightGroup& group, const SweepOptions& options,
                       const Silhouettes& out) {
    program.uniform(1, out.facingBase(group));
    program.uniform(2, group.count);
    program.uniform(3, group.first);
    program.uniform(4, out.totalLights);
    program.uniform(5, GLuint(options.figures));
    if (out.parts) program.uniform(8, out.parts->clusterCount());
}

}  // namespace

void DeviceSilhouettes::setSweepUniforms(const gpu::Program& program, const Geometry& geometry, const LightGroup& group,
                                         const SweepOptions& options, const Silhouettes& out) {
    setCommonUniforms(program, group, options, out);
    program.uniform(0, geometry.edgeChunkCount());
    program.uniform(7, GLuint(options.halve));
}

void DeviceSilhouettes::sweep(const Geometry& geometry, const LightGroup& group, const SweepOptions& options,
                              Silhouettes& out) {
    halve_ = options.halve;
    geometry.bind();
    out.bind();
    const gpu::Program& facing = out.parts ? facingByParts_ : facing_;
    setCommonUniforms(facing, group, options, out);
    facing.uniform(0, geometry.triangleChunkCount());
    facing.dispatchGroups(geometry.triangleChunkCount());
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    if (!options.edges) return;
    sweepEdges(geometry, group, options, out);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT);
    out.summaries.read(0, out.hostSummaries.size() * sizeof(gpu::LightSummary), out.hostSummaries.data());
    out.casters.read(0, out.hostCasters.size() * sizeof(gpu::CasterState), out.hostCasters.data());
    if (out.parts) out.parts->read();
}

}  // namespace umbrage
