// SPDX-License-Identifier: Apache-2.0
// What silhouette techniques on the device share: triangles are decided by facing.comp, edges by a pass of the
// technique's own, and only summaries are read back.
#pragma once

#include "shadow/silhouette.h"

namespace umbrage {

class DeviceSilhouettes : public SilhouetteTechnique {
public:
    void sweep(const Geometry& geometry, const LightGroup& group, const SweepOptions& options, Silhouettes& out) final;

protected:
    explicit DeviceSilhouettes(Fault fault);

    /// For the passes that decide: which fault is planted.
    static std::string planted(Fault fault) { return "FAULT " + std::to_string(int(fault)); }
    /// The uniforms of edge_sweep.glsl.
    static void setSweepUniforms(const gpu::Program& program, const Geometry& geometry, const LightGroup& group,
                                 const SweepOptions& options, const Silhouettes& out);

    /// How many quads the edges of a list may have, after the last sweep.
    int mostQuads(std::uint32_t list) const { return halve_ && list % LIST_KINDS == LIST_HALVED ? 1 : 2; }

    /// All storage is bound and facing bits are stored.
    virtual void sweepEdges(const Geometry& geometry, const LightGroup& group, const SweepOptions& options,
                            Silhouettes& out) = 0;

private:
    gpu::Program facing_, facingByParts_;
    bool halve_ = true;
};

}  // namespace umbrage
