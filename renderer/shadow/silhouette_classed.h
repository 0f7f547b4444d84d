// SPDX-License-Identifier: Apache-2.0
// The sweep of techniques that find silhouettes only while they draw: of each edge it stores the class of its quad.
#pragma once

#include "shadow/silhouette_device.h"

namespace umbrage {

class ClassedSilhouettes : public DeviceSilhouettes {
public:
    bool fillsLists() const final { return false; }

protected:
    explicit ClassedSilhouettes(Fault fault);

    void bindClasses() const { classes_.bindStorage(BIND_QUADS); }

private:
    void sweepEdges(const Geometry& geometry, const LightGroup& group, const SweepOptions& options,
                    Silhouettes& out) final;

    gpu::Program sweep_;
    gpu::Buffer classes_;
};

}  // namespace umbrage
