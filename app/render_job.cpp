// SPDX-License-Identifier: Apache-2.0
#include "render_job.h"

#include <fmt/core.h>

#include "interrupt.h"
#include "progress.h"

namespace umbrage {
namespace {

class Watch : public BatchObserver {
public:
    explicit Watch(Progress& progress) : progress_(progress) {}

    void note(const std::string& text) override { progress_.note(text); }
    void started(std::size_t frameCount) override { progress_.started(frameCount); }
    void frameWritten(int frame, std::size_t, std::size_t) override {
        progress_.advanced(fmt::format("frame {} written", frame));
    }

private:
    Progress& progress_;
};

}  // namespace

BatchOptions batchOptionsOf(const RenderOptions& options) {
    BatchOptions batch;
    batch.device = options.device;
    batch.ocioConfig = options.ocio;
    batch.allowExternalFiles = options.allowExternalFiles;
    batch.workers = options.workers;
    batch.explain = options.explain;
    return batch;
}

BatchSummary renderWatched(const Job& job, const RenderOptions& options, bool quiet) {
    const std::atomic<bool>& interrupted = watchForInterrupts();
    Progress progress(options.progress, quiet);
    Watch watch(progress);
    return runBatch(job, batchOptionsOf(options), watch, interrupted);
}

}  // namespace umbrage
