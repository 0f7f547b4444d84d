// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>

#include <atomic>
#include <csignal>
#include <filesystem>

#include "batch/batch.h"
#include "commands.h"
#include "error.h"
#include "exit_codes.h"
#include "job/job.h"
#include "job/output_path.h"
#include "progress.h"

namespace umbrage {
namespace {

std::atomic<bool> interrupted{false};
std::atomic<int> interruptSignal{0};

/// The first signal ends the run after the frame at hand; a second one ends it the usual way. Files appear whole or
/// not at all, so either is safe.
void onSignal(int signal) {
    interrupted = true;
    interruptSignal = signal;
    std::signal(signal, SIG_DFL);
}

bool isScene(const std::filesystem::path& file) {
    const std::string extension = file.extension().string();
    return extension == ".gltf" || extension == ".glb";
}

/// Command-line options as the values of the sequence file that they override.
JobOverrides overridesOf(const RenderOptions& options) {
    JobOverrides overrides;
    if (!options.frames.empty() && options.frames != "all") {
        overrides.set.push_back(fmt::format("time.frames='{}'", options.frames));
    }
    if (!options.size.empty()) {
        const std::size_t x = options.size.find('x');
        if (x == std::string::npos) throw Error(ErrorKind::Usage, "--size", "is not WIDTHxHEIGHT", "such as 640x480");
        overrides.set.push_back(fmt::format("image.size=[{},{}]", options.size.substr(0, x), options.size.substr(x + 1)));
    }
    if (!options.camera.empty()) overrides.set.push_back(fmt::format("camera='{}'", options.camera));
    overrides.set.insert(overrides.set.end(), options.set.begin(), options.set.end());
    return overrides;
}

Job jobOf(const RenderOptions& options) {
    const std::filesystem::path input = options.input;
    if (!std::filesystem::exists(input)) throw Error(ErrorKind::Input, options.input, "there is no such file");
    const JobOverrides overrides = overridesOf(options);
    Job job = isScene(input) ? jobForScene(input, overrides) : readJob(input, overrides);
    if (!options.out.empty()) redirectOutput(job, options.out);
    return job;
}

}  // namespace

int runRender(const RenderOptions& options, bool quiet) {
    const Job job = jobOf(options);
    BatchOptions batch;
    batch.device = options.device;
    batch.ocioConfig = options.ocio;
    batch.allowExternalFiles = options.allowExternalFiles;
    batch.workers = options.workers;
    if (options.dryRun) {
        for (const std::filesystem::path& file : checkBatch(job, batch)) fmt::print("{}\n", file.string());
        return kOk;
    }
    std::signal(SIGINT, onSignal);
    std::signal(SIGTERM, onSignal);
    BatchSummary summary;
    {
        Progress progress(options.progress, quiet);
        summary = runBatch(job, batch, progress, interrupted);
    }
    const std::size_t done = summary.written.size();
    if (done > 0) {
        fmt::print(stderr, "{} of {} frames in {}: {:.2f} s to load, {:.2f} s to render ({:.3f} s a frame), {:.0f} MiB at most\n",
                   done, summary.requested, summary.example.parent_path().lexically_normal().string(), summary.loadSeconds,
                   summary.renderSeconds, summary.renderSeconds / double(done), summary.peakMemoryMebibytes);
    }
    if (summary.interrupted) {
        fmt::print(stderr, "umbrage: interrupted; frames still to render: --frames {}\n",
                   FrameRange::textOf(summary.missing));
        return interruptSignal == SIGTERM ? kTerminated : kInterrupted;
    }
    return done == summary.requested ? kOk : kFramesFailed;
}

}  // namespace umbrage
