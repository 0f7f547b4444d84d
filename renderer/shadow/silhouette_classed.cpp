// SPDX-License-Identifier: Apache-2.0
#include "shadow/silhouette_classed.h"

namespace umbrage {

ClassedSilhouettes::ClassedSilhouettes(Fault fault)
    : DeviceSilhouettes(fault), sweep_("edge_classes.comp", {}, {planted(fault)}) {}

void ClassedSilhouettes::sweepEdges(const Geometry& geometry, const LightGroup& group, const SweepOptions& options,
                                    Silhouettes& out) {
    classes_.reserve("classes of edges", geometry.placedEdgeCount() * sizeof(gpu::uvec2));
    bindClasses();
    setSweepUniforms(sweep_, geometry, group, options, out);
    sweep_.dispatchGroups(geometry.edgeChunkCount());
}

}  // namespace umbrage
