// SPDX-License-Identifier: Apache-2.0
#include "batch/frame_reuse.h"

#include "batch/frame_files.h"
#include "frame/frame_inputs.h"
#include "frame/settings.h"

namespace umbrage {
namespace {

// Of inputs that are kept: 500 frames of a thousand nodes.
constexpr std::size_t kMostBytes = std::size_t{64} << 20;

}  // namespace

FrameReuse::FrameReuse(const Job& job, const Composition& composition) : job_(job), composition_(composition) {
    // Times are measured, so each frame has its own.
    on_ = job.shadow.isSkipOn("frames") && !job.diagnostics.profile;
    nodes_ = !job.shadow.parts.ownSplitPlanes.empty();
    // Overlays may have the frame's number burnt in; that of techniques always has.
    numbered_ = (job.diagnostics.burnIn && !job.diagnostics.overlays.empty()) || comparesTechniques(job);
}

std::string FrameReuse::inputs(int frame, const FrameMaker::Placed& placed) const {
    std::string bytes = inputsOf(composition_.scene, placed.now, nodes_);
    if (placed.before) bytes += inputsOf(composition_.scene, *placed.before, nodes_);
    if (numbered_) bytes += std::to_string(frame);
    return bytes;
}

std::optional<int> FrameReuse::find(int frame, const FrameMaker::Placed& placed, bool deforms) {
    if (!on_) return std::nullopt;
    std::string now = inputs(frame, placed);
    const auto found = frameOf_.find(now);
    const bool isIt = found != frameOf_.end() && (!deforms || now == last_);
    const std::optional<int> earlier = isIt ? std::optional(found->second) : std::nullopt;
    last_ = now;
    if (earlier) return earlier;
    const auto [place, isNew] = frameOf_.insert_or_assign(std::move(now), frame);
    if (!isNew) return std::nullopt;
    oldestFirst_.push_back(&place->first);
    bytes_ += place->first.size();
    while (bytes_ > kMostBytes && oldestFirst_.size() > 1) {
        bytes_ -= oldestFirst_.front()->size();
        frameOf_.erase(frameOf_.find(*oldestFirst_.front()));
        oldestFirst_.pop_front();
    }
    return std::nullopt;
}

}  // namespace umbrage
