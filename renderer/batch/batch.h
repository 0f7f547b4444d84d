// SPDX-License-Identifier: Apache-2.0
// A job from start to end: load, compose, then render frame after frame while finished ones are encoded and written by
// worker threads. The same job on the same device gives the same bytes, whatever the number of workers.
#pragma once

#include <atomic>
#include <filesystem>
#include <string>
#include <vector>

#include "diagnostics/statistics.h"
#include "golden/provenance.h"
#include "job/job.h"

namespace umbrage {

struct BatchOptions {
    std::string device = "auto";  // see gpu::Context
    std::string ocioConfig;       // --ocio: wins over the job's
    bool allowExternalFiles = false;
    int workers = 0;       // encoding threads; 0: one less than the processor's, at least one
    bool explain = false;  // statistics are made also where the job writes none
};

/// What a run tells whoever watches. Calls come from one thread at a time.
class BatchObserver {
public:
    virtual ~BatchObserver() = default;
    virtual void note(const std::string& text) = 0;    // something was odd, chosen or ignored
    virtual void started(std::size_t frameCount) = 0;  // loading is over
    virtual void frameWritten(int frame, std::size_t done, std::size_t frameCount) = 0;
};

struct BatchSummary {
    std::vector<int> written;  // frames whose files are all there, ascending
    std::vector<int> missing;  // the others of the job
    std::size_t requested = 0;
    std::map<std::string, ManifestImage> images;  // of all frames of the job, by name from outputFolder() on
    double loadSeconds = 0.0, renderSeconds = 0.0;
    double peakMemoryMebibytes = 0.0;
    std::filesystem::path example;      // the first image written; empty: none was asked for
    std::vector<BudgetResult> budgets;  // in the job's order
    StatisticsFile statistics;          // of the frames written; empty where nobody wants any
    bool interrupted = false;
};

/// @param interrupted  polled between frames; what is being written is finished first
/// @throws Error; frames written by then are whole
BatchSummary runBatch(const Job& job, const BatchOptions& options, BatchObserver& observer,
                      const std::atomic<bool>& interrupted);

/// Loads and composes what the job names, without a device. @throws Error
/// @return the files that runBatch() would write
std::vector<std::filesystem::path> checkBatch(const Job& job, const BatchOptions& options);

}  // namespace umbrage
