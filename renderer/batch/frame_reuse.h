// SPDX-License-Identifier: Apache-2.0
// Which frames of a job are those of an earlier one, bit for bit, so that nothing of them needs to be rendered or
// encoded again.
#pragma once

#include <deque>
#include <optional>
#include <string>
#include <unordered_map>

#include "batch/frame_maker.h"
#include "job/job.h"
#include "scene/compose.h"

namespace umbrage {

class FrameReuse {
public:
    /// Job and composition must outlive it.
    FrameReuse(const Job& job, const Composition& composition);

    /// The first frame of those noted whose inputs are these, if there is one.
    /// @param deforms  positions are made on the device relative to an origin that depends on the frames between (T7):
    ///                 then only the frame before is looked at
    std::optional<int> find(int frame, const FrameMaker::Placed& placed, bool deforms);

private:
    std::string inputs(int frame, const FrameMaker::Placed& placed) const;

    const Job& job_;
    const Composition& composition_;
    bool on_ = false, nodes_ = false, numbered_ = false;
    // Inputs are compared whole, not by a hash of them: a skip must not rest on luck.
    std::unordered_map<std::string, int> frameOf_;
    std::deque<const std::string*> oldestFirst_;
    std::size_t bytes_ = 0;
    std::string last_;  // inputs of the frame before
};

}  // namespace umbrage
