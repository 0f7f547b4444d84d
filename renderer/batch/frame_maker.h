// SPDX-License-Identifier: Apache-2.0
// One frame of a job: evaluated, rendered, and where asked rendered again, for times or by another technique.
#pragma once

#include <memory>
#include <optional>

#include "batch/write_queue.h"
#include "diagnostics/statistics.h"
#include "frame/frame.h"
#include "job/job.h"
#include "scene/compose.h"

namespace umbrage {

class FrameMaker {
public:
    /// Job and composition must outlive it.
    /// @param first  the scene at the first frame's time
    /// @param figures  counters are wanted, also where the job asks for none
    /// @throws Error
    FrameMaker(const Job& job, const Composition& composition, const Moment& first, const gpu::Context& context,
               bool figures);

    /// The scene at a frame, and at the one before where an AOV looks at it.
    struct Placed {
        PlacedMoment now;
        std::optional<PlacedMoment> before;
        double milliseconds = 0.0;  // that it took to find them
    };
    Placed place(int frame) const;

    WriteQueue::Item make(int frame, const Placed& placed, Statistics& statistics);

    const FrameOutputs& outputs() const { return outputs_; }
    /// Whether positions are made on the device.
    bool deforms() const { return renderer_.geometry().deforms(); }

private:
    double pictureMilliseconds(FrameRenderer& renderer, const PlacedMoment& now, int frame) const;
    void measureRatio(const PlacedMoment& now, int frame, Statistics& statistics);

    const Job& job_;
    const Composition& composition_;
    FrameOutputs outputs_;
    FrameRenderer renderer_;
    std::unique_ptr<FrameRenderer> against_;                // where an overlay compares techniques
    std::unique_ptr<FrameRenderer> shadowed_, unshadowed_;  // where a budget wants the ratio of their times
    bool ratioIsWarm_ = false;
};

}  // namespace umbrage
