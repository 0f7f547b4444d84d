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
#include "say.h"

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

/// A YAML string, whatever is in it.
std::string quoted(const std::string& text) {
    std::string made = "'";
    for (const char c : text) made.append(c == '\'' ? 2 : 1, c);
    return made + "'";
}

/// WIDTHxHEIGHT as the sequence file has it.
std::string sizeList(const std::string& text) {
    const std::size_t x = text.find('x');
    const std::string width = text.substr(0, x), height = x == std::string::npos ? "" : text.substr(x + 1);
    for (const std::string& number : {width, height}) {
        if (number.empty() || number.find_first_not_of("0123456789") != std::string::npos) {
            throw Error(ErrorKind::Usage, "--size", fmt::format("\"{}\" is not WIDTHxHEIGHT", text),
                        "two numbers of pixels, such as 640x480");
        }
    }
    return fmt::format("[{}, {}]", width, height);
}

/// Command-line options as the values of the sequence file that they override.
JobOverrides overridesOf(const RenderOptions& options) {
    JobOverrides overrides;
    overrides.wholeAnimation = options.frames == "all";
    if (!options.frames.empty() && !overrides.wholeAnimation) {
        overrides.options.push_back({"--frames", "time.frames=" + quoted(options.frames)});
    }
    if (!options.size.empty()) overrides.options.push_back({"--size", "image.size=" + sizeList(options.size)});
    if (!options.camera.empty()) overrides.options.push_back({"--camera", "camera=" + quoted(options.camera)});
    overrides.set = options.set;
    return overrides;
}

Job jobOf(const RenderOptions& options) {
    const std::filesystem::path input = options.input;
    std::error_code failed;
    if (!std::filesystem::exists(input, failed)) {
        throw Error(ErrorKind::Input, options.input, failed ? failed.message() : "there is no such file");
    }
    const JobOverrides overrides = overridesOf(options);
    Job job = isScene(input) ? jobForScene(input, overrides) : readJob(input, overrides);
    if (!options.out.empty()) redirectOutput(job, options.out);
    return job;
}

void printSummary(const BatchSummary& summary) {
    const std::filesystem::path folder = summary.example.parent_path().lexically_normal();
    const std::string where = summary.example.empty() ? "no folder" : folder.empty() ? "." : folder.string();
    const std::size_t done = summary.written.size();
    say("{} of {} frames in {}: {:.2f} s to load, {:.2f} s to render ({:.3f} s a frame), {:.0f} MiB at most\n", done,
        summary.requested, where, summary.loadSeconds, summary.renderSeconds, summary.renderSeconds / double(done),
        summary.peakMemoryMebibytes);
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
    if (done > 0 && !quiet) printSummary(summary);
    if (summary.interrupted) {
        say("umbrage: interrupted; frames still to render: --frames {}\n", FrameRange::textOf(summary.missing));
        return interruptSignal == SIGTERM ? kTerminated : kInterrupted;
    }
    return done == summary.requested ? kOk : kFramesFailed;
}

}  // namespace umbrage
