// SPDX-License-Identifier: Apache-2.0
// A few depths of what is seen, read back for guesses (shadow/split_estimate.h).
#pragma once

#include "gpu/objects.h"
#include "gpu/program.h"
#include "shadow/split_estimate.h"

namespace umbrage {

class DepthSampler {
public:
    /// @param depthStencil  holds the depth of what is seen
    explicit DepthSampler(const gpu::Texture& depthStencil);

    std::vector<DepthSample> read();  // waits

private:
    const gpu::Texture& depthStencil_;
    gpu::Program program_;
    gpu::Buffer depths_;
};

}  // namespace umbrage
